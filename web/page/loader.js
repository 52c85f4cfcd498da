// Starts the worker, which unpacks the module, and beside it the script of the page. Both are compressed and in base64.
(async () => {
  const fail = (error) => {
    if (error) console.warn(error);
    document.getElementById("main").hidden = true;
    document.getElementById("without").hidden = false;
  };
  if (typeof WebAssembly !== "object" || typeof DecompressionStream !== "function") return fail();
  const [script, packed] = document.getElementById("packed").textContent.trim().split(/\s+/);
  const start = () => {
    const url = URL.createObjectURL(new Blob([WORKER], { type: "text/javascript" }));
    const worker = new Worker(url);
    URL.revokeObjectURL(url);
    return worker;
  };
  try {
    const worker = start();
    worker.onerror = fail;
    worker.postMessage({ packed });
    const bytes = Uint8Array.from(atob(script), (character) => character.charCodeAt(0));
    const unpacked = new Blob([bytes]).stream().pipeThrough(new DecompressionStream("deflate-raw"));
    const element = document.createElement("script");
    element.textContent = await new Response(unpacked).text();
    window.pendulumWorker = { start, worker, fail };
    document.head.append(element);
  } catch (error) {
    fail(error);
  }
})();
