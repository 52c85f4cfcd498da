// Computes apart from the page, which can end it at any time.
let module;

self.onmessage = async ({ data }) => {
  if (data.module) {
    module = (await WebAssembly.instantiate(data.module)).exports;
    self.postMessage({ ready: true });
    return;
  }
  const request = new TextEncoder().encode(JSON.stringify(data.request));
  const room = module.room(request.length);
  new Uint8Array(module.memory.buffer, room, request.length).set(request);
  const began = performance.now();
  const length = module.answer();
  const took = performance.now() - began;
  const text = new TextDecoder().decode(new Uint8Array(module.memory.buffer, module.text(), length));
  const numbers = new Float64Array(module.memory.buffer, module.numbers(), module.count()).slice();
  self.postMessage({ id: data.id, answer: JSON.parse(text), numbers, took }, [numbers.buffer]);
};
