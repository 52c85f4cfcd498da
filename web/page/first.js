// The start of the page: its first example in motion. build.mjs records the answers to these requests, so that the page
// shows them while its module is unpacked and compiled.
import { declaration } from "./requests.js";
import { Simulation } from "./simulation.js";

/** Part of the title of the first example. */
export const FIRST = "Point masses";
/** Methods, the first one first. */
export const METHODS = ["Vern9", "Taylor", "Rk4", "Rodas5P", "Gauss6", "Auto"];
/** What is chosen at first, as in index.html. */
const SETTINGS = { by: { method: METHODS[0], tolerance: 10 ** -9 }, speed: 1, twin: false, reference: true, crowd: false, section: null };

/** Asks what the page asks, until the motion is computed for half a second. */
export async function begin(engine, { text, files = {} }) {
  const { answer: about } = await engine.ask(declaration(text, files, METHODS[0]));
  const simulation = new Simulation(engine, about, () => SETTINGS);
  await simulation.start(0, about.start);
  await simulation.prepare();
  await simulation.prepare();
}
