// The page: an editor, the mechanism in motion, and what is known about it.
import examples from "gallery";
import katexStyle from "styles";
import { Editor, proposal } from "./editor.js";
import { Engine } from "./engine.js";
import { fromHash, toHash } from "./link.js";
import { Panel } from "./panel.js";
import { Simulation } from "./simulation.js";
import { View } from "./view.js";

const METHODS = ["Vern9", "Taylor", "Rk4", "Rodas5P", "Gauss6", "Auto"];
const FIXED = ["Rk4", "Gauss6"];
const FIRST = "Point masses";

const $ = (id) => document.getElementById(id);
const style = document.createElement("style");
style.textContent = katexStyle;
document.head.append(style);

const engine = new Engine(window.pendulumModule);
const editor = new Editor($("editor"), { onChange: declare });
const view = new View($("canvas"), { onDrag: drag, onDrop: drop });
const panel = new Panel($("tabs"), $("panel"), engine);

/** What is shown: the mechanism, its motion, and files that were opened. */
const app = { view, about: null, simulation: null, playing: false, owed: 0, last: 0, files: {} };

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

function settings() {
  const fixed = FIXED.includes(chosen.method);
  return {
    by: { method: chosen.method, ...(fixed ? { h: chosen.h } : { tolerance: chosen.tolerance }) },
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
async function declare() {
  if (app.declaring) {
    app.again = true;
    return;
  }
  app.declaring = true;
  do {
    app.again = false;
    const began = performance.now();
    const { answer, took } = await engine.ask({ do: "declare", text: editor.text, files: app.files, method: chosen.method });
    app.compiled = { took, waited: performance.now() - began };
    if (answer.is === "mechanism") await take(answer);
    else complain(answer.is === "problems" ? answer.problems : [], answer.why);
  } while (app.again);
  app.declaring = false;
}

function complain(problems, why) {
  editor.mark(problems);
  const list = $("problems");
  list.replaceChildren();
  for (const problem of problems) {
    const item = document.createElement("li");
    const go = document.createElement("button");
    go.textContent = `Line ${problem.line}`;
    go.onclick = () => editor.go(problem);
    const help = document.createElement("span");
    help.className = "help";
    help.textContent = ` ${problem.help}`;
    item.append(go, ` ${problem.message} [${problem.code}].`, help);
    const name = proposal(problem.help);
    if (name) {
      const fix = document.createElement("button");
      fix.textContent = `Write ${name}`;
      fix.onclick = () => editor.fix(editor.view, problem, name);
      item.append(" ", fix);
    }
    list.append(item);
  }
  if (why) list.append(Object.assign(document.createElement("li"), { textContent: why }));
}

/** Shows a mechanism. One with the same state as before goes on from where it is, with the parameters that were set. */
async function take(about) {
  complain([]);
  const names = (of) => JSON.stringify(of?.components.map(({ name }) => name));
  const kept = app.simulation?.now && names(about) === names(app.about) ? app.simulation.now : null;
  for (const own of about.parameters) {
    const before = app.about?.parameters.find(({ name, declared }) => name === own.name && declared === own.value);
    own.declared = own.value;
    if (before) own.value = before.value;
  }
  app.about = about;
  app.ready = false;
  app.simulation = new Simulation(engine, about, settings);
  await put();
  const refused = await app.simulation.start(kept?.t ?? 0, kept?.x ?? about.start);
  if (refused) {
    const again = kept && (await app.simulation.start(0, about.start));
    show(again === null ? "" : refused);
  } else {
    show(about.notes.join("; "));
  }
  if (!app.simulation.now) return;
  await app.simulation.prepare();
  view.take(about.shapes, [app.simulation.now, ...app.simulation.ahead].map((frame) => frame.shapes));
  sliders();
  app.ready = true;
  requestAnimationFrame(() => app.about === about && panel.take(about));
  if (!kept) play(!matchMedia("(prefers-reduced-motion: reduce)").matches);
}

/** Sends the values of parameters and inputs. */
async function put() {
  const values = app.about.parameters.map(({ value }) => value);
  const inputs = app.about.inputs.map(({ value }) => value);
  if (values.length + inputs.length === 0) return true;
  const { answer } = await engine.ask({ do: "set", values, inputs });
  if (answer.is === "refused") {
    show(answer.why);
    // a worker that was ended has forgotten the mechanism
    if (answer.stopped) declare();
    return false;
  }
  return true;
}

// parameters and states

function field(label, { min, max, step }, value) {
  const element = document.createElement("label");
  const text = document.createElement("span");
  text.className = "name";
  text.textContent = label.name;
  text.title = label.docs || label.name;
  const number = Object.assign(document.createElement("input"), { type: "number", step: "any", value });
  number.setAttribute("aria-label", `${label.name}, ${label.unit || "no unit"}`);
  const unit = Object.assign(document.createElement("span"), { className: "unit", textContent: label.unit });
  const range = Object.assign(document.createElement("input"), { type: "range", min, max, step });
  range.value = value;
  range.setAttribute("aria-label", `${label.name}, slider`);
  element.append(text, range, number, unit);
  return { element, range, number };
}

function sliders() {
  const { about } = app;
  const list = $("parameters");
  list.replaceChildren();
  for (const own of [...about.parameters, ...about.inputs]) {
    const most = own.declared > 0 ? 3 * own.declared : Math.max(10, 3 * Math.abs(own.declared ?? 0));
    const least = own.declared > 0 ? 0 : -most;
    const { element, range, number } = field(own, { min: least, max: most, step: (most - least) / 300 }, own.value);
    const change = async (typed) => {
      const value = Math.min(Math.max(typed, least), most);
      const before = own.value;
      own.value = Number.isFinite(value) ? value : before;
      show(own.value === typed ? "" : `${own.name} goes from ${least} to ${most}: ${Number(own.value.toPrecision(6))} is set`);
      if (!(await put())) own.value = before;
      range.value = number.value = Number(own.value.toPrecision(8));
      if (own.value !== before) await app.simulation.change();
    };
    range.oninput = () => change(Number(range.value));
    number.onchange = () => change(number.value === "" ? NaN : Number(number.value));
    list.append(element);
  }
  list.parentElement.hidden = list.childElementCount === 0;
  const states = $("state");
  states.replaceChildren();
  app.fields = about.components.map((component, n) => {
    const { element, range, number } = field(component, {}, 0);
    range.remove();
    number.onchange = async () => {
      play(false);
      const x = [...app.simulation.now.x];
      x[n] = Number(number.value);
      const refused = await app.simulation.start(app.simulation.now.t, x);
      show(refused);
      draw();
    };
    states.append(element);
    return number;
  });
}

// motion

function play(playing) {
  app.playing = playing;
  $("play").textContent = playing ? "Pause" : "Play";
  $("play").setAttribute("aria-pressed", String(playing));
}

async function again() {
  if (!app.simulation) return;
  show(await app.simulation.start(0, app.about.start));
  draw();
}

async function drag(request) {
  if (app.dragging || !app.simulation?.now) return;
  app.dragging = true;
  app.held ??= app.playing;
  play(false);
  const { simulation } = app;
  const { answer, numbers } = await engine.ask({ do: "drag", t: simulation.now.t, x: [...simulation.now.x], ...request });
  if (answer.is === "state" && simulation === app.simulation) {
    simulation.epoch++;
    Object.assign(simulation, { ahead: [], busy: false, stopped: null, past: [], sections: [] });
    simulation.show(numbers, simulation.now.t, answer.x);
    draw();
  }
  app.dragging = false;
  if (app.dropped) drop();
}

async function drop() {
  app.dropped = app.dragging;
  if (app.dragging || app.held === undefined) return;
  const { held } = app;
  app.held = undefined;
  await app.simulation.change();
  play(held);
}

const short = (value, digits = 2) => (Number.isFinite(value) ? value.toExponential(digits) : "–");

function draw() {
  const { simulation, about } = app;
  if (!simulation?.now || !app.ready) return;
  const frame = simulation.now;
  view.draw(frame, simulation.past, { trail: $("trail").checked, text: `t = ${frame.t.toFixed(2)} s` });
  const energy = frame.kinetic + frame.potential;
  const readings = [["Time", `${frame.t.toFixed(2)} s`]];
  if (about.has_energy) readings.push(["Energy", `${energy.toPrecision(8)} J`], ["Change", `${short(energy - (simulation.energyAtStart ?? energy))} J`]);
  if ($("reference").checked) readings.push(["Error", short(simulation.error ?? NaN)]);
  if (simulation.work) readings.push(["Evaluations", `${Math.round(simulation.work.evaluations / simulation.work.span || 0)} per s`]);
  if (about.constraints.length > 0) readings.push(["Holding", frame.mode || "nothing"]);
  if (simulation.stopped && simulation.ahead.length === 0) readings.push(["Stopped", simulation.stopped]);
  else if (simulation.warnings?.length) readings.push(["Doubtful", simulation.warnings.at(-1)]);
  $("readings").replaceChildren(
    ...readings.map(([name, value]) => {
      const entry = document.createElement("div");
      entry.append(Object.assign(document.createElement("dt"), { textContent: name }));
      entry.append(Object.assign(document.createElement("dd"), { textContent: value, className: name === "Stopped" ? "bad" : "" }));
      return entry;
    }),
  );
  app.fields?.forEach((input, n) => {
    if (document.activeElement !== input) input.value = Number(frame.x[n].toPrecision(8));
  });
  panel.draw(simulation);
}

function tick(now) {
  const { simulation } = app;
  const passed = Math.min(now - app.last, 100);
  app.last = now;
  if (simulation?.now && app.ready && app.playing) {
    app.owed += (passed / 1000) * 60;
    const whole = Math.floor(app.owed);
    if (whole > 0) {
      app.owed -= whole;
      if (!simulation.advance(whole)) play(false);
      draw();
      app.drawn = (app.drawn ?? 0) + 1;
    }
  }
  if (simulation?.now && app.ready && app.held === undefined) simulation.prepare();
  requestAnimationFrame(tick);
}

// controls

function labels() {
  const fixed = FIXED.includes(chosen.method);
  $("tolerance_row").hidden = fixed;
  $("h_row").hidden = !fixed;
  $("tolerance_value").textContent = chosen.tolerance.toExponential(0);
  $("h_value").textContent = `${Number((1000 * chosen.h).toPrecision(3))} ms`;
  $("speed_value").textContent = chosen.speed;
}

function connect() {
  $("method").append(...METHODS.map((name) => new Option(name)));
  $("gallery").append(...examples.map(({ title }, n) => new Option(title, n)));
  $("gallery").onchange = () => example($("gallery").value);
  $("play").onclick = () => play(!app.playing);
  $("step").onclick = () => {
    play(false);
    app.simulation?.advance(1);
    draw();
  };
  $("again").onclick = again;
  $("canvas").onkeydown = (event) => {
    const action = { " ": $("play").onclick, ArrowRight: $("step").onclick, Home: again }[event.key];
    if (!action) return;
    event.preventDefault();
    action();
  };
  $("method").onchange = () => {
    labels();
    declare();
  };
  for (const id of ["tolerance", "h", "speed", "twin", "reference", "crowd"]) {
    $(id).oninput = () => {
      labels();
      app.simulation?.change();
    };
  }
  $("trail").onchange = draw;
  $("link").onclick = async () => {
    const hash = await toHash(editor.text);
    history.replaceState(null, "", hash);
    await navigator.clipboard?.writeText(location.href).catch(() => {});
    show("The address now carries the declaration.");
  };
  $("file").onchange = async () => {
    const [file] = $("file").files;
    if (!file) return;
    app.files = { ...app.files, [file.name]: await file.text() };
    app.about = app.simulation = null;
    editor.text = `pub Robot {\n    robot: urdf("${file.name}"),\n    gravity: [0, 0, -9.81],\n}\n`;
  };
  addEventListener("resize", draw);
  addEventListener("hashchange", open);
}

function example(n) {
  app.about = app.simulation = null;
  app.files = examples[n].files ?? {};
  editor.text = examples[n].text;
}

async function open() {
  let text = null;
  try {
    text = await fromHash(location.hash);
  } catch {
    show("The link cannot be read; this is an example instead.");
  }
  if (text !== null) {
    editor.text = text;
    return;
  }
  $("gallery").value = Math.max(0, examples.findIndex(({ title }) => title.includes(FIRST)));
  example($("gallery").value);
}

connect();
labels();
requestAnimationFrame(tick);
open();
// for tests
window.pendulum = { app, editor, engine, examples };
