// Requests to the worker, one after the other.
/** Longest time that a request may take, in ms. */
const LIMIT = 8000;

export class Engine {
  #worker;
  #queue = [];
  #next = 0;
  /** The last requests that gave the worker its mechanism: a new worker gets them, too. */
  #kept = {};

  /** Takes the first worker, the function that starts further ones, and the one that is called if there is no module. */
  constructor({ start, worker, fail }) {
    Object.assign(this, { start, fail });
    this.#listen(worker);
  }

  #listen(worker) {
    this.#worker = worker;
    worker.onmessage = ({ data }) => {
      if (data.broken) this.fail(data.broken);
      else if (data.module) this.module = data.module;
      else this.#take(data);
    };
  }

  /** Starts another worker with the same mechanism. */
  #renew() {
    this.#worker.terminate();
    this.#listen(this.start());
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
    if (!this.module) return this.fail("the module was not unpacked in time");
    this.#renew();
    const first = this.#queue.shift();
    if (first) {
      clearTimeout(first.timer);
      first.resolve({ answer: { is: "refused", why }, numbers: new Float64Array(), took: 0 });
    }
    this.#post();
  }
}
