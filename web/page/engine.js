// Requests to the worker, one after the other.
import source from "worker";

/** Longest time that a request may take, in ms. */
const LIMIT = 8000;

export class Engine {
  #worker;
  #waiting = new Map();
  #next = 0;

  constructor(module) {
    this.module = module;
    this.#start();
  }

  #start() {
    const url = URL.createObjectURL(new Blob([source], { type: "text/javascript" }));
    this.#worker = new Worker(url);
    URL.revokeObjectURL(url);
    this.#worker.onmessage = ({ data }) => {
      const waiting = this.#waiting.get(data.id);
      if (!waiting) return;
      this.#waiting.delete(data.id);
      clearTimeout(waiting.timer);
      waiting.resolve(data);
    };
    this.#worker.onerror = (event) => this.stop(`the computation failed: ${event.message}`);
    this.#worker.postMessage({ module: this.module });
  }

  /** Resolves to the answer, its numbers, and the time that it took in ms. */
  ask(request) {
    const id = this.#next++;
    return new Promise((resolve) => {
      const why = `this took longer than ${LIMIT / 1000} s and was stopped: make the mechanism or its motion simpler`;
      const timer = setTimeout(() => this.stop(why), LIMIT);
      this.#waiting.set(id, { resolve, timer });
      this.#worker.postMessage({ id, request });
    });
  }

  /** Ends all computations, and starts anew, without a mechanism. */
  stop(why) {
    this.#worker.terminate();
    for (const { resolve, timer } of this.#waiting.values()) {
      clearTimeout(timer);
      resolve({ answer: { is: "refused", why, stopped: true }, numbers: new Float64Array(), took: 0 });
    }
    this.#waiting.clear();
    this.#start();
  }
}
