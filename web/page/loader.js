// Starts the worker before the rest of the page is read, and unpacks the parts of the page: scripts and the module,
// compressed and in base64.
const loader = (() => {
  const fail = (error) => {
    if (error) console.warn(error);
    document.getElementById("main").hidden = true;
    document.getElementById("without").hidden = false;
  };
  if (typeof WebAssembly !== "object" || typeof DecompressionStream !== "function") return fail();
  const start = () => {
    const url = URL.createObjectURL(new Blob([WORKER], { type: "text/javascript" }));
    const worker = new Worker(url);
    URL.revokeObjectURL(url);
    return worker;
  };
  const part = (id) => document.getElementById(id).textContent.trim();
  /** Runs a part that is a script. */
  const run = async (id) => {
    if (!document.getElementById(id)) await new Promise((read) => addEventListener("DOMContentLoaded", read));
    const packed = part(id);
    const bytes = Uint8Array.fromBase64?.(packed) ?? Uint8Array.from(atob(packed), (character) => character.charCodeAt(0));
    const unpacked = new Blob([bytes]).stream().pipeThrough(new DecompressionStream("deflate-raw"));
    const element = document.createElement("script");
    element.textContent = await new Response(unpacked).text();
    document.head.append(element);
  };
  try {
    const worker = start();
    worker.onerror = fail;
    // messages that come before the script listens
    const early = [];
    worker.onmessage = (event) => early.push(event);
    return { start, worker, early, fail, part, run };
  } catch (error) {
    return fail(error);
  }
})();
