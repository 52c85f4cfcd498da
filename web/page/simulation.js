// Motions of a mechanism, computed ahead of what is shown.
import { valuesOf } from "./requests.js";

/** Frames that are computed at a time, and of those that come first. */
const CHUNK = 30;
const FIRST = 6;
/** Frames that are kept for trails and plots. */
const KEPT = 6000;
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
  /** `settings(about)` returns what the user has chosen: method, speed, companions and section. */
  constructor(engine, about, settings) {
    Object.assign(this, { engine, about, settings });
    this.length = about.components.length;
    // counts of restarts, and of ends of the thousand: what waits asks whether it is still wanted
    Object.assign(this, { epoch: 0, crowds: 0 });
  }

  /** Starts anew from a state. Resolves to the reason why this is impossible, if it is. */
  async start(t, x) {
    const epoch = ++this.epoch;
    this.busy = true;
    const { answer, numbers } = await this.engine.ask({ do: "look", t, x: [...x] });
    if (epoch !== this.epoch) return null;
    this.busy = false;
    if (answer.is === "refused") return answer.why;
    this.show(numbers, t, answer.x);
    return null;
  }

  /** Starts anew, and resolves to the reason why there is no motion from this state, too. */
  async tryFrom(t, x) {
    const why = await this.start(t, x);
    if (why) return why;
    await this.prepare();
    return this.ahead.length > 0 ? null : this.stopped;
  }

  /** Shows a state, such as one to which the mechanism was dragged; the motion starts there. */
  show(numbers, t, x) {
    this.epoch++;
    this.now = frameOf(numbers, this.length);
    this.end = { t, x };
    Object.assign(this, { ahead: [], past: [], mode: "", busy: false });
    this.forget();
  }

  /** Forgets what holds for the motion up to now only. */
  forget() {
    this.endCrowd();
    Object.assign(this, { stopped: null, reference: null, twin: null, error: null });
    Object.assign(this, { coming: [], passages: [], earlier: null });
    this.energyAtStart = this.now.kinetic + this.now.potential;
  }

  /** Goes on from the frame that is shown, by another method or with other parameters. */
  change() {
    if (!this.now) return;
    this.epoch++;
    const earlier = { ahead: this.ahead, end: this.end };
    this.forget();
    // a frame within a step at a contact may lie beyond it by a rounding error: the motion then changes at its end
    Object.assign(this, { earlier, ahead: [], busy: false, end: { t: this.now.t, x: [...this.now.x] } });
    this.energyAtStart = null;
  }

  /** Computes the next frames, unless there are enough. */
  async prepare() {
    if (this.busy || this.stopped || this.ahead.length > CHUNK) return;
    this.busy = true;
    const { epoch } = this;
    await this.compute(() => epoch === this.epoch);
    if (epoch === this.epoch) this.busy = false;
  }

  async compute(isCurrent) {
    const { by, speed, section, ...wanted } = this.settings(this.about);
    const { t, x } = this.end;
    if (!wanted.reference) this.reference = this.error = null;
    else if (!this.reference) Object.assign(this, { reference: { t, x }, since: t });
    if (!wanted.twin) this.twin = null;
    else if (!this.twin) {
      const { answer } = await this.engine.ask({ do: "near", t, x, by: 1e-6 });
      if (!isCurrent()) return;
      if (answer.is === "state") this.twin = { t, x: answer.x };
    }
    if (!wanted.crowd) this.endCrowd();
    else if (!this.crowd) {
      await this.gather(t, x);
      if (!isCurrent()) return;
    }
    if (section !== this.cut) Object.assign(this, { cut: section, coming: [], passages: [] });
    const frames = this.past.length + this.ahead.length > 0 ? CHUNK : FIRST;
    const span = [t, t + (frames * speed) / 60];
    const move = (from, method, section = null) => this.engine.ask({ do: "move", by: method, span, x: from.x, frames, section });
    const began = performance.now();
    const [own, reference, twin, crowd] = await Promise.all([
      move(this.end, by, section),
      this.reference && move(this.reference, { method: "Vern9", tolerance: TIGHT }),
      this.twin && move(this.twin, by),
      this.crowd?.engine?.ask({ do: "move_all", span, frames }),
    ]);
    if (!isCurrent()) return;
    const { answer, numbers } = own;
    if (answer.is === "refused") {
      if (this.earlier) {
        this.endCrowd();
        Object.assign(this, this.earlier, { earlier: null, reference: null, twin: null });
      } else this.stopped = answer.why;
      return;
    }
    this.earlier = null;
    this.slowness = (performance.now() - began) / ((1000 * frames) / 60);
    this.work = { evaluations: answer.evaluations, steps: answer.steps, span: answer.t - span[0] };
    const rows = (of) => (n) => (of?.answer.is === "frames" ? of.numbers.subarray(n * of.answer.width, (n + 1) * of.answer.width) : []);
    const [main, tight, near, all] = [own, reference, twin, crowd].map(rows);
    const frameIn = (row) => (row.length > 0 ? frameOf(row, this.length) : null);
    const modes = [...answer.modes];
    const count = answer.width > 0 ? numbers.length / answer.width : 0;
    for (let n = 0; n < count; n++) {
      const frame = frameOf(main(n), this.length);
      while (modes.length > 0 && modes[0][0] <= frame.t) this.mode = modes.shift()[1];
      const [reference, twin] = [tight(n), near(n)].map(frameIn);
      Object.assign(frame, { reference, twin, mode: this.mode, warning: answer.warnings.at(-1) });
      frame.crowd = all(n).length > 0 ? all(n).subarray(1) : null;
      this.ahead.push(frame);
    }
    this.coming.push(...answer.passages);
    this.end = { t: answer.t, x: answer.x };
    const follow = (of) => (of?.answer.is === "frames" && !of.answer.stopped ? { t: of.answer.t, x: of.answer.x } : null);
    this.reference = follow(reference);
    this.twin = follow(twin);
    if (this.crowd?.engine && crowd) {
      const { is, why, stopped, accuracy } = crowd.answer;
      if (is === "refused" || stopped) this.endCrowd(stopped ?? why);
      else Object.assign(this.crowd, { ...accuracy, span: span[1] - span[0] });
    }
    if (answer.stopped) this.stopped = answer.stopped;
  }

  /** Starts a thousand motions in a worker of their own, so that the next text need not wait for them. */
  async gather(t, x) {
    const { epoch, crowds } = this;
    await this.engine.compiled;
    if (epoch !== this.epoch || crowds !== this.crowds) return;
    const engine = this.engine.another();
    this.crowd = { engine };
    engine.ask(this.about.request);
    engine.ask(valuesOf(this.about));
    const { answer } = await engine.ask({ do: "gather", t, x, count: 1000, spread: 1e-3 });
    if (answer.is === "refused" && this.crowd?.engine === engine) this.endCrowd(answer.why);
  }

  /** Ends the thousand, for a reason that the page shows, if there is one. */
  endCrowd(why) {
    this.crowds++;
    this.crowd?.engine?.end();
    this.crowd = why ? { why } : null;
  }

  /** Advances by frames. Returns false where the motion has ended. */
  advance(count) {
    for (; count > 0 && this.ahead.length > 0; count--) {
      const frame = this.ahead.shift();
      // a thousand take room: those of frames that are past are not kept
      this.now.crowd = null;
      this.now = frame;
      this.energyAtStart ??= frame.kinetic + frame.potential;
      this.error = frame.reference ? this.difference(frame.x, frame.reference.x) : null;
      while (this.coming[0]?.[0] <= frame.t) this.passages.push(this.coming.shift()[1]);
      this.past.push(frame);
      if (this.past.length > KEPT) this.past.splice(0, KEPT / 2);
    }
    return this.ahead.length > 0 || !this.stopped;
  }

  /** Largest difference of two states, and its component; angles by whole turns are the same. */
  difference(a, b) {
    let worst = { by: 0, component: this.about.components[0] };
    this.about.components.forEach((component, n) => {
      let by = Math.abs(a[n] - b[n]);
      if (component.periodic) by = Math.abs(by - 2 * Math.PI * Math.round(by / (2 * Math.PI)));
      if (!(by <= worst.by)) worst = { by, component };
    });
    return worst;
  }
}
