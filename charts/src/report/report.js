// Charts of a report, drawn from the data in the page. Hovering, a tap and the arrow keys show the values of a point.

const FONT = "12px system-ui, sans-serif";
/** Largest distance from the pointer at which a point shows its values, in pixels. */
const REACH = 40;
/** Pixels of the screen per pixel of the picture in which the widths of lines are given. */
const SCALE = 0.55;
/** Opacity of the curves behind the chosen one. */
const BEHIND = 0.2;
/** Grey of text on white in the data: the ink of the charts. */
const INK = 34;
/** Part by which colours are mixed with white in the dark. */
const LIGHTENED = 0.35;
/** Places of a label beside its point: shifts to the right and down in pixels, and alignment. */
const BESIDE = [
  [8, 4, "left"],
  [0, -9, "center"],
  [-8, 4, "right"],
  [0, 18, "center"],
];

const dark = matchMedia("(prefers-color-scheme: dark)");
const said = document.getElementById("said");

/** An element of the page, with properties and children. */
function element(tag, properties = {}, ...children) {
  const made = Object.assign(document.createElement(tag), properties);
  made.append(...children);
  return made;
}

/** A number in four digits or all before the point, as the axes write it; others as multiples of powers of ten. */
function digits(value) {
  const [factor, power] = value.toExponential(3).split("e").map(Number);
  const plain = () => (power < 4 ? String(Number(value.toPrecision(4))) : String(Math.round(value)));
  const superscript = () => [...String(power)].map((own) => (own === "-" ? "⁻" : "⁰¹²³⁴⁵⁶⁷⁸⁹"[own])).join("");
  const text = value === 0 || (power >= -3 && power < 6) ? plain() : `${factor === 1 ? "" : `${factor} · `}10${superscript()}`;
  return text.replace("-", "−");
}

/** Number that stands at a place of an axis, as text. */
function number({ scale }, place) {
  if (Number.isNaN(place)) return "none";
  if (!Number.isFinite(place)) return place > 0 ? "∞" : "−∞";
  return digits(scale === "linear" ? place : 10 ** (scale === "falling" ? -place : place));
}

// colours

const rgb = (color) => [1, 3, 5].map((from) => parseInt(color.slice(from, from + 2), 16));
const mixed = (a, b, part) => `rgb(${a.map((own, n) => Math.round(own + part * (b[n] - own))).join(" ")})`;

/** A colour of the page, such as `ink`. */
function ofPage(name) {
  const color = getComputedStyle(document.documentElement).getPropertyValue(`--${name}`).trim();
  return color.length > 4 ? color : color.replace(/[^#]/g, "$&$&");
}

/** A colour of the data, which is for a white page, on this one: greys lie between its card and its ink. */
function onPage(color) {
  const [r, g, b] = rgb(color);
  if (r === g && g === b) return mixed(rgb(ofPage("card")), rgb(ofPage("ink")), (255 - r) / (255 - INK));
  return dark.matches ? mixed([r, g, b], [255, 255, 255], LIGHTENED) : color;
}

// drawing

/** Sets the size of a canvas to that on the screen, and returns its context, in pixels of the page. */
function blank(canvas, width, height) {
  const ratio = Math.min(window.devicePixelRatio || 1, 3);
  [canvas.width, canvas.height] = [Math.round(width * ratio), Math.round(height * ratio)];
  const context = canvas.getContext("2d");
  context.scale(ratio, ratio);
  context.font = FONT;
  return context;
}

/** Draws a line with its marks through places on a canvas, where null interrupts it. */
function trace(context, { width, stroke, marker }, color, places) {
  context.strokeStyle = context.fillStyle = color;
  context.lineWidth = width * SCALE;
  context.lineJoin = "round";
  if (stroke === "dots") {
    const side = Math.max(1.4, width * SCALE);
    context.beginPath();
    for (const place of places) if (place) context.rect(place[0] - side / 2, place[1] - side / 2, side, side);
    return context.fill();
  }
  context.setLineDash(stroke === "dashed" ? [7, 4] : []);
  context.beginPath();
  places.forEach((place, n) => place && (places[n - 1] ? context.lineTo(...place) : context.moveTo(...place)));
  stroke === "area" ? context.fill() : context.stroke();
  context.setLineDash([]);
  if (!marker) return;
  const size = 2.2 * width * SCALE;
  for (const place of places) {
    if (!place) continue;
    context.beginPath();
    for (const [x, y] of marker) context.lineTo(place[0] + size * x, place[1] + size * y);
    context.fill();
  }
}

/** The symbol of a line in a legend. */
function symbol(line) {
  const canvas = element("canvas", { className: "symbol" });
  const draw = () => {
    const context = blank(canvas, 30, 14);
    const places = { area: [[3, 1], [27, 1], [27, 13], [3, 13]], dots: [[15, 7]] }[line.stroke] ?? [[1, 7], [29, 7]];
    const width = line.stroke === "dots" ? 12 : line.width;
    trace(context, { ...line, width, marker: null }, onPage(line.color), places);
    if (line.marker) trace(context, { ...line, width, stroke: "solid" }, onPage(line.color), [[15, 7]]);
  };
  draw();
  return { canvas, draw };
}

/** Numbers of an axis that fit beside one another: every, every second, and so on. */
function fitting({ ticks, range }, length, room) {
  const spacing = ticks.length > 1 ? (Math.abs(ticks[1][0] - ticks[0][0]) / (range[1] - range[0])) * length : length;
  const every = Math.max(1, Math.ceil(room / spacing));
  return ticks.filter((_, n) => n % every === 0);
}

/** One pair of axes with its curves, or with a map of coloured cells. */
class Panel {
  constructor(chart, data) {
    Object.assign(this, { chart, data, chosen: null });
    if (data.map) this.numbers = new Float32Array(Uint8Array.from(atob(data.map.cells), (byte) => byte.charCodeAt(0)).buffer);
    this.canvas = element("canvas", { tabIndex: 0 });
    this.canvas.setAttribute("role", "application");
    this.canvas.setAttribute("aria-roledescription", "chart");
    const keys = data.map ? "Arrow keys step from cell to cell, with Shift by ten." : "Left and right step along a curve, up and down from curve to curve.";
    this.canvas.setAttribute("aria-label", `${data.title || chart.title}. ${keys}`);
    this.mark = element("div", { className: data.map ? "mark cell" : "mark", hidden: true });
    this.values = element("div", { className: "values", hidden: true });
    const title = data.title ? [element("h3", { textContent: data.title })] : [];
    this.box = element("div", { className: "panel" }, ...title, this.canvas, this.mark, this.values);
    this.listen();
  }

  listen() {
    const { canvas } = this;
    const at = ({ clientX, clientY }) => {
      const box = canvas.getBoundingClientRect();
      return [clientX - box.left, clientY - box.top];
    };
    canvas.onpointermove = (event) => this.choose(this.nearest(at(event)));
    canvas.onpointerdown = (event) => this.choose(this.nearest(at(event)), { aloud: true });
    // what a finger has chosen stays when it is lifted
    canvas.onpointerleave = (event) => event.pointerType === "mouse" && this.choose(null);
    canvas.onblur = () => this.choose(null);
    canvas.onkeydown = (event) => {
      const by = { ArrowRight: [1, 0], ArrowLeft: [-1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1] }[event.key];
      if (event.key === "Escape") this.choose(null);
      if (!by || event.ctrlKey || event.altKey || event.metaKey) return;
      event.preventDefault();
      this.choose(this.data.map ? this.cellBeyond(by, event.shiftKey ? 10 : 1) : this.pointBeyond(by), { aloud: true });
    };
  }

  // places

  /** Takes the width on the screen: places the plot on the canvas, in pixels. */
  fit() {
    const width = this.canvas.clientWidth;
    if (width === this.width) return;
    this.width = width;
    const [left, top] = [58, 8];
    const right = width - (this.data.map ? 72 : 12);
    this.frame = { left, right, top, bottom: top + (right - left) * this.data.aspect };
    this.places = new Map(this.data.curves.map((curve) => [curve, curve.points.map((point) => this.place(point))]));
  }

  /** Pixel of a point; null if it is not finite. */
  place([x, y]) {
    if (x === null || y === null) return null;
    const part = (value, [start, end]) => (value - start) / (end - start);
    const { left, right, top, bottom } = this.frame;
    return [left + (right - left) * part(x, this.data.x.range), bottom - (bottom - top) * part(y, this.data.y.range)];
  }

  isInside([x, y]) {
    const { left, right, top, bottom } = this.frame;
    return x >= left - 0.5 && x <= right + 0.5 && y >= top - 0.5 && y <= bottom + 0.5;
  }

  /** Curves that show values, with the pixels of their points in the plot. */
  get curves() {
    const shows = (curve) => {
      const { stroke, marker } = this.chart.lines[curve.line];
      return this.chart.isShown(curve) && stroke !== "area" && (curve.points.length > 1 || marker);
    };
    const inside = (place) => (place && this.isInside(place) ? place : null);
    return this.data.curves.filter(shows).map((curve) => ({ curve, places: this.places.get(curve).map(inside) }));
  }

  /** The cell at a place, or the nearest point of a curve. */
  nearest([x, y]) {
    if (!this.isInside([x, y])) return null;
    if (this.data.map) {
      const [across, down] = this.cells;
      const { left, right, top, bottom } = this.frame;
      const cell = (part, count) => Math.max(0, Math.min(count - 1, Math.floor(part * count)));
      return { column: cell((x - left) / (right - left), across), row: cell((bottom - y) / (bottom - top), down) };
    }
    let [best, found] = [REACH, null];
    for (const { curve, places } of this.curves) {
      places.forEach((place, n) => {
        const away = place ? Math.hypot(place[0] - x, place[1] - y) : Infinity;
        if (away < best) [best, found] = [away, { curve, n }];
      });
    }
    return found;
  }

  /** Numbers of cells in each direction. */
  get cells() {
    const { across } = this.data.map;
    return [across, this.numbers.length / across];
  }

  /** The cell some steps from the chosen one; at first one in the middle. */
  cellBeyond(by, steps) {
    const step = (now, count, k) => (now === undefined ? count >> 1 : Math.max(0, Math.min(count - 1, now + steps * by[k])));
    const [across, down] = this.cells;
    return { column: step(this.chosen?.column, across, 0), row: step(this.chosen?.row, down, 1) };
  }

  /** The next point of the chosen curve, or the nearest one of the next curve. */
  pointBeyond([along, over]) {
    const inside = this.curves.filter(({ places }) => places.some(Boolean));
    if (inside.length === 0) return null;
    const at = inside.findIndex(({ curve }) => curve === this.chosen?.curve);
    if (at < 0) return { curve: inside[0].curve, n: inside[0].places.findIndex(Boolean) };
    const { curve, places } = inside[at];
    let { n } = this.chosen;
    if (along) {
      do n += along;
      while (n >= 0 && n < places.length && !places[n]);
      return places[n] ? { curve, n } : this.chosen;
    }
    const next = inside[(at + over + inside.length) % inside.length];
    const away = next.places.map((place) => (place ? Math.abs(place[0] - places[n][0]) : Infinity));
    return { curve: next.curve, n: away.indexOf(Math.min(...away)) };
  }

  // values

  /** Chooses a point or a cell, or nothing: lifts the curve out, and shows the values. */
  choose(chosen, { aloud = false } = {}) {
    const lifted = this.chosen?.curve;
    this.chosen = chosen;
    if (lifted !== chosen?.curve) this.draw();
    this.mark.hidden = this.values.hidden = !chosen;
    if (!chosen) return;
    const { name, rows, note } = this.described();
    const line = chosen.curve && symbol(this.chart.lines[chosen.curve.line]).canvas;
    this.values.replaceChildren(
      ...(name ? [element("strong", {}, ...(line ? [line] : []), name)] : []),
      element("dl", {}, ...rows.flatMap(([label, text]) => [element("dt", { textContent: label }), element("dd", { textContent: text })])),
      ...(note ? [note] : []),
    );
    if (aloud) said.textContent = [name, ...rows.map((row) => row.join(" ")), note].filter(Boolean).join("; ");
    this.showAt();
  }

  /** Name, values with their labels, and note of the choice. */
  described() {
    const { x, y, map } = this.data;
    if (map) {
      const [column, row] = [this.chosen.column, this.chosen.row];
      const middle = ({ range: [start, end] }, n, count) => start + ((end - start) * (n + 0.5)) / count;
      const [across, down] = this.cells;
      const value = this.numbers[row * across + column];
      return { rows: [[map.axis.label, number(map.axis, value)], [x.label, number(x, middle(x, column, across))], [y.label, number(y, middle(y, row, down))]] };
    }
    const { curve, n } = this.chosen;
    const point = curve.points[n];
    return { name: curve.name, rows: [[x.label, number(x, point[0])], [y.label, number(y, point[1])]], note: curve.notes[n] };
  }

  /** Puts the mark on the choice, and the values beside it, inside of the panel. */
  showAt() {
    const { box, canvas, chosen, mark, values } = this;
    const [dx, dy] = [canvas.offsetLeft, canvas.offsetTop];
    let place;
    if (this.data.map) {
      const [across, down] = this.cells;
      const { left, right, top, bottom } = this.frame;
      place = [left + ((right - left) * (chosen.column + 0.5)) / across, bottom - ((bottom - top) * (chosen.row + 0.5)) / down];
    } else place = this.places.get(chosen.curve)[chosen.n];
    const [x, y] = [place[0] + dx, place[1] + dy];
    Object.assign(mark.style, { left: `${x}px`, top: `${y}px` });
    Object.assign(values.style, { left: 0, top: 0 });
    const [wide, high] = [values.offsetWidth, values.offsetHeight];
    const beside = x + 14 + wide <= box.clientWidth ? x + 14 : x - 14 - wide;
    const left = Math.max(0, Math.min(beside, box.clientWidth - wide));
    const above = y - 14 - high;
    Object.assign(values.style, { left: `${left}px`, top: `${above > -dy ? above : y + 18}px` });
  }

  // drawing

  /** Draws the panel anew in its size; of its curves, the lifted ones are in front of the others. */
  draw(isLifted = this.chosen?.curve && ((curve) => curve === this.chosen.curve)) {
    this.fit();
    const { canvas, chart, data, frame } = this;
    canvas.style.height = `${frame.bottom + 44}px`;
    const context = blank(canvas, canvas.clientWidth, frame.bottom + 44);
    this.drawAxes(context);
    context.save();
    context.beginPath();
    context.rect(frame.left, frame.top, frame.right - frame.left, frame.bottom - frame.top);
    context.clip();
    if (data.map) this.drawCells(context);
    const front = (curve) => !isLifted || isLifted(curve);
    const shown = data.curves.filter((curve) => chart.isShown(curve));
    const isArea = (curve) => chart.lines[curve.line].stroke === "area";
    for (const curve of [...shown.filter((own) => !front(own)), ...shown.filter(front)]) {
      const line = chart.lines[curve.line];
      context.globalAlpha = front(curve) || isArea(curve) ? 1 : BEHIND;
      trace(context, line, data.map ? line.color : onPage(line.color), this.places.get(curve));
    }
    context.globalAlpha = 1;
    this.drawLabels(context, shown.filter(({ label, points }) => label && points.length === 1));
    context.restore();
    if (data.map) this.drawBar(context);
    if (this.chosen) this.showAt();
  }

  drawAxes(context) {
    const { x, y } = this.data;
    const { left, right, top, bottom } = this.frame;
    context.fillStyle = ofPage("ink");
    context.strokeStyle = ofPage("edge");
    context.lineWidth = 1;
    const px = (value) => this.place([value, y.range[0]])[0];
    const py = (value) => this.place([x.range[0], value])[1];
    const line = (...ends) => {
      context.beginPath();
      context.moveTo(ends[0], ends[1]);
      context.lineTo(ends[2], ends[3]);
      context.stroke();
    };
    context.globalAlpha = 0.6;
    for (const [value] of this.data.map ? [] : x.ticks) line(px(value), top, px(value), bottom);
    for (const [value] of this.data.map ? [] : y.ticks) line(left, py(value), right, py(value));
    context.globalAlpha = 1;
    context.strokeRect(left, top, right - left, bottom - top);
    const widest = Math.max(...x.ticks.map(([, text]) => context.measureText(text).width));
    context.textAlign = "center";
    for (const [value, text] of fitting(x, right - left, widest + 8)) context.fillText(text, px(value), bottom + 16);
    context.fillText(x.label, (left + right) / 2, bottom + 36);
    context.textAlign = "right";
    for (const [value, text] of fitting(y, bottom - top, 18)) context.fillText(text, left - 6, py(value) + 4);
    context.save();
    context.translate(12, (top + bottom) / 2);
    context.rotate(-Math.PI / 2);
    context.textAlign = "center";
    context.fillText(y.label, 0, 0);
    context.restore();
  }

  drawCells(context) {
    const { map } = this.data;
    const [across, down] = this.cells;
    const { left, right, top, bottom } = this.frame;
    this.image ??= this.painted(across, down);
    context.imageSmoothingEnabled = false;
    context.drawImage(this.image, left, top, right - left, bottom - top);
  }

  /** A canvas with one pixel for each cell. */
  painted(across, down) {
    const { axis, colors, missing } = this.data.map;
    const [least, most] = axis.range;
    const canvas = element("canvas", { width: across, height: down });
    const context = canvas.getContext("2d");
    const image = context.createImageData(across, down);
    const [table, none] = [colors.map(rgb), rgb(missing)];
    this.numbers.forEach((value, n) => {
      const step = Math.floor(((value - least) / (most - least)) * colors.length);
      const color = Number.isNaN(value) ? none : table[Math.max(0, Math.min(colors.length - 1, step))];
      const from = 4 * ((down - 1 - Math.floor(n / across)) * across + (n % across));
      image.data.set([...color, 255], from);
    });
    context.putImageData(image, 0, 0);
    return canvas;
  }

  /** Draws the bar with the numbers of the colours. */
  drawBar(context) {
    const { axis, colors } = this.data.map;
    const { right, top, bottom } = this.frame;
    const height = (bottom - top) / colors.length;
    colors.forEach((color, n) => {
      context.fillStyle = color;
      context.fillRect(right + 14, bottom - (n + 1) * height, 14, height + 0.5);
    });
    context.fillStyle = ofPage("ink");
    context.textAlign = "left";
    const y = (value) => bottom - ((bottom - top) * (value - axis.range[0])) / (axis.range[1] - axis.range[0]);
    for (const [value, text] of fitting(axis, bottom - top, 18)) context.fillText(text, right + 33, y(value) + 4);
  }

  /** Writes labels beside their points where there is place, each at most once. */
  drawLabels(context, curves) {
    const taken = [];
    const { left, right, top, bottom } = this.frame;
    for (const curve of curves) {
      const [place] = this.places.get(curve);
      if (!place || !this.isInside(place)) continue;
      const wide = context.measureText(curve.label).width;
      // text alone lies above the curve that it describes
      const first = this.chart.lines[curve.line].marker ? [] : [BESIDE[1]];
      for (const [dx, dy, align] of [...first, ...BESIDE]) {
        const [x, y] = [place[0] + dx, place[1] + dy];
        const from = x - { left: 0, center: wide / 2, right: wide }[align];
        const own = [from - 2, y - 12, from + wide + 2, y + 4];
        const isOver = (other) => own[0] < other[2] && other[0] < own[2] && own[1] < other[3] && other[1] < own[3];
        if (own[0] < left || own[2] > right || own[1] < top || own[3] > bottom || taken.some(isOver)) continue;
        taken.push(own);
        context.textAlign = align;
        context.lineWidth = 4;
        context.strokeStyle = ofPage("card");
        context.strokeText(curve.label, x, y);
        context.fillStyle = onPage(this.chart.lines[curve.line].color);
        context.fillText(curve.label, x, y);
        break;
      }
    }
  }
}

/** A chart: its legend, whose entries show and hide curves, and its panels. */
class Chart {
  constructor(section, { columns, legend, lines, panels }) {
    Object.assign(this, { lines, hidden: new Set() });
    this.title = section.querySelector("h2").textContent;
    this.panels = panels.map((data) => new Panel(this, data));
    this.symbols = legend.map(({ line }) => symbol(lines[line]));
    const entries = legend.map(({ name, curves }, n) => element("li", {}, curves ? this.entry(name, n) : element("span", {}, this.symbols[n].canvas, name)));
    if (legend.length > 0) section.append(element("ul", { className: "legend" }, ...entries));
    const place = element("div", { className: "panels" }, ...this.panels.map(({ box }) => box));
    place.style.setProperty("--columns", columns);
    section.append(place);
    // drawn in a frame of its own: the height follows the width, and must not change while sizes are reported
    new ResizeObserver(([{ contentRect }]) => {
      if (this.width === contentRect.width) return;
      this.width = contentRect.width;
      requestAnimationFrame(() => this.draw());
    }).observe(place);
    dark.addEventListener("change", () => this.draw());
  }

  isShown({ entry }) {
    return !this.hidden.has(entry);
  }

  /** A button that hides the curves of an entry and shows them again; under the pointer, it lifts them out. */
  entry(name, n) {
    const button = element("button", { title: "Hide or show" }, this.symbols[n].canvas, name);
    button.setAttribute("aria-pressed", "true");
    const lift = () => this.panels.forEach((panel) => panel.draw(this.hidden.has(n) ? undefined : ({ entry }) => entry === n));
    button.onclick = () => {
      const isHidden = this.hidden.has(n);
      isHidden ? this.hidden.delete(n) : this.hidden.add(n);
      button.setAttribute("aria-pressed", String(isHidden));
      this.panels.forEach((panel) => panel.choose(null));
      isHidden && button.matches(":hover") ? lift() : this.draw();
    };
    button.onpointerenter = (event) => event.pointerType === "mouse" && lift();
    button.onpointerleave = () => this.draw();
    return button;
  }

  draw() {
    this.symbols.forEach((own) => own.draw());
    this.panels.forEach((panel) => panel.draw());
  }
}

const sections = document.querySelectorAll("section.chart");
window.charts = JSON.parse(document.getElementById("charts").textContent).map((data, n) => new Chart(sections[n], data));
