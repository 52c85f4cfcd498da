// The page: an editor, the mechanism in motion, and what is known about it.
import known from "answers";
import examples from "gallery";
import { Editor, proposal } from "./editor.js";
import { element } from "./element.js";
import { Engine } from "./engine.js";
import { Fields } from "./fields.js";
import { FIRST, METHODS } from "./first.js";
import { fromHash, toHash } from "./link.js";
import { Panel } from "./panel.js";
import { declaration, valuesOf } from "./requests.js";
import { Simulation } from "./simulation.js";
import { View } from "./view.js";

/** Time of a computation after which it can be stopped, in ms. */
const PATIENCE = 1000;
/** Time between two changes of readings, fields and plots while the mechanism moves, in ms. */
const READABLE = 100;

const $ = (id) => document.getElementById(id);

const engine = new Engine({ ...loader, known });
const editor = new Editor($("editor"), { onChange: declare });
const view = new View($("canvas"), { onDrag: drag, onDrop: drop });
const panel = new Panel($("tabs"), $("panel"), engine);
const fields = new Fields($("parameters"), $("state"), { onValue: change, onState: place, show });

/** What is shown: the mechanism, its motion, and files that were opened. */
const app = { view, about: null, simulation: null, playing: false, owed: 0, last: 0, read: 0, drawn: 0, files: {} };

// what the user chooses

const chosen = {
  get method() {
    return $("method").value;
  },
  get h() {
    return 2 ** Number($("h").value);
  },
  get tolerance() {
    return 10 ** Number($("tolerance").value);
  },
  get speed() {
    return 2 ** Number($("speed").value);
  },
};

function settings({ request: { method }, has_fixed_steps }) {
  return {
    by: { method, ...(has_fixed_steps ? { h: chosen.h } : { tolerance: chosen.tolerance }) },
    speed: chosen.speed,
    twin: $("twin").checked,
    reference: $("reference").checked,
    crowd: $("crowd").checked,
    section: panel.section,
  };
}

function show(text) {
  $("note").textContent = text ?? "";
}

// the declaration

/** Compiles the text; while the worker compiles, later changes wait for the last one. */
function declare() {
  app.again = true;
  app.declaring ??= compile().finally(() => (app.declaring = null));
}

async function compile() {
  while (app.again) {
    app.again = false;
    const request = declaration(editor.text, app.files, chosen.method);
    const { answer, took } = await engine.ask(request);
    app.took = took;
    if (app.again) continue;
    const isMechanism = answer.is === "mechanism";
    if (isMechanism) await take(Object.assign(answer, { request }));
    complain(answer.problems ?? [], answer.why);
    document.body.classList.toggle("stale", !isMechanism && app.about !== null);
  }
}

function complain(problems, why) {
  editor.mark(problems);
  const list = $("problems");
  list.replaceChildren();
  for (const problem of problems) {
    const go = element("button", { textContent: `Line ${problem.line}`, onclick: () => editor.go(problem) });
    const help = element("span", { className: "help", textContent: ` ${problem.help}` });
    const item = element("li", {}, go, ` ${problem.message} [${problem.code}].`, help);
    const name = proposal(problem.help);
    if (name) item.append(" ", element("button", { textContent: `Write ${name}`, onclick: () => editor.fix(problem, name) }));
    list.append(item);
  }
  if (why) list.append(element("li", { textContent: why }));
  if (list.childElementCount > 0 && app.about) {
    list.append(element("li", { className: "help", textContent: `Still shown: ${app.about.name}.` }));
  }
}

/** Shows a mechanism. One with the same state as before goes on from where it is, with the values that were set. */
async function take(about) {
  const names = (of) => JSON.stringify(of.components.map(({ name }) => name));
  const isSame = app.about && !app.fresh && names(about) === names(app.about);
  const from = isSame ? { t: app.simulation.now.t, x: [...app.simulation.now.x] } : { t: 0, x: about.start };
  for (const kind of ["parameters", "inputs"]) {
    for (const own of about[kind]) {
      const before = isSame && app.about[kind].find(({ name, declared }) => name === own.name && declared === own.value);
      own.declared = own.value;
      if (before) own.value = before.value;
    }
  }
  // the same fields, with what they hold
  const declared = (of) => JSON.stringify([...of.parameters, ...of.inputs].map(({ name, unit, docs, declared }) => [name, unit, docs, declared]));
  const hasSameFields = isSame && declared(about) === declared(app.about);
  if (hasSameFields) Object.assign(about, { parameters: app.about.parameters, inputs: app.about.inputs });
  const notes = [...about.notes];
  const isAsDeclared = [...about.parameters, ...about.inputs].every((own) => own.value === own.declared);
  const refused = isAsDeclared ? null : await put(about);
  if (refused) {
    notes.push(refused);
    for (const own of [...about.parameters, ...about.inputs]) own.value = own.declared;
    await put(about);
  }
  const simulation = new Simulation(engine, about, settings);
  const why = await simulation.start(from.t, from.x);
  if (why) {
    notes.push(why);
    await simulation.start(0, about.start);
  }
  if (app.again) return;
  if (!simulation.now) return show(notes.join("; "));
  await simulation.prepare();
  app.simulation?.endCrowd();
  Object.assign(app, { about, simulation, fresh: false });
  view.take(about.shapes, [simulation.now, ...simulation.ahead].map((frame) => frame.shapes));
  if (!hasSameFields) fields.take(about);
  labels();
  requestAnimationFrame(() => app.about === about && panel.take(about));
  show(app.notice ?? notes.join("; "));
  app.notice = null;
  draw();
  if (!isSame) play(!matchMedia("(prefers-reduced-motion: reduce)").matches);
}

/** Sends the values of parameters and inputs. Resolves to the reason why they are impossible, if they are. */
async function put(about) {
  if (about.parameters.length + about.inputs.length === 0) return null;
  const { answer } = await engine.ask(valuesOf(about));
  return answer.is === "refused" ? answer.why : null;
}

/** Sends the values of the fields. Resolves to the reason why they are impossible, if they are. */
async function change() {
  await app.declaring;
  const refused = await put(app.about);
  if (!refused) app.simulation.change();
  return refused;
}

/** Changes a component of the state. From one that is impossible, such as beyond a stop, it returns to that before. */
async function place(n, value) {
  await app.declaring;
  play(false);
  const { simulation } = app;
  const { t, x: before } = simulation.now;
  const refused = await simulation.tryFrom(t, [...before].with(n, value));
  if (refused) await simulation.start(t, before);
  show(refused);
  draw();
}

// motion

function play(playing) {
  app.playing = playing;
  app.read = 0;
  $("play").textContent = playing ? "Pause" : "Play";
  $("play").setAttribute("aria-pressed", String(playing));
}

async function again() {
  await app.declaring;
  const { simulation, about } = app;
  if (!simulation) return;
  const refused = await simulation.start(0, about.start);
  show(refused);
  view.take(about.shapes, [simulation.now.shapes]);
  draw();
}

/** Moves the body that is held; while one place is computed, the last one waits. */
async function drag(request) {
  app.wanted = request;
  if (app.dragging || app.declaring || !app.simulation) return;
  app.dragging = true;
  app.held ??= app.playing;
  play(false);
  const { simulation } = app;
  while (app.wanted && simulation === app.simulation) {
    const wanted = app.wanted;
    app.wanted = null;
    const { answer, numbers } = await engine.ask({ do: "drag", t: simulation.now.t, x: [...simulation.now.x], ...wanted });
    if (answer.is === "state" && simulation === app.simulation) {
      simulation.show(numbers, simulation.now.t, answer.x);
      draw();
    }
  }
  app.dragging = false;
  if (app.dropped) drop();
}

function drop() {
  app.dropped = app.dragging;
  if (app.dragging || app.held === undefined) return;
  play(app.held);
  app.held = undefined;
}

const ms = (seconds) => `${Number((1000 * seconds).toPrecision(3))} ms`;
const short = (value, digits = 2) => (Number.isFinite(value) ? value.toExponential(digits) : "–");

/** Draws the mechanism; what is read follows at times if the mechanism moves, and at once if it rests. */
function draw() {
  const { simulation } = app;
  if (!simulation) return;
  const frame = simulation.now;
  view.draw(frame, simulation.past, { trail: $("trail").checked, text: `t = ${frame.t.toFixed(2)} s` });
  if (app.playing && app.last - app.read < READABLE) return;
  app.read = app.last;
  read(app);
  fields.draw(frame.x);
  panel.draw(simulation);
}

/** Writes the readings. */
function read({ simulation, about }) {
  const frame = simulation.now;
  const readings = [];
  if (about.has_energy) {
    const energy = frame.kinetic + frame.potential;
    readings.push(["Energy", `${energy.toPrecision(8)} J`], ["Change", `${short(energy - (simulation.energyAtStart ?? energy))} J`]);
  }
  if (simulation.error) {
    const { by, component } = simulation.error;
    readings.push([`Error since ${simulation.since.toFixed(1)} s`, `${short(by)} ${component.unit} in ${component.name}`]);
  }
  if (simulation.work) readings.push(["Evaluations", `${Math.round(simulation.work.evaluations / simulation.work.span || 0)} per second of motion`]);
  if (about.constraints.length > 0) readings.push(["Contact and sticking", frame.mode || "none"]);
  if (app.playing && simulation.slowness > 1) readings.push(["Computing", `${simulation.slowness.toFixed(1)} times slower than shown`]);
  if (simulation.crowd?.why) readings.push(["A thousand", simulation.crowd.why]);
  else if (simulation.crowd?.h) {
    const { h, error, span } = simulation.crowd;
    readings.push(["A thousand", `steps of ${ms(h)}, error ${short(error, 0)} in ${Number(span.toPrecision(3))} s`]);
  }
  if (simulation.stopped && simulation.ahead.length === 0) readings.push(["Stopped", simulation.stopped]);
  else if (frame.warning) readings.push(["Warning", frame.warning]);
  $("readings").replaceChildren(
    ...readings.map(([name, value]) => {
      const className = name === "Stopped" ? "bad" : "";
      return element("div", {}, element("dt", { textContent: name }), element("dd", { textContent: value, className }));
    }),
  );
}

function tick(now) {
  const { simulation } = app;
  const passed = Math.min(now - app.last, 100);
  app.last = now;
  if (simulation && app.playing) {
    app.owed += (passed / 1000) * 60;
    const whole = Math.floor(app.owed);
    if (whole > 0) {
      app.owed -= whole;
      if (!simulation.advance(whole)) play(false);
      draw();
      app.drawn++;
    }
  }
  $("stop").hidden = engine.busy < PATIENCE;
  // the worker has another mechanism while a text is compiled
  if (simulation && !app.declaring && app.held === undefined) simulation.prepare();
  requestAnimationFrame(tick);
}

// controls

function labels() {
  const isFixed = app.about?.has_fixed_steps ?? false;
  $("tolerance_row").hidden = isFixed;
  $("h_row").hidden = !isFixed;
  $("tolerance_value").textContent = chosen.tolerance.toExponential(0);
  $("h_value").textContent = ms(chosen.h);
  $("speed_value").textContent = chosen.speed;
  for (const id of ["tolerance", "h", "speed"]) $(id).setAttribute("aria-valuetext", $(`${id}_value`).textContent);
}

function connect() {
  $("method").append(...METHODS.map((name) => new Option(name)));
  $("gallery").append(new Option("none", "", false, false), ...examples.map(({ title }, n) => new Option(title, n)));
  $("gallery").onchange = () => write(examples[$("gallery").value]);
  $("play").onclick = () => {
    play(!app.playing);
    draw();
  };
  $("step").onclick = () => {
    play(false);
    app.simulation?.advance(1);
    draw();
  };
  $("again").onclick = again;
  $("stop").onclick = () => engine.stop("this was stopped by the button");
  $("canvas").onkeydown = (event) => {
    const action = { " ": $("play").onclick, ArrowRight: $("step").onclick, Home: again }[event.key];
    if (!action) return;
    event.preventDefault();
    action();
  };
  $("method").onchange = declare;
  for (const id of ["tolerance", "h"]) {
    $(id).oninput = () => {
      labels();
      app.simulation?.change();
    };
  }
  $("speed").oninput = labels;
  $("trail").onchange = draw;
  $("crowd").onchange = () => app.simulation?.endCrowd();
  $("link").onclick = async () => {
    history.replaceState(null, "", await toHash({ text: editor.text, files: app.files }));
    const isCopied = await navigator.clipboard?.writeText(location.href).then(() => true, () => false);
    show(isCopied ? "The link is copied; the address carries the declaration, too." : "The address now carries the declaration: copy it.");
  };
  $("file").onchange = async () => {
    const [file] = $("file").files;
    if (!file) return;
    const files = { ...app.files, [file.name]: await file.text() };
    $("file").value = "";
    $("gallery").value = "";
    write({ text: `pub Robot {\n    robot: urdf(${JSON.stringify(file.name)}),\n    gravity: [0, 0, -9.81],\n}\n`, files });
  };
  addEventListener("resize", draw);
  addEventListener("hashchange", open);
}

/** Replaces the declaration by another mechanism. */
function write({ text, files = {} }) {
  Object.assign(app, { files, fresh: true });
  editor.text = text;
}

async function open() {
  let linked = null;
  try {
    linked = await fromHash(location.hash);
  } catch {
    app.notice = "The link cannot be read; this is an example instead.";
  }
  const first = Math.max(0, examples.findIndex(({ title }) => title.includes(FIRST)));
  $("gallery").value = linked ? "" : first;
  write(linked ?? examples[first]);
}

connect();
labels();
requestAnimationFrame(tick);
open();
// for tests
window.pendulum = { app, editor, engine, examples };
