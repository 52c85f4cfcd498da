// Builds the page: one file, which asks for nothing from elsewhere.
//   node build.mjs [file]
import { execFileSync } from "node:child_process";
import { mkdirSync, readFileSync, writeFileSync } from "node:fs";
import { dirname, join } from "node:path";
import { fileURLToPath } from "node:url";
import { build } from "esbuild";
import { begin, FIRST } from "./page/first.js";

const here = dirname(fileURLToPath(import.meta.url));
const page = (name) => join(here, "page", name);
const read = (path) => readFileSync(path, "utf8");

/** Fonts that equations of motion use; others are left out. */
const FONTS = /KaTeX_(Main-Regular|Math-Italic|Size[1-4]-Regular)\.woff2/;

const target = process.env.CARGO_TARGET_DIR ?? join(here, "../target");

/** Compiles the module and returns its bytes. */
function module() {
  const env = { ...process.env, RUSTFLAGS: "-C target-feature=+simd128 -C link-arg=-zstack-size=16777216" };
  const flags = ["build", "--release", "--target", "wasm32-unknown-unknown", "--target-dir", target];
  execFileSync("cargo", flags, { cwd: here, env, stdio: "inherit" });
  return readFileSync(join(target, "wasm32-unknown-unknown/release/pendulum_web.wasm"));
}

/** Declarations of the gallery in the book, with their titles. */
function gallery() {
  const text = read(join(here, "../docs/src/gallery.md"));
  const parts = text.split(/^## /m).slice(1);
  return parts.flatMap((part) => {
    const title = part.slice(0, part.indexOf("\n")).replace(/^\[(.*)\]\(.*\)$/, "$1");
    const blocks = [...part.matchAll(/```rust[^\n]*\n([\s\S]*?)```/g)].map((found) => found[1]);
    const scenes = blocks.flatMap((block) => block.match(/^mechanism! \{[\s\S]*?^\}/gm) ?? []);
    return scenes.map((scene) => {
      const inside = scene.split("\n").slice(1, -1);
      const name = /pub (\w+)/.exec(scene)?.[1];
      return { title: scenes.length > 1 ? `${title}: ${name}` : title, text: inside.map((line) => line.replace(/^ {4}/, "")).join("\n") + "\n" };
    });
  });
}

/** A robot from its file. */
function robot() {
  const name = "ur5.urdf";
  const text = `/// The arm UR5 of Universal Robots, from its file.\npub Ur5 {\n    robot: urdf("${name}"),\n    gravity: [0, 0, -9.81],\n}\n`;
  return { title: "Robot UR5, from a file", text, files: { [name]: read(join(here, "../testbed/data/urdf/declared", name)) } };
}

/** The styles of KaTeX, with the fonts in them. */
function katex() {
  const folder = join(here, "node_modules/katex/dist");
  return read(join(folder, "katex.min.css"))
    .replace(/@font-face\{[^}]*\}/g, (face) => (FONTS.test(face) ? face : ""))
    .replace(/src:url\((fonts\/[^)]*\.woff2)\)[^}]*/g, (_, font) => {
      const bytes = readFileSync(join(folder, font));
      return `src:url(data:font/woff2;base64,${bytes.toString("base64")}) format("woff2")`;
    });
}

/** Modules that are made here. */
const made = (names) => ({
  name: "made",
  setup(to) {
    to.onResolve({ filter: new RegExp(`^(${Object.keys(names).join("|")})$`) }, ({ path }) => ({ path, namespace: "made" }));
    to.onLoad({ filter: /.*/, namespace: "made" }, ({ path }) => ({ contents: `export default ${JSON.stringify(names[path])}` }));
  },
});

async function bundled(entry, names = {}) {
  const plugins = Object.keys(names).length > 0 ? [made(names)] : [];
  const result = await build({ entryPoints: [entry], bundle: true, minify: true, write: false, format: "iife", target: "es2022", plugins });
  return result.outputFiles[0].text;
}

/** Requests at the start of the page, and their answers, by its own worker. */
async function answers(wasm, example) {
  const all = [];
  let last;
  globalThis.self = { postMessage: (message) => (last = message) };
  await import("./page/worker.js");
  self.onmessage({ data: { module: new WebAssembly.Module(wasm) } });
  const ask = async (request) => {
    self.onmessage({ data: { request } });
    all.push([JSON.stringify(request), last.answer, [...last.numbers]]);
    return last;
  };
  await begin({ ask }, example);
  return all;
}

/** Deflates, a twentieth shorter than zlib does. */
function packed(content) {
  const flags = ["run", "--quiet", "--release", "--package", "pack", "--target-dir", target];
  return execFileSync("cargo", flags, { cwd: here, input: content, maxBuffer: 2 ** 26 }).toString("base64");
}

const wasm = module();
const worker = await bundled(page("worker.js"));
const examples = [...gallery(), robot()];
const known = await answers(wasm, examples.find(({ title }) => title.includes(FIRST)));
const parts = {
  style: read(page("look.css")) + read(page("style.css")),
  picture: read(join(here, "../docs/swing.svg")).replace(/^<\?xml[^>]*\?>/, ""),
  loader: read(page("loader.js")).replace("WORKER", () => JSON.stringify(worker.trim())),
  script: packed(await bundled(page("main.js"), { gallery: examples, answers: known })),
  module: packed(wasm),
  formulas: packed(await bundled(page("formulas.js"), { styles: katex() })),
};
const html = read(page("index.html")).replace(/\{\{(\w+)\}\}/g, (_, name) => parts[name]);
const file = process.argv[2] ?? join(here, "../out/pendulum.html");
mkdirSync(dirname(file), { recursive: true });
writeFileSync(file, html);
const size = (bytes) => `${(bytes / 1e6).toFixed(2)} MB`;
const of = ["script", "module", "formulas"].map((name) => `${name} ${size(parts[name].length)}`);
console.log(`${file}: ${size(html.length)}; packed: ${of.join(", ")}; module ${size(wasm.length)}`);
