// Computes apart from the page, which can end it at any time.
let module;

self.onmessage = ({ data }) => {
  if (data.module) {
    module = new WebAssembly.Instance(data.module).exports;
    return;
  }
  const { id, request } = data;
  try {
    const bytes = new TextEncoder().encode(JSON.stringify(request));
    const room = module.room(bytes.length);
    new Uint8Array(module.memory.buffer, room, bytes.length).set(bytes);
    const began = performance.now();
    const length = module.answer();
    const took = performance.now() - began;
    const text = new TextDecoder().decode(new Uint8Array(module.memory.buffer, module.text(), length));
    const numbers = new Float64Array(module.memory.buffer, module.numbers(), module.count()).slice();
    self.postMessage({ id, answer: JSON.parse(text), numbers, took }, [numbers.buffer]);
  } catch (error) {
    self.postMessage({ id, failed: String(error) });
  }
};
