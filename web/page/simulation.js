// Motions of a mechanism, computed ahead of what is shown.

/** Frames that are computed at a time, and of those that come first. */
const CHUNK = 30;
const FIRST = 6;
/** Frames that are kept for trails and plots. */
const KEPT = 6000;
/** Step of many motions, in s. */
const STEP = 1 / 240;
/** Tolerance of the reference. */
const TIGHT = 1e-13;

/** A frame: time, state, energy, and numbers of the shapes. */
function frameOf(row, length) {
  return {
    t: row[0],
    x: row.subarray(1, 1 + length),
    kinetic: row[1 + length],
    potential: row[2 + length],
    shapes: row.subarray(3 + length),
  };
}

export class Simulation {
  /** `settings()` returns what the user has chosen: method, speed, companions and section. */
  constructor(engine, about, settings) {
    Object.assign(this, { engine, about, settings });
    this.length = about.components.length;
    this.epoch = 0;
    this.past = [];
    this.sections = [];
  }

  /** Starts anew from a state. Resolves to the reason why this is impossible, if it is. */
  async start(t, x) {
    const epoch = ++this.epoch;
    Object.assign(this, { ahead: [], busy: true, stopped: null, mode: "", past: [], sections: [] });
    const { answer, numbers } = await this.engine.ask({ do: "look", t, x: [...x] });
    if (epoch !== this.epoch) return null;
    if (answer.is === "refused") return answer.why;
    this.show(numbers, t, answer.x);
    await this.follow(epoch);
    return null;
  }

  /** Shows a state to which the mechanism was dragged. */
  show(numbers, t, x) {
    this.now = frameOf(numbers, this.length);
    this.end = { t, x };
    this.energyAtStart = this.now.kinetic + this.now.potential;
    this.error = null;
  }

  /** Goes on from the frame that is shown, with other settings or parameters. */
  async change() {
    const epoch = ++this.epoch;
    Object.assign(this, { ahead: [], busy: true, stopped: null });
    this.end = { t: this.now.t, x: [...this.now.x] };
    this.energyAtStart = null;
    await this.follow(epoch);
  }

  /** Starts the companions beside the motion. */
  async follow(epoch) {
    const { twin, reference, crowd } = this.settings();
    const { t, x } = this.end;
    this.reference = reference ? { t, x } : null;
    this.twin = null;
    if (twin && this.about.components.length > 0) {
      const near = [...x];
      near[0] += 1e-6;
      const { answer } = await this.engine.ask({ do: "look", t, x: near });
      if (epoch !== this.epoch) return;
      if (answer.is === "state") this.twin = { t, x: answer.x };
    }
    this.crowd = false;
    if (crowd) {
      const { answer } = await this.engine.ask({ do: "gather", x: [...x], count: 1000, spread: 1e-3 });
      if (epoch !== this.epoch) return;
      this.crowd = answer.is === "done";
    }
    this.busy = false;
  }

  /** Computes the next frames, unless there are enough. */
  async prepare() {
    if (this.busy || this.stopped || this.ahead.length > CHUNK) return;
    this.busy = true;
    const epoch = this.epoch;
    const { by, speed, section } = this.settings();
    const frames = this.past.length + this.ahead.length > 0 ? CHUNK : FIRST;
    const span = [this.end.t, this.end.t + (frames * speed) / 60];
    const ask = (from, method) =>
      this.engine.ask({ do: "move", by: method, span, x: from.x, frames, section: from === this.end ? section : null });
    if (section !== this.cut) [this.cut, this.sections] = [section, []];
    const began = performance.now();
    const asked = [ask(this.end, by)];
    asked.push(this.reference ? ask(this.reference, { method: "Vern9", tolerance: TIGHT }) : null);
    asked.push(this.twin ? ask(this.twin, by) : null);
    asked.push(this.crowd ? this.engine.ask({ do: "move_all", by: { method: "Rk4", h: STEP }, span, frames }) : null);
    const [own, reference, twin, crowd] = await Promise.all(asked);
    if (epoch !== this.epoch) return;
    this.busy = false;
    const { answer, numbers } = own;
    if (answer.is === "refused") {
      this.stopped = answer.why;
      return;
    }
    this.took = own.took;
    this.pace = ((performance.now() - began) / frames) * (60 / 1000);
    this.work = { evaluations: answer.evaluations, steps: answer.steps, span: answer.t - span[0] };
    const rows = (of) => (n) => of?.answer.is === "frames" && of.numbers.subarray(n * of.answer.width, (n + 1) * of.answer.width);
    const [main, tight, near, all] = [own, reference, twin, crowd].map(rows);
    const modes = [...answer.modes];
    const count = answer.width > 0 ? numbers.length / answer.width : 0;
    for (let n = 0; n < count; n++) {
      const frame = frameOf(main(n), this.length);
      const also = (row) => (row && row.length > 0 ? frameOf(row, this.length) : null);
      frame.reference = also(tight(n));
      frame.twin = also(near(n));
      frame.crowd = all(n) ? all(n).subarray(1) : null;
      while (modes.length > 0 && modes[0][0] <= frame.t) this.mode = modes.shift()[1];
      frame.mode = this.mode;
      this.ahead.push(frame);
    }
    this.sections.push(...answer.sections);
    this.end = { t: answer.t, x: answer.x };
    const follow = (of) => (of?.answer.is === "frames" && !of.answer.stopped ? { t: of.answer.t, x: of.answer.x } : null);
    this.reference = follow(reference);
    this.twin = follow(twin);
    if (crowd?.answer.stopped || crowd?.answer.is === "refused") this.crowd = false;
    if (answer.stopped) this.stopped = answer.stopped;
    this.warnings = answer.warnings;
  }

  /** Advances by frames. Returns false where the motion has ended. */
  advance(count) {
    for (; count > 0 && this.ahead.length > 0; count--) {
      const frame = this.ahead.shift();
      this.now = frame;
      this.energyAtStart ??= frame.kinetic + frame.potential;
      if (frame.reference) this.error = this.difference(frame.x, frame.reference.x);
      this.past.push(frame);
      if (this.past.length > KEPT) this.past.splice(0, KEPT / 2);
    }
    return this.ahead.length > 0 || !this.stopped;
  }

  /** Largest difference of two states; angles by whole turns are the same. */
  difference(a, b) {
    let most = 0;
    this.about.components.forEach(({ periodic }, n) => {
      let own = Math.abs(a[n] - b[n]);
      if (periodic) own = Math.abs(own - 2 * Math.PI * Math.round(own / (2 * Math.PI)));
      most = Math.max(most, own);
    });
    return most;
  }
}
