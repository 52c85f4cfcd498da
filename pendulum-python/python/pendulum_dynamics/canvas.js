// Paints the shapes of a mechanism on a canvas, within bounds [left, right, low, high] in m. The canvas has `ratio` pixels
// for each one of the page.
export default function painter(canvas, shapes, bounds, ratio = 1) {
  const context = canvas.getContext("2d");
  context.setTransform(ratio, 0, 0, ratio, 0, 0);
  const [width, height] = [canvas.width / ratio, canvas.height / ratio];
  const colours = ["#2f6fa8", "#c8553d", "#3c8d5a", "#8a5aa8", "#b08a2e", "#4b8f8c"];
  const ground = getComputedStyle(canvas).color || "#555";
  const bodies = [...new Set(shapes.map((shape) => shape.body))].filter((body) => body !== "ground");
  const colour = (body) => (body === "ground" ? ground : colours[bodies.indexOf(body) % colours.length]);
  const [left, right, low, high] = bounds;
  const size = Math.max(right - left, high - low, 1e-9) * 1.1;
  const scale = Math.min(width, height) / size;
  const x = (value) => width / 2 + (value - (left + right) / 2) * scale;
  const y = (value) => height / 2 - (value - (low + high) / 2) * scale;
  const line = (points, closed) => {
    context.beginPath();
    for (let i = 0; i < points.length; i += 2) context.lineTo(x(points[i]), y(points[i + 1]));
    if (closed) context.closePath();
    context.stroke();
  };
  const disk = (px, py, radius, filled) => {
    context.beginPath();
    context.arc(x(px), y(py), radius, 0, 2 * Math.PI);
    filled ? context.fill() : context.stroke();
  };
  const edges = [0, 1, 1, 3, 3, 2, 2, 0, 4, 5, 5, 7, 7, 6, 6, 4, 0, 4, 1, 5, 2, 6, 3, 7];
  const spring = ([ax, ay, bx, by]) => {
    const points = [ax, ay];
    const [dx, dy] = [bx - ax, by - ay];
    const length = Math.hypot(dx, dy) || 1;
    for (let i = 1; i < 16; i++) {
      const side = ((i % 2 ? 1 : -1) * 0.02 * size) / length;
      points.push(ax + (dx * i) / 16 - dy * side, ay + (dy * i) / 16 + dx * side);
    }
    line([...points, bx, by], false);
  };
  const draw = {
    Mass: (p) => { line(p, false); disk(p[0], p[1], 7, true); },
    Rod: (p) => line(p, false),
    Disk: (p, r) => { disk(p[0], p[1], r * scale, false); line(p, false); },
    Sphere: (p, r) => disk(p[0], p[1], r * scale, false),
    Plate: (p) => line(p, true),
    Cylinder: (p, r) => { context.lineWidth = Math.max(2, Math.min(2 * r * scale, 40)); context.globalAlpha /= 2; line(p, false); },
    Cuboid: (p) => { for (let i = 0; i < edges.length; i += 2) line([p[2 * edges[i]], p[2 * edges[i] + 1], p[2 * edges[i + 1]], p[2 * edges[i + 1] + 1]], false); },
    Pivot: (p) => disk(p[0], p[1], 4, false),
    Support: (p) => { disk(p[0], p[1], 4, false); line([p[0] - 0.02 * size, p[1] + 0.02 * size, p[0] + 0.02 * size, p[1] + 0.02 * size], false); },
    Guide: (p) => { const [dx, dy] = [p[2] - p[0], p[3] - p[1]]; line([p[0] - size * dx, p[1] - size * dy, p[0] + size * dx, p[1] + size * dy], false); },
    Spring: spring,
    Damper: spring,
    Point: (p) => disk(p[0], p[1], 2.5, true),
    Anchor: (p) => disk(p[0], p[1], 2.5, true),
  };
  // of each shape, its points on the screen in m, and its radius
  const paint = (frame, alpha = 1) => {
    frame.forEach(([points, radius], k) => {
      const { kind, body } = shapes[k];
      context.strokeStyle = context.fillStyle = kind === "Guide" ? "#bbb" : colour(body);
      context.lineWidth = kind === "Rod" ? 4 : 2;
      context.globalAlpha = alpha;
      draw[kind](points, radius);
    });
    context.globalAlpha = 1;
  };
  const write = (text) => {
    context.fillStyle = ground;
    context.font = "13px sans-serif";
    context.fillText(text, 10, 18);
  };
  const clear = () => context.clearRect(0, 0, width, height);
  return { paint, write, clear, x, y, scale };
}
