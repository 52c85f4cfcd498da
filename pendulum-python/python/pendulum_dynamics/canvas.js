// Paints the shapes of a mechanism on a canvas, as the crate pendulum-draw does, within bounds [left, right, low, high]
// in m. The canvas has `ratio` pixels for each one of the page. Its colour is that of ground; where it is light, as on a
// dark page, colours of bodies are lighter, too.
export default function painter(canvas, shapes, bounds, ratio = 1) {
  const context = canvas.getContext("2d");
  context.setTransform(ratio, 0, 0, ratio, 0, 0);
  const [width, height] = [canvas.width / ratio, canvas.height / ratio];
  const ground = getComputedStyle(canvas).color || "#5f5f5f";
  const isDark = Number(/\d+/.exec(ground)?.[0]) > 127;
  const lighter = (colour) => `rgb(${colour.map((own) => (isDark ? own + 0.35 * (255 - own) : own)).join(" ")})`;
  const colours = [[0, 114, 178], [213, 94, 0], [0, 158, 115], [204, 121, 167], [230, 159, 0], [86, 180, 233]].map(lighter);
  const bodies = [...new Set(shapes.map((shape) => shape.body))].filter((body) => body !== "ground");
  const colour = (body) => (body === "ground" ? ground : colours[bodies.indexOf(body) % colours.length]);
  const [left, right, low, high] = bounds;
  const size = Math.max(right - left, high - low, 1e-9) * 1.1;
  const scale = Math.min(width, height) / size;
  const x = (value) => width / 2 + (value - (left + right) / 2) * scale;
  const y = (value) => height / 2 - (value - (low + high) / 2) * scale;

  // of points on the canvas, [[x, y], ..]
  const path = (points) => {
    context.beginPath();
    for (const [px, py] of points) context.lineTo(px, py);
  };
  const line = (points, thick) => {
    context.lineWidth = thick;
    path(points);
    context.stroke();
  };
  const area = (points) => {
    path(points);
    context.fill();
  };
  const dot = ([px, py], radius) => {
    context.beginPath();
    context.arc(px, py, radius, 0, 2 * Math.PI);
    context.fill();
  };
  // Convex hull (Andrew 1979).
  const hull = (points) => {
    const sorted = [...points].sort((a, b) => a[0] - b[0] || a[1] - b[1]);
    const half = (some) => {
      const chain = [];
      const turn = ([ax, ay], [bx, by], [px, py]) => (bx - ax) * (py - ay) - (by - ay) * (px - ax);
      for (const p of some) {
        while (chain.length > 1 && turn(chain.at(-2), chain.at(-1), p) <= 0) chain.pop();
        chain.push(p);
      }
      return chain.slice(0, -1);
    };
    return [...half(sorted), ...half(sorted.reverse())];
  };
  // Place at `length` along the way from one point to another, and `side` to its left.
  const along = ([ax, ay], [bx, by]) => {
    const length = Math.hypot(bx - ax, by - ay) || 1;
    const [dx, dy] = [(bx - ax) / length, (by - ay) / length];
    return { length, at: (ahead, side) => [ax + ahead * dx + side * dy, ay + ahead * dy - side * dx] };
  };
  // A surface, with strokes on the right-hand side of the way along it.
  const surface = (from, to) => {
    const { length, at } = along(from, to);
    line([from, to], 1.5);
    context.globalAlpha *= 0.7;
    context.lineWidth = 1;
    context.beginPath();
    for (let end = 5; end <= length; end += 5) {
      context.moveTo(...at(end, 0));
      context.lineTo(...at(end - 5, -5));
    }
    context.stroke();
    context.globalAlpha /= 0.7;
  };
  // A flat wall through a point, across the canvas if it is seen from its side, or else near the point.
  const wall = ([foot, off]) => {
    const [nx, ny] = [(off[0] - foot[0]) / scale, (off[1] - foot[1]) / scale];
    const seen = Math.hypot(nx, ny);
    if (seen < 0.05) return;
    const [dx, dy] = [-ny / seen, nx / seen];
    // strokes of walls in one plane coincide, and stay where they are as the point moves
    const reach = seen > 0.999 ? 5 * Math.ceil((width + height) / 5) : 40;
    const shift = seen > 0.999 ? (foot[0] * dx + foot[1] * dy) % 5 : 0;
    const at = (by) => [foot[0] + (by - shift) * dx, foot[1] + (by - shift) * dy];
    surface(at(-reach), at(reach));
  };
  const support = ([px, py]) => {
    context.strokeStyle = ground;
    line([[px, py], [px - 5, py + 9], [px + 5, py + 9], [px, py]], 1.2);
    surface([px - 8, py + 9], [px + 8, py + 9]);
  };
  const pivot = (p) => {
    context.fillStyle = ground;
    dot(p, 3.5);
    context.fillStyle = "#fff";
    dot(p, 1.5);
  };
  const link = (draw) => ([from, to], _, k, frame) => {
    // a spring and a damper between the same points stand side by side
    const isBeside = frame.some(([points], n) => LINKS.has(shapes[n].kind) && shapes[n].kind !== shapes[k].kind && String(points) === String(frame[k][0]));
    const side = !isBeside ? 0 : shapes[k].kind === "Spring" ? 8 : -8;
    context.strokeStyle = ground;
    const { length, at } = along(from, to);
    if (side !== 0) [[from, at(0, side)], [to, at(length, side)]].forEach((ends) => line(ends, 1.5));
    draw(length, (ahead, by) => at(ahead, by + side));
  };
  const spring = (length, at) => {
    const straight = Math.min(6, 0.15 * length);
    const pitch = (length - 2 * straight) / COILS;
    const zigzag = Array.from({ length: 2 * COILS }, (_, n) => at(straight + (n / 2 + 0.25) * pitch, n % 2 ? -4.5 : 4.5));
    line([at(0, 0), at(straight, 0), ...zigzag, at(length - straight, 0), at(length, 0)], 1.5);
  };
  const damper = (length, at) => {
    const [middle, deep] = [length / 2, Math.min(12, 0.3 * length) / 2];
    line([at(0, 0), at(middle, 0)], 1.5);
    line([at(middle, 3.2), at(middle, -3.2)], 1.5);
    line([at(middle - deep, 4.5), at(middle + deep, 4.5), at(middle + deep, -4.5), at(middle - deep, -4.5)], 1.5);
    line([at(middle + deep, 0), at(length, 0)], 1.5);
  };
  const COILS = 10;
  const EDGES = [[0, 1], [1, 3], [3, 2], [2, 0], [4, 5], [5, 7], [7, 6], [6, 4], [0, 4], [1, 5], [2, 6], [3, 7]];
  const LINKS = new Set(["Spring", "Damper"]);
  // in the order in which they cover each other; of a shape, its points on the canvas and its radius in m
  const layers = [
    {
      Wall: (p) => wall(p),
      Guide: ([from, to]) => {
        const { at } = along(from, to);
        context.strokeStyle = ground;
        context.globalAlpha *= 0.5;
        if (Math.hypot(to[0] - from[0], to[1] - from[1]) > 1e-3 * scale) line([at(-width - height, 0), at(width + height, 0)], 1.5);
      },
    },
    {
      Plate: area,
      Cuboid: (p) => {
        area(hull(p));
        context.strokeStyle = "#fff8";
        for (const [from, to] of EDGES) line([p[from], p[to]], 1);
      },
      Cylinder: (p, r) => line(p, Math.max(3, 2 * r * scale)),
      Sphere: ([p], r) => dot(p, Math.max(3, r * scale)),
      Disk: (p, r) => {
        dot(p[0], Math.max(3, r * scale));
        context.strokeStyle = "#fff";
        line(p, 1.5);
      },
    },
    { Support: ([p]) => support(p), Anchor: ([p]) => support(p) },
    { Rod: (p) => line(p, 5) },
    { Mass: (p) => { line(p, 2); dot(p[0], 6); } },
    { Spring: link(spring), Damper: link(damper) },
    { Pivot: ([p]) => pivot(p), Point: ([p]) => { context.fillStyle = ground; dot(p, 2); } },
    { Support: ([p]) => pivot(p) },
  ];
  const placed = ([points, radius]) => [Array.from({ length: points.length / 2 }, (_, n) => [x(points[2 * n]), y(points[2 * n + 1])]), radius];
  // of each shape, its points on the screen in m, and its radius
  const paint = (frame, alpha = 1) => {
    const all = frame.map(placed);
    for (const layer of layers) {
      all.forEach(([points, radius], k) => {
        const { kind, body } = shapes[k];
        if (!layer[kind]) return;
        context.strokeStyle = context.fillStyle = colour(body);
        context.globalAlpha = alpha;
        layer[kind](points, radius, k, all);
      });
    }
    context.globalAlpha = 1;
  };
  // A scale on the left, and a text on the right.
  const write = (text) => {
    // nothing fits a canvas that is not laid out
    if (!(width > 0)) return;
    context.fillStyle = context.strokeStyle = ground;
    context.font = "13px sans-serif";
    const most = (0.25 * width) / scale;
    const power = 10 ** Math.floor(Math.log10(most));
    const length = ([5, 2].find((n) => n * power <= most) ?? 1) * power;
    const [, unit, name] = [[1000, 1000, "km"], [0.1, 1, "m"], [0.01, 0.01, "cm"], [0, 0.001, "mm"]].find(([least]) => length >= 0.999 * least);
    const [from, to, base] = [12, 12 + length * scale, height - 14];
    for (const ends of [[[from, base], [to, base]], [[from, base - 3], [from, base + 3]], [[to, base - 3], [to, base + 3]]]) line(ends, 1.2);
    context.textAlign = "left";
    context.fillText(`${Number((length / unit).toPrecision(3))} ${name}`, to + 6, base + 4);
    context.textAlign = "right";
    context.fillText(text, width - 12, base + 4);
  };
  const clear = () => context.clearRect(0, 0, width, height);
  return { paint, write, clear, colour, x, y, scale };
}
// Shapes that go on across the canvas, and beyond.
painter.endless = new Set(["Guide", "Wall"]);
