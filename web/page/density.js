// Many lines on a canvas, as their density. A thousand strokes would take a canvas without a GPU longer than a frame.

/** Parts into which the width of a line is divided between two pixels. */
const PARTS = 16;
/** Lines on one pixel after which it gets no darker. */
const MOST = 40;
/** Opacity of one line. */
const ONE = 0.08;

/** Opacities by the number of parts of lines on a pixel, up to 255. */
const OPACITIES = Uint8Array.from({ length: PARTS * MOST }, (_, parts) => 255 * (1 - (1 - ONE) ** (parts / PARTS)));

export class Density {
  /** Parts of lines on each pixel; zeros between two pictures. */
  #parts = new Uint32Array();
  #image = null;

  /**
   * Replaces the picture where lines are, each given by the coordinates of its ends in space. `x` and `y` hold an offset
   * and the factors of three coordinates, for the place in pixels.
   */
  paint(context, lines, { x, y, colour: [red, green, blue] }) {
    const { width, height } = context.canvas;
    if (!(width > 1 && height > 1)) return;
    if (this.#image?.width !== width || this.#image.height !== height) {
      this.#image = new ImageData(width, height);
      this.#parts = new Uint32Array(width * height);
    }
    const [x0, xa, xb, xc] = x;
    const [y0, ya, yb, yc] = y;
    let [left, right, top, bottom] = [width, 0, height, 0];
    for (let n = 0; n + 5 < lines.length; n += 6) {
      const px = x0 + xa * lines[n] + xb * lines[n + 1] + xc * lines[n + 2];
      const py = y0 + ya * lines[n] + yb * lines[n + 1] + yc * lines[n + 2];
      const qx = x0 + xa * lines[n + 3] + xb * lines[n + 4] + xc * lines[n + 5];
      const qy = y0 + ya * lines[n + 3] + yb * lines[n + 4] + yc * lines[n + 5];
      if (!Number.isFinite(px + py + qx + qy)) continue;
      left = Math.min(left, px, qx);
      right = Math.max(right, px, qx);
      top = Math.min(top, py, qy);
      bottom = Math.max(bottom, py, qy);
      this.#line(px, py, qx, qy, width, height);
    }
    // an end is rounded to a column or a row, which is up to half a pixel before it
    left = Math.max(0, Math.floor(left) - 1);
    top = Math.max(0, Math.floor(top) - 1);
    const [wide, high] = [Math.min(width, Math.ceil(right) + 2) - left, Math.min(height, Math.ceil(bottom) + 2) - top];
    if (wide > 0 && high > 0) {
      this.#colour(left, top, wide, high, red | (green << 8) | (blue << 16));
      context.putImageData(this.#image, 0, 0, left, top, wide, high);
    }
  }

  /** Adds a line: in each column that it crosses, or each row if it is steep, its parts to two pixels (Wu 1991). */
  #line(px, py, qx, qy, width, height) {
    const parts = this.#parts;
    const isSteep = Math.abs(qy - py) > Math.abs(qx - px);
    // along the line, and across it
    const [ahead, aside, most, across] = isSteep ? [width, 1, height, width] : [1, width, width, height];
    const [a, b, c, d] = isSteep ? [py, px, qy, qx] : [px, py, qx, qy];
    const slope = c === a ? 0 : (d - b) / (c - a);
    const to = Math.min(most - 1, Math.round(Math.max(a, c)));
    for (let n = Math.max(0, Math.round(Math.min(a, c))); n <= to; n++) {
      const place = b + slope * (n - a);
      const whole = Math.floor(place);
      if (whole < 0 || whole > across - 2) continue;
      const part = ((place - whole) * PARTS) | 0;
      const at = n * ahead + whole * aside;
      parts[at] += PARTS - part;
      parts[at + aside] += part;
    }
  }

  /** Sets the pixels of a rectangle, and forgets the lines there. */
  #colour(left, top, wide, high, colour) {
    const { width, data } = this.#image;
    const pixels = new Uint32Array(data.buffer);
    for (let row = top; row < top + high; row++) {
      const from = row * width + left;
      for (let at = from; at < from + wide; at++) {
        const parts = this.#parts[at];
        pixels[at] = parts && colour | (OPACITIES[Math.min(parts, OPACITIES.length - 1)] << 24);
        this.#parts[at] = 0;
      }
    }
  }
}
