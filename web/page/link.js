// Links that carry a declaration, and files of robots, after the `#`.
const BASE64 = { "+": "-", "/": "_", "=": "" };

async function through(stream, bytes) {
  const result = new Blob([bytes]).stream().pipeThrough(stream);
  return new Uint8Array(await new Response(result).arrayBuffer());
}

export async function toHash(declaration) {
  const text = JSON.stringify(declaration);
  const bytes = await through(new CompressionStream("deflate-raw"), new TextEncoder().encode(text));
  const binary = Array.from(bytes, (byte) => String.fromCharCode(byte)).join("");
  return `#d=${btoa(binary).replace(/[+/=]/g, (character) => BASE64[character])}`;
}

/** The text and the files of a link: compressed after `#d=`, or percent-encoded text after `#text=`; `null` if there is none. */
export async function fromHash(hash) {
  if (hash.startsWith("#text=")) return { text: decodeURIComponent(hash.slice(6)) };
  if (!hash.startsWith("#d=")) return null;
  const binary = atob(hash.slice(3).replace(/[-_]/g, (character) => (character === "-" ? "+" : "/")));
  const bytes = Uint8Array.from(binary, (character) => character.charCodeAt(0));
  const { text, files } = JSON.parse(new TextDecoder().decode(await through(new DecompressionStream("deflate-raw"), bytes)));
  return { text: String(text), files };
}
