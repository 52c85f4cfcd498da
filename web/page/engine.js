// Requests to the worker, which answers them one after the other.
/** Longest time that a request may take, in ms. */
const LIMIT = 8000;

const refused = (why) => ({ answer: { is: "refused", why }, numbers: new Float64Array(), took: 0 });

export class Engine {
  #worker;
  #queue = [];
  /** Time at which the worker began with the first request, in ms. */
  #began = 0;
  #next = 0;
  /** The last requests that gave the worker its mechanism: a new worker gets them, too. */
  #kept = {};

  /** Answers and their numbers by the texts of requests, for the time until the module is compiled. */
  #known;
  #isCompiled;
  /** Resolves when the module is compiled. */
  compiled = new Promise((resolve) => (this.#isCompiled = resolve));

  /**
   * Takes the first worker and its messages up to now, the function that starts further ones, the one that is called if
   * there is no module, and known answers.
   */
  constructor({ start, worker, early = [], fail, known = [] }) {
    Object.assign(this, { start, fail });
    this.#known = new Map(known.map(([request, answer, numbers]) => [request, { answer, numbers: new Float64Array(numbers), took: 0 }]));
    this.#listen(worker);
    early.forEach(worker.onmessage);
  }

  #listen(worker) {
    this.#worker = worker;
    worker.onmessage = ({ data }) => {
      if (data.broken) this.fail(data.broken);
      else if (data.module) {
        this.module = data.module;
        this.#isCompiled();
        this.#watch();
      } else this.#take(data);
    };
  }

  /** Another one, with a worker of its own and no mechanism yet. */
  another() {
    const { start, fail, module } = this;
    const worker = start();
    worker.postMessage({ module });
    return Object.assign(new Engine({ start, fail, worker }), { module });
  }

  /** Ends the worker, and refuses what it was asked. */
  end() {
    this.#worker.terminate();
    clearTimeout(this.#queue[0]?.timer);
    this.#queue.splice(0).forEach(({ resolve }) => resolve(refused("the worker was ended")));
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
    const known = !this.module && this.#known.get(JSON.stringify(request));
    if (!known) return this.#compute(request);
    // the worker has to have the mechanism, too, and so does one that takes its place meanwhile
    if (request.do === "declare") {
      this.#kept = { declare: request };
      this.#compute(request);
    }
    return Promise.resolve(known);
  }

  #compute(request) {
    return new Promise((resolve) => {
      const asked = { id: this.#next++, request, resolve };
      this.#queue.push(asked);
      this.#post(asked);
      if (this.#queue.length === 1) this.#watch();
    });
  }

  #post({ id, request }) {
    this.#worker.postMessage({ id, request });
  }

  /** Time for which the worker computes an answer, in ms. */
  get busy() {
    return this.module && this.#queue.length > 0 ? performance.now() - this.#began : 0;
  }

  /** Stops the worker if the first request takes too long. */
  #watch() {
    const [first] = this.#queue;
    // the time to unpack the module is not that of a request
    if (!first || !this.module) return;
    this.#began = performance.now();
    const why = `this took longer than ${LIMIT / 1000} s and was stopped: make the mechanism or its motion simpler`;
    first.timer = setTimeout(() => this.stop(why), LIMIT);
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
    this.#watch();
    first.resolve(result);
  }

  /** Ends the computation under way, and goes on with the next one in another worker. */
  stop(why) {
    if (!this.module) return;
    this.#renew();
    const first = this.#queue.shift();
    if (first) {
      clearTimeout(first.timer);
      first.resolve(refused(why));
    }
    this.#queue.forEach((asked) => this.#post(asked));
    this.#watch();
  }
}
