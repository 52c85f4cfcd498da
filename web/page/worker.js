// Computes apart from the page, which can end it at any time.
let exports;
/** Requests that came before the module. */
const waiting = [];

function start(module) {
  exports = new WebAssembly.Instance(module).exports;
  waiting.splice(0).forEach(answer);
}

/** Unpacks the module of a new page, and gives it to the page for later workers. */
async function unpack(text) {
  const bytes = Uint8Array.fromBase64?.(text) ?? Uint8Array.from(atob(text), (character) => character.charCodeAt(0));
  const unpacked = new Blob([bytes]).stream().pipeThrough(new DecompressionStream("deflate-raw"));
  // compilation of the stream takes longer than that of the whole, whose functions are compiled when they are called
  const module = await WebAssembly.compile(await new Response(unpacked).arrayBuffer());
  self.postMessage({ module });
  start(module);
}

function answer({ id, request }) {
  try {
    const bytes = new TextEncoder().encode(JSON.stringify(request));
    const room = exports.room(bytes.length);
    new Uint8Array(exports.memory.buffer, room, bytes.length).set(bytes);
    const began = performance.now();
    const length = exports.answer();
    const took = performance.now() - began;
    const text = new TextDecoder().decode(new Uint8Array(exports.memory.buffer, exports.text(), length));
    const numbers = new Float64Array(exports.memory.buffer, exports.numbers(), exports.count()).slice();
    self.postMessage({ id, answer: JSON.parse(text), numbers, took }, [numbers.buffer]);
  } catch (error) {
    self.postMessage({ id, failed: String(error) });
  }
}

self.onmessage = ({ data }) => {
  if (data.packed) unpack(data.packed).catch((error) => self.postMessage({ broken: String(error) }));
  else if (data.module) start(data.module);
  else if (exports) answer(data);
  else waiting.push(data);
};
