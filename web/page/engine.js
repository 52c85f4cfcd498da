// Requests to the worker, one after the other.
import source from "worker";

/** Longest time that a request may take, in ms. */
const LIMIT = 8000;

export class Engine {
  #worker;
  #queue = [];
  #next = 0;
  /** The last requests that gave the worker its mechanism: a new worker gets them, too. */
  #kept = {};

  constructor(module) {
    this.module = module;
    this.#start();
  }

  #start() {
    const url = URL.createObjectURL(new Blob([source], { type: "text/javascript" }));
    this.#worker = new Worker(url);
    URL.revokeObjectURL(url);
    this.#worker.onmessage = ({ data }) => this.#take(data);
    this.#worker.postMessage({ module: this.module });
    for (const request of [this.#kept.declare, this.#kept.set]) {
      if (request) this.#worker.postMessage({ id: -1, request });
    }
  }

  /** Resolves to the answer, its numbers, and the time that it took in ms. */
  ask(request) {
    return new Promise((resolve) => {
      this.#queue.push({ id: this.#next++, request, resolve });
      if (this.#queue.length === 1) this.#post();
    });
  }

  #post() {
    const [first] = this.#queue;
    if (!first) return;
    const why = `this took longer than ${LIMIT / 1000} s and was stopped: make the mechanism or its motion simpler`;
    first.timer = setTimeout(() => this.stop(why), LIMIT);
    this.#worker.postMessage({ id: first.id, request: first.request });
  }

  #take({ id, failed, ...result }) {
    const [first] = this.#queue;
    if (id !== first?.id) return;
    if (failed) {
      this.stop(`the computation failed: ${failed}`);
      return;
    }
    clearTimeout(first.timer);
    this.#queue.shift();
    if (result.answer.is === "mechanism") this.#kept = { declare: first.request };
    if (first.request.do === "set" && result.answer.is === "done") this.#kept.set = first.request;
    this.#post();
    first.resolve(result);
  }

  /** Ends the computation under way, and goes on with the next one in another worker. */
  stop(why) {
    this.#worker.terminate();
    this.#start();
    const first = this.#queue.shift();
    if (first) {
      clearTimeout(first.timer);
      first.resolve({ answer: { is: "refused", why }, numbers: new Float64Array(), took: 0 });
    }
    this.#post();
  }
}
