// The mechanism on its canvas: from three dimensions to two, trails, companions, and dragging.
import painter from "../../pendulum-python/python/pendulum_dynamics/canvas.js";
import { Density } from "./density.js";

/** Directions of the screen: of flat mechanisms along x and y, of others from in front, to the right and above. */
const FLAT = [[1, 0, 0], [0, 1, 0]];
const SPATIAL = (() => {
  const unit = (v) => v.map((own) => own / Math.hypot(...v));
  const cross = ([a, b, c], [d, e, f]) => [b * f - c * e, c * d - a * f, a * e - b * d];
  const towards = [3, -4, 2];
  const right = cross([0, 0, 1], towards);
  return [unit(right), unit(cross(towards, right))];
})();

const hasEnds = ({ kind }) => !painter.endless.has(kind);

/** Number of paths of points that are drawn. */
const TRAILS = 6;
/** Frames that a path shows, and those of them that are drawn as one line. */
const [LENGTH, AT_ONCE] = [240, 15];

export class View {
  constructor(canvas, { onDrag, onDrop }) {
    this.canvas = canvas;
    this.shapes = [];
    this.held = null;
    this.density = new Density();
    const at = (event) => {
      const box = canvas.getBoundingClientRect();
      return [event.clientX - box.left, event.clientY - box.top];
    };
    canvas.addEventListener("pointerdown", (event) => {
      this.held = this.nearest(at(event));
      if (!this.held) return;
      canvas.setPointerCapture(event.pointerId);
      event.preventDefault();
      canvas.focus();
    });
    canvas.addEventListener("pointermove", (event) => {
      if (this.held) onDrag({ ...this.held, to: this.place(at(event)), view: this.view });
    });
    // the page scrolls under a finger that holds no body
    canvas.addEventListener("touchstart", (event) => this.held && event.preventDefault(), { passive: false });
    const drop = () => {
      if (this.held) onDrop();
      this.held = null;
    };
    canvas.addEventListener("pointerup", drop);
    canvas.addEventListener("pointercancel", drop);
  }

  /** Takes the shapes of another mechanism. */
  take(shapes, frames) {
    this.shapes = shapes;
    this.bounds = this.held = null;
    this.radius = 0;
    this.view = FLAT;
    const depths = frames.flatMap((frame) => this.points(frame).map((point) => point[2]));
    const [near, far] = [Math.min(...depths), Math.max(...depths)];
    if (depths.length > 0 && far - near > 1e-9 * Math.max(1e-9, Math.abs(far), Math.abs(near))) this.view = SPATIAL;
    frames.forEach((frame) => this.widen(frame));
  }

  /** Points in space of all shapes that have ends. */
  points(numbers) {
    const points = [];
    let place = 0;
    for (const shape of this.shapes) {
      for (let n = 0; n < shape.points; n++, place += 3) {
        if (hasEnds(shape)) points.push([numbers[place], numbers[place + 1], numbers[place + 2]]);
      }
      place += 1;
    }
    return points;
  }

  /** Place on the screen in m of the point whose coordinates begin at a place among numbers. */
  flatPoint(numbers, place) {
    const [[a, b, c], [d, e, f]] = this.view;
    const [x, y, z] = [numbers[place], numbers[place + 1], numbers[place + 2]];
    return [a * x + b * y + c * z, d * x + e * y + f * z];
  }

  /** Points on the screen in m and radius of each shape. */
  flat(numbers) {
    let place = 0;
    return this.shapes.map((shape) => {
      const points = [];
      for (let n = 0; n < shape.points; n++, place += 3) points.push(...this.flatPoint(numbers, place));
      return [points, numbers[place++]];
    });
  }

  /**
   * Widens the bounds to all that was seen: a square about the supports, or about a mechanism that flies freely, which it
   * follows, or else all places.
   */
  widen(numbers) {
    const kinds = this.shapes.map(({ kind }) => kind);
    const flat = this.flat(numbers);
    const places = ([points, radius]) => Array.from({ length: points.length / 2 }, (_, k) => [points[2 * k], points[2 * k + 1], radius]);
    const all = flat.filter((_, n) => hasEnds(this.shapes[n])).flatMap(places);
    if (all.length === 0) return;
    const supports = flat.filter((_, n) => kinds[n] === "Support").flatMap(places);
    const isFree = this.shapes.every(({ moves, kind }) => moves || kind === "Wall");
    const about = kinds.includes("Guide") || (supports.length === 0 && !isFree) ? null : supports.length > 0 ? supports : all;
    if (about) {
      const middle = (k) => about.reduce((sum, place) => sum + place[k], 0) / about.length;
      const [x, y] = [middle(0), middle(1)];
      this.radius = Math.max(this.radius, ...all.map((place) => Math.hypot(place[0] - x, place[1] - y) + place[2]));
      this.bounds = [x - this.radius, x + this.radius, y - this.radius, y + this.radius];
      return;
    }
    let [left, right, low, high] = this.bounds ?? [Infinity, -Infinity, Infinity, -Infinity];
    for (const [x, y, radius] of all) {
      [left, right] = [Math.min(left, x - radius), Math.max(right, x + radius)];
      [low, high] = [Math.min(low, y - radius), Math.max(high, y + radius)];
    }
    this.bounds = [left, right, low, high];
  }

  /** The shape and its point nearest to a place on the canvas, if one is near. */
  nearest([px, py]) {
    if (!this.on || !this.last) return null;
    let [best, found] = [40, null];
    this.flat(this.last).forEach(([points], shape) => {
      if (!this.shapes[shape].moves) return;
      for (let k = 0; k < points.length; k += 2) {
        const away = Math.hypot(this.on.x(points[k]) - px, this.on.y(points[k + 1]) - py);
        if (away < best) [best, found] = [away, { shape, point: k / 2 }];
      }
    });
    return found;
  }

  /** Place in m of a place on the canvas. */
  place([px, py]) {
    const { x, y, scale } = this.on;
    return [(px - x(0)) / scale, (y(0) - py) / scale];
  }

  /** Draws a frame, with the paths of its points. */
  draw(frame, past, { trail, text }) {
    const { canvas } = this;
    const ratio = Math.min(window.devicePixelRatio || 1, 2);
    const [width, height] = [Math.round(canvas.clientWidth * ratio), Math.round(canvas.clientHeight * ratio)];
    if (canvas.width !== width || canvas.height !== height) [canvas.width, canvas.height] = [width, height];
    this.last = frame.shapes;
    this.widen(frame.shapes);
    this.on = painter(canvas, this.shapes, this.bounds ?? [-1, 1, -1, 1], ratio);
    this.on.clear();
    if (frame.crowd?.length > 0) this.drawCrowd(frame.crowd, ratio);
    if (trail) this.traced().forEach((place) => this.drawTrail(past, place));
    if (frame.twin) this.on.paint(this.flat(frame.twin.shapes), 0.4);
    this.on.paint(this.flat(frame.shapes));
    this.on.write(text);
  }

  /** Numbers of the shapes, and of their points, whose paths are drawn: the declared points, or else a tip. */
  traced() {
    const named = this.shapes.flatMap(({ kind }, shape) => (kind === "Point" ? [[shape, 0]] : []));
    if (named.length > 0) return named.slice(-TRAILS);
    const shape = this.shapes.findLastIndex(({ moves, kind }) => moves && kind !== "Pivot");
    return shape < 0 ? [] : [[shape, this.shapes[shape].kind === "Rod" ? 1 : 0]];
  }

  drawTrail(past, [shape, point]) {
    const context = this.canvas.getContext("2d");
    const before = this.shapes.slice(0, shape).reduce((sum, own) => sum + 3 * own.points + 1, 0);
    context.lineWidth = 1.2;
    context.strokeStyle = this.on.colour(this.shapes[shape].body);
    const shown = past.slice(-LENGTH).map(({ shapes }) => this.flatPoint(shapes, before + 3 * point));
    // strokes take most of the time
    for (let from = 0; from < shown.length - 1; from += AT_ONCE) {
      context.globalAlpha = 0.7 * Math.min(1, (from + AT_ONCE) / shown.length);
      context.beginPath();
      for (const [x, y] of shown.slice(from, from + AT_ONCE + 1)) context.lineTo(this.on.x(x), this.on.y(y));
      context.stroke();
    }
    context.globalAlpha = 1;
  }

  /** Draws the lines of many mechanisms. */
  drawCrowd(lines, ratio) {
    const { x, y, scale } = this.on;
    const [right, up] = this.view;
    this.density.paint(this.canvas.getContext("2d"), lines, {
      x: [ratio * x(0), ...right.map((own) => ratio * scale * own)],
      y: [ratio * y(0), ...up.map((own) => -ratio * scale * own)],
      colour: this.on.colour(this.shapes.find(({ moves }) => moves)?.body).match(/[\d.]+/g).map(Number),
    });
  }
}
