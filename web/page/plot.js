// Curves and points on a canvas, with axes.
export function plot(canvas, { lines = [], dots = [], x, y }) {
  const context = canvas.getContext("2d");
  const ratio = Math.min(window.devicePixelRatio || 1, 2);
  [canvas.width, canvas.height] = [canvas.clientWidth * ratio, canvas.clientHeight * ratio];
  context.scale(ratio, ratio);
  const [width, height] = [canvas.clientWidth, canvas.clientHeight];
  const all = [...lines.flatMap((line) => line.points), ...dots];
  const ink = getComputedStyle(canvas).color;
  const range = (k) => {
    let [low, high] = [Infinity, -Infinity];
    for (const point of all) {
      if (!Number.isFinite(point[k])) continue;
      low = Math.min(low, point[k]);
      high = Math.max(high, point[k]);
    }
    if (!Number.isFinite(low)) return [0, 1];
    const margin = (high - low) * 0.05 || Math.abs(high) * 0.05 || 1;
    return [low - margin, high + margin];
  };
  const [[x0, x1], [y0, y1]] = [range(0), range(1)];
  const [left, bottom, top, right] = [64, 36, 10, 12];
  const px = (value) => left + ((value - x0) / (x1 - x0)) * (width - left - right);
  const py = (value) => height - bottom - ((value - y0) / (y1 - y0)) * (height - bottom - top);
  const short = (value) => (Math.abs(value) >= 1e4 || (Math.abs(value) < 1e-3 && value !== 0) ? value.toExponential(1) : String(Number(value.toPrecision(4))));
  context.font = "12px sans-serif";
  context.fillStyle = context.strokeStyle = ink;
  context.globalAlpha = 0.35;
  context.strokeRect(left, top, width - left - right, height - bottom - top);
  context.globalAlpha = 1;
  const ticks = (low, high) => {
    const raw = (high - low) / 4;
    const power = 10 ** Math.floor(Math.log10(raw));
    const step = [1, 2, 5, 10].map((own) => own * power).find((own) => own >= raw);
    const marks = [];
    for (let mark = Math.ceil(low / step); mark * step <= high; mark++) marks.push(mark * step);
    return marks;
  };
  context.textAlign = "center";
  for (const mark of ticks(x0, x1)) context.fillText(short(mark), px(mark), height - bottom + 15);
  context.fillText(x, left + (width - left - right) / 2, height - 5);
  context.textAlign = "right";
  for (const mark of ticks(y0, y1)) context.fillText(short(mark), left - 5, py(mark) + 4);
  context.save();
  context.translate(12, top + (height - bottom - top) / 2);
  context.rotate(-Math.PI / 2);
  context.textAlign = "center";
  context.fillText(y, 0, 0);
  context.restore();
  for (const { points, colour } of lines) {
    context.strokeStyle = colour;
    // a canvas draws wider lines several times slower
    context.lineWidth = 1;
    context.beginPath();
    let pen = false;
    for (const [a, b] of points) {
      pen = Number.isFinite(a) && Number.isFinite(b) ? (pen ? context.lineTo(px(a), py(b)) : context.moveTo(px(a), py(b)), true) : false;
    }
    context.stroke();
  }
  context.fillStyle = "#c8553d";
  for (const [a, b] of dots) context.fillRect(px(a) - 1.5, py(b) - 1.5, 3, 3);
  if (lines.length > 1) {
    context.textAlign = "left";
    lines.forEach(({ name, colour }, n) => {
      context.fillStyle = colour;
      context.fillText(name, left + 8 + 90 * n, top + 14);
    });
  }
}
