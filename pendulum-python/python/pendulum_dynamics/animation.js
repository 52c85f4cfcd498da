// Plays the frames of a motion, again and again.
((canvas, scene) => {
  const bounds = [Infinity, -Infinity, Infinity, -Infinity];
  for (const frame of scene.frames) {
    frame.forEach(([points, radius], n) => {
      if (painter.endless.has(scene.shapes[n].kind)) return;
      for (let i = 0; i < points.length; i += 2) {
        bounds[0] = Math.min(bounds[0], points[i] - radius);
        bounds[1] = Math.max(bounds[1], points[i] + radius);
        bounds[2] = Math.min(bounds[2], points[i + 1] - radius);
        bounds[3] = Math.max(bounds[3], points[i + 1] + radius);
      }
    });
  }
  const on = painter(canvas, scene.shapes, bounds);
  const show = (n) => {
    on.clear();
    on.paint(scene.frames[n]);
    on.write(`t = ${scene.times[n].toFixed(2)} s`);
  };
  if (scene.frames.length === 0) return;
  const [first, last] = [scene.times[0], scene.times[scene.times.length - 1]];
  let [began, frame] = [null, 0];
  const step = (now) => {
    began ??= now;
    const elapsed = ((now - began) / 1000) * scene.speed;
    while (frame + 1 < scene.times.length && Math.abs(scene.times[frame + 1] - first) <= elapsed) frame++;
    show(frame);
    // a pause at the end, then again
    if (elapsed > Math.abs(last - first) + scene.speed) [began, frame] = [null, 0];
    if (canvas.isConnected) requestAnimationFrame(step);
  };
  show(0);
  requestAnimationFrame(step);
})
