// Unpacks the script, the styles and the module, which are compressed and in base64, and starts the script.
(async () => {
  const fail = () => {
    document.getElementById("main").hidden = true;
    document.getElementById("without").hidden = false;
  };
  if (typeof WebAssembly !== "object" || typeof DecompressionStream !== "function") return fail();
  const [script, module] = document.getElementById("packed").textContent.trim().split(/\s+/);
  const unpacked = (text) => {
    const binary = atob(text);
    const bytes = new Uint8Array(binary.length);
    for (let n = 0; n < bytes.length; n++) bytes[n] = binary.charCodeAt(n);
    return new Response(new Blob([bytes]).stream().pipeThrough(new DecompressionStream("deflate-raw")));
  };
  try {
    const wasm = unpacked(module).arrayBuffer();
    const element = document.createElement("script");
    element.textContent = await unpacked(script).text();
    window.pendulumModule = await WebAssembly.compile(await wasm);
    document.head.append(element);
  } catch (error) {
    console.error(error);
    fail();
  }
})();
