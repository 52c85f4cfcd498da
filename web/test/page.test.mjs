// The page in a browser: `node --test test/`, after `node build.mjs`. PAGE is the file, CHROMIUM the browser.
import assert from "node:assert/strict";
import { existsSync, mkdirSync, readFileSync, statSync } from "node:fs";
import { dirname, join, resolve } from "node:path";
import { after, before, test } from "node:test";
import { fileURLToPath, pathToFileURL } from "node:url";
import { launched, watched } from "../browser.mjs";

const here = dirname(fileURLToPath(import.meta.url));
const file = resolve(process.env.PAGE ?? join(here, "../../out/pendulum.html"));
const url = pathToFileURL(file).href;
const pictures = join(dirname(file), "pictures");
const PENDULUM = `pub Pendulum {
    params { m: kg = 1, l: m = 1, g: m/s^2 = 9.81 }
    gravity: [0, -g, 0],
    body bob on ground { solids: [point(m, [0, -l, 0])], joint: revolute(z), coordinate: theta }
}
`;

assert.ok(existsSync(file), `${file} is missing: run node build.mjs`);
mkdirSync(pictures, { recursive: true });
let browser;

before(async () => {
  browser = await launched();
});
after(() => browser?.close());

/** Opens the page and waits until a mechanism moves. Errors and requests of the page fail the test at its end. */
async function opened(t, { hash = "", init, still = false, ...options } = {}) {
  const page = await watched(t, browser, options);
  if (init) await page.addInitScript(init);
  await page.goto(url + hash);
  if (!still) await moves(page);
  return page;
}

const time = (page) => page.evaluate(() => window.pendulum.app.simulation?.now?.t ?? 0);
const moves = (page) => page.waitForFunction(() => window.pendulum?.app.simulation?.now?.t > 0);

/** Waits until the time passes that of now. */
async function goesOn(page) {
  const now = await time(page);
  await page.waitForFunction((from) => window.pendulum.app.simulation.now.t > from, now);
}

/** Replaces the declaration, as typing does. */
async function declare(page, text) {
  await page.evaluate((text) => (window.pendulum.editor.text = text), text);
  const name = /pub (\w+)/.exec(text)[1];
  await page.waitForFunction((name) => !window.pendulum.app.declaring && window.pendulum.app.about?.name === name, name);
}

const ask = (page, request) =>
  page.evaluate(async (request) => {
    const { answer, numbers, took } = await window.pendulum.engine.ask(request);
    return { answer, numbers: [...numbers], took };
  }, request);

const bitsOf = (numbers) => {
  const view = new DataView(new ArrayBuffer(8));
  return numbers.map((number) => {
    view.setFloat64(0, number);
    return view.getBigUint64(0).toString(16).padStart(16, "0");
  });
};

test("moves from a file, without errors or requests", async (t) => {
  const page = await opened(t);
  const began = await page.evaluate(() => performance.now());
  t.diagnostic(`moved within ${Math.round(began)} ms of the start of the page`);
  await page.waitForTimeout(1500);
  await page.screenshot({ path: join(pictures, "page.png"), fullPage: true });
});

test("the page is one file of at most 2.5 MB", () => {
  assert.ok(statSync(file).size <= 2.5e6, statSync(file).size);
});

test("the first example moves before the module is compiled, as the worker computes it", async (t) => {
  const init = () => {
    const post = Worker.prototype.postMessage;
    window.held = [];
    window.asked = [];
    Worker.prototype.postMessage = function (message, ...rest) {
      if (message.request) window.asked.push(message.request.do);
      if (message.packed) window.held.push(() => post.call(this, message, ...rest));
      else post.call(this, message, ...rest);
    };
  };
  const page = await opened(t, { init });
  const shown = await page.evaluate(() => {
    const { now, ahead, past } = window.pendulum.app.simulation;
    return { asked: window.asked, frames: [...past, now, ...ahead].map(({ t, x, reference }) => [t, ...x, ...reference.x]) };
  });
  // all but the declaration, which the worker needs, is known
  assert.deepEqual([...new Set(shown.asked)].filter((request) => request !== "move"), ["declare"]);
  await page.evaluate(() => window.held.forEach((post) => post()));
  const start = await page.evaluate(() => window.pendulum.app.about.start);
  const computed = await ask(page, { do: "move", by: { method: "Vern9", tolerance: 1e-9 }, span: [0, 0.1], x: start, frames: 6 });
  const width = computed.answer.width;
  const own = Array.from({ length: 6 }, (_, n) => computed.numbers.slice(n * width, n * width + 1 + start.length));
  const first = shown.frames.filter(([t]) => t > 0 && t < 0.11);
  const of = new Map(first.map((frame) => [frame[0], frame.slice(0, 1 + start.length)]));
  for (const frame of own) if (of.has(frame[0])) assert.deepEqual(bitsOf(of.get(frame[0])), bitsOf(frame));
  assert.ok(own.some((frame) => of.has(frame[0])));
  await goesOn(page);
  await page.waitForFunction(() => window.pendulum.app.simulation.now.t > 1);
});

test("a mistake is marked at its token, and the fix moves again", async (t) => {
  const page = await opened(t);
  await declare(page, PENDULUM);
  await page.evaluate((text) => (window.pendulum.editor.text = text), PENDULUM.replace("revolute", "revolut"));
  await page.waitForSelector(".cm-lintRange-error");
  assert.equal(await page.textContent(".cm-lintRange-error"), "revolut");
  assert.match(await page.textContent("#problems"), /Line 4 .*did you mean `revolute`\?/s);
  await page.screenshot({ path: join(pictures, "mistake.png") });
  await page.click("#problems >> text=Write revolute");
  await page.waitForFunction(() => document.querySelectorAll("#problems li").length === 0);
  assert.equal(await page.evaluate(() => window.pendulum.editor.text), PENDULUM);
  await goesOn(page);
});

test("typing moves on from where the mechanism is", async (t) => {
  const page = await opened(t);
  await declare(page, PENDULUM);
  await goesOn(page);
  const before = await time(page);
  await page.click(".cm-content");
  await page.keyboard.press("Control+End");
  await page.keyboard.type("// twice as long");
  await page.waitForFunction(() => !window.pendulum.app.declaring);
  await goesOn(page);
  assert.ok((await time(page)) > before && before > 0);
  const took = await page.evaluate(() => window.pendulum.app.took);
  t.diagnostic(`a pendulum is compiled in ${took.toFixed(1)} ms`);
});

test("times from a keystroke to motion", async (t) => {
  const page = await opened(t);
  for (const title of ["Point masses", "UR5"]) {
    const measured = await page.evaluate(async (title) => {
      const { app, editor, examples } = window.pendulum;
      const { text, files } = examples.find((own) => own.title.includes(title));
      app.files = files ?? {};
      const once = async () => {
        const began = performance.now();
        const before = app.simulation;
        editor.text = `${text}// ${began}`;
        while (app.simulation === before) await new Promise((next) => setTimeout(next));
        return performance.now() - began;
      };
      const all = [];
      for (let n = 0; n < 7; n++) all.push(await once());
      return { first: all[0], median: all.sort((a, b) => a - b)[3], compiled: app.took };
    }, title);
    t.diagnostic(`${title}: ${measured.median.toFixed(0)} ms, at first ${measured.first.toFixed(0)}; compiled in ${measured.compiled.toFixed(0)}`);
  }
});

test("a body follows the pointer, and moves on from there", async (t) => {
  const page = await opened(t);
  await declare(page, PENDULUM);
  await page.click("#play");
  const tip = () => page.evaluate(() => [...window.pendulum.app.simulation.now.shapes.slice(0, 2)]);
  const place = await page.evaluate(() => {
    const { view } = window.pendulum.app;
    const [x, y] = window.pendulum.app.simulation.now.shapes;
    const canvas = document.getElementById("canvas");
    const box = canvas.getBoundingClientRect();
    return { bob: [box.x + view.on.x(x), box.y + view.on.y(y)], pivot: [box.x + view.on.x(0), box.y + view.on.y(0)], scale: view.on.scale };
  });
  await page.mouse.move(...place.bob);
  await page.mouse.down();
  await page.mouse.move(place.pivot[0] + place.scale, place.pivot[1], { steps: 8 });
  await page.mouse.up();
  await page.waitForFunction(() => window.pendulum.app.held === undefined && !window.pendulum.app.dragging);
  const [x, y] = await tip();
  assert.ok(Math.abs(x - 1) < 0.02 && Math.abs(y) < 0.05, `${x} ${y}`);
  await page.click("#play");
  await goesOn(page);
});

test("companions and speed leave the motion alone; sections are cut anew", async (t) => {
  const page = await opened(t);
  const kept = () => page.evaluate(() => ({ energy: window.pendulum.app.simulation.energyAtStart, since: window.pendulum.app.simulation.since }));
  const before = await kept();
  await page.evaluate(() => {
    const speed = document.getElementById("speed");
    speed.value = 1;
    speed.dispatchEvent(new Event("input"));
  });
  await page.check("#twin");
  await goesOn(page);
  assert.deepEqual(await kept(), before);
  await page.click('#tabs >> text="Section"');
  await page.waitForFunction(() => window.pendulum.app.simulation.passages.length > 2);
  await page.getByLabel("rises through").fill("0.3");
  await page.getByLabel("rises through").press("Enter");
  await page.waitForFunction(() => window.pendulum.app.simulation.passages.length === 0);
  await page.waitForFunction(() => window.pendulum.app.simulation.passages.length > 1);
  const on = await page.evaluate(() => window.pendulum.app.simulation.passages.map((x) => x[0]));
  assert.ok(on.every((x) => Math.abs(Math.sin((x - 0.3) / 2)) < 1e-6), on);
});

test("sliders act at once, and clamp with a note", async (t) => {
  const page = await opened(t);
  await declare(page, PENDULUM);
  const slider = page.getByLabel("l, slider");
  await slider.focus();
  await page.keyboard.press("ArrowRight");
  await page.waitForFunction(() => window.pendulum.app.about.parameters[1].value > 1);
  await goesOn(page);
  const number = page.getByLabel("l, m");
  await number.fill("50");
  await number.press("Enter");
  await page.waitForFunction(() => document.getElementById("note").textContent.includes("l goes from"));
  assert.equal(await number.inputValue(), "3");
  // a length that no pendulum has
  await number.fill("0");
  await number.press("Enter");
  await page.waitForFunction(() => {
    const text = document.getElementById("note").textContent;
    return text !== "" && !text.startsWith("l goes from");
  });
  assert.notEqual(await number.inputValue(), "0");
});

test("fields of any sign clamp with a note, and states that are impossible are not taken", async (t) => {
  const page = await opened(t);
  const declared = PENDULUM.replace("params {", "params { k: N m = -2,").replace("coordinate: theta", "coordinate: theta, stop: [-0.5, 0.5] restitution(0.5), torque: k + u");
  await declare(page, declared.replace("    gravity", "    input u: N m,\n    gravity"));
  const note = (start) => page.waitForFunction((start) => document.getElementById("note").textContent.startsWith(start), start);
  const type = async (label, text) => {
    await page.getByLabel(label).fill(text);
    await page.getByLabel(label).press("Enter");
  };
  for (const [label, text, set] of [["k, N m", "1e300", 10], ["k, N m", "-1e9", -10], ["u, N m", "11", 10], ["u, N m", "-11", -10]]) {
    await type(label, text);
    await note(`${label[0]} goes from -10 to 10: ${set} is set`);
    assert.equal(await page.getByLabel(label).inputValue(), String(set));
    assert.equal(await page.getByLabel(`${label[0]}, slider`).inputValue(), String(set));
  }
  for (const text of ["0.3", "0.7", "1e300"]) {
    await type("theta, rad", text);
    if (text !== "0.3") await note("`theta` starts at");
    await page.waitForFunction(() => window.pendulum.app.simulation.now.x[0] === 0.3);
  }
});

test("a looser tolerance takes less work, and shows a larger error", async (t) => {
  const page = await opened(t);
  const measured = async () => {
    await page.waitForFunction(() => {
      const { since, now, error, work } = window.pendulum.app.simulation;
      return error && work && now.t > since + 1;
    });
    return page.evaluate(() => ({ error: window.pendulum.app.simulation.error.by, steps: window.pendulum.app.simulation.work.steps }));
  };
  const tight = await measured();
  await page.getByLabel("Tolerance").fill("-3");
  await page.waitForFunction(() => window.pendulum.app.simulation.since > 1);
  const loose = await measured();
  assert.ok(loose.error > 100 * tight.error && loose.steps < tight.steps, JSON.stringify({ tight, loose }));
  assert.match(await page.textContent("#readings"), /Energy.*Change.*Error since.*Evaluations/s);
});

test("friction that sticks is named", async (t) => {
  const page = await opened(t);
  await page.selectOption("#gallery", { label: "Block on a belt" });
  await page.waitForFunction(() => /Contact and sticking(?!none)/.test(document.getElementById("readings").textContent));
});

test("a robot's file opens", async (t) => {
  const page = await opened(t);
  await page.setInputFiles("#file", join(here, "../../testbed/data/urdf/declared/ur5.urdf"));
  await page.waitForFunction(() => window.pendulum.app.about.components.length === 12 && !window.pendulum.app.declaring);
  await goesOn(page);
});

test("operations and generated code are shown", async (t) => {
  const page = await opened(t);
  await declare(page, PENDULUM);
  for (const [tab, content] of [["Operations", /^FunctionForm.*rhs/s], ["Rust", /^Copy.*impl .* for Pendulum/s], ["C", /^Copy.*void \w+\(/s]]) {
    await page.click(`#tabs >> text="${tab}"`);
    await page.waitForFunction((content) => content.test(document.getElementById("panel").textContent), content);
  }
});

test("energy without friction stays within 1e-9 for a minute", async (t) => {
  const page = await opened(t);
  await declare(page, PENDULUM);
  await page.evaluate(() => {
    document.getElementById("tolerance").value = -12;
    const speed = document.getElementById("speed");
    speed.value = 2;
    speed.dispatchEvent(new Event("input"));
  });
  await page.click("#again");
  await page.waitForFunction(() => window.pendulum.app.simulation.past[0]?.t < 0.1);
  await page.waitForFunction(() => window.pendulum.app.simulation.now.t > 60, null, { timeout: 60000 });
  const drift = await page.evaluate(() => {
    const { past, energyAtStart } = window.pendulum.app.simulation;
    return Math.max(...past.map((frame) => Math.abs(frame.kinetic + frame.potential - energyAtStart)));
  });
  t.diagnostic(`largest change ${drift.toExponential(1)} J of 9.81 J`);
  assert.ok(drift < 1e-9, drift);
});

test("bits after 1e5 steps, and through stops, walls and friction, are those of other machines", async (t) => {
  const cases = JSON.parse(readFileSync(join(here, "../tests/bits.json"), "utf8"));
  const page = await opened(t);
  await page.click("#play");
  await page.evaluate(() => (window.pendulum.app.simulation = null));
  for (const { text, request, x } of cases.reverse()) {
    await ask(page, { do: "declare", text, method: "Vern9" });
    const { answer, took } = await ask(page, request);
    t.diagnostic(`${answer.steps} steps of ${request.by.method} in ${took.toFixed(0)} ms`);
    assert.deepEqual(bitsOf(answer.x), x);
  }
  // lanes compute the same as one motion alone
  const about = await ask(page, { do: "declare", text: PENDULUM, method: "Vern9" });
  assert.equal(about.answer.shapes[0].kind, "Mass");
  await ask(page, { do: "gather", t: 0, x: [2, 0], count: 7, spread: 1e-3 });
  const all = await ask(page, { do: "move_all", span: [0, 1], frames: 1 });
  const by = { method: "Rk4", h: all.answer.accuracy.h };
  const one = await ask(page, { do: "move", by, span: [0, 1], x: [2 + 1e-3 * (3 / 6 - 0.5), 0], frames: 1 });
  // after the time, the line to the mass; after time, state and energy, its ends
  assert.deepEqual(bitsOf(all.numbers.slice(1 + 3 * 6, 1 + 4 * 6)), bitsOf(one.numbers.slice(5, 5 + 6)));
});

test("a thousand pendulums, a neighbour and plots", async (t) => {
  const page = await opened(t);
  await page.check("#crowd");
  await page.check("#twin");
  await page.waitForFunction(() => window.pendulum.app.simulation.now.crowd?.length >= 12000 && window.pendulum.app.simulation.now.twin);
  const away = await page.evaluate(() => {
    const { now } = window.pendulum.app.simulation;
    // the line of the first mass; the middle ones are on both sides of the motion itself
    const width = now.crowd.length / 1000;
    const nearest = [499, 500].map((n) => Math.max(...now.shapes.slice(0, 6).map((value, k) => Math.abs(value - now.crowd[n * width + k]))));
    return { nearest: Math.max(...nearest), twin: Math.max(...now.shapes.map((value, k) => Math.abs(value - now.twin.shapes[k]))) };
  });
  assert.ok(away.nearest < 1e-4 && away.nearest > 0 && away.twin < 1e-4 && away.twin > 0, JSON.stringify(away));
  const rate = await page.evaluate(async () => {
    const { app } = window.pendulum;
    const [from, began] = [app.drawn, performance.now()];
    await new Promise((next) => setTimeout(next, 2000));
    return ((app.drawn - from) / (performance.now() - began)) * 1000;
  });
  t.diagnostic(`${rate.toFixed(1)} frames per second with 1000 pendulums, neighbour and reference`);
  await page.screenshot({ path: join(pictures, "thousand.png") });
  for (const tab of ["Operations", "Energy", "Phase portrait", "Section", "Rust", "C", "Equations"]) {
    await page.click(`#tabs >> text="${tab}"`);
    await page.waitForTimeout(tab === "Section" ? 3000 : 400);
    await page.locator("#about").screenshot({ path: join(pictures, `${tab.toLowerCase().replace(" ", "_")}.png`) });
  }
});

test("all examples move", async (t) => {
  const page = await opened(t);
  const count = await page.evaluate(() => window.pendulum.examples.length);
  assert.ok(count > 20, count);
  const stuck = [];
  for (let n = 0; n < count; n++) {
    await page.selectOption("#gallery", String(n));
    const title = await page.evaluate((n) => window.pendulum.examples[n].title, n);
    try {
      const changes = () => {
        const { about, simulation } = window.pendulum.app;
        const { past, now } = simulation;
        const differs = (own) => past[0] && own(past[0]).some((value, n) => Math.abs(value - own(now)[n]) > 1e-6);
        return about.shapes.length > 0 ? differs(({ shapes }) => shapes) : differs(({ x }) => x);
      };
      await page.waitForFunction(changes, null, { timeout: 15000 });
    } catch {
      stuck.push(`${title}: ${await page.textContent("#note")} ${await page.textContent("#problems")}`);
    }
  }
  assert.deepEqual(stuck, []);
});

test("examples that are chosen quickly: the last one moves", async (t) => {
  const page = await opened(t);
  for (const pause of [0, 5, 20, 60]) {
    const wanted = await page.evaluate(async (pause) => {
      const select = document.getElementById("gallery");
      for (const n of [4, 13, 20, 5, 28, 0, 9]) {
        select.value = n;
        select.dispatchEvent(new Event("change"));
        document.getElementById("again").click();
        document.getElementById("speed").dispatchEvent(new Event("input"));
        await new Promise((next) => setTimeout(next, pause));
      }
      return /pub (\w+)/.exec(window.pendulum.editor.text)[1];
    }, pause);
    await page.waitForFunction((name) => window.pendulum.app.about.name === name && !window.pendulum.app.declaring, wanted);
    await goesOn(page);
  }
});

test("a link carries the declaration", async (t) => {
  const page = await opened(t);
  await declare(page, PENDULUM);
  await page.click("#link");
  await page.waitForFunction(() => location.hash.startsWith("#d="));
  const hash = await page.evaluate(() => location.hash);
  const other = await opened(t, { hash });
  assert.equal(await other.evaluate(() => window.pendulum.editor.text), PENDULUM);
  const plain = await opened(t, { hash: `#text=${encodeURIComponent(PENDULUM)}` });
  assert.equal(await plain.evaluate(() => window.pendulum.app.about.name), "Pendulum");
  const broken = await opened(t, { hash: "#d=garbage" });
  assert.match(await broken.textContent("#note"), /cannot be read/);
});

test("declarations of the book open here", async (t) => {
  const page = await browser.newPage();
  t.after(() => page.close());
  await page.goto(url.replace(/[^/]*$/, ""));
  await page.evaluate(
    ([script, code]) => {
      document.body.innerHTML = "<main><pre><code class='language-rust'></code></pre></main>";
      document.querySelector("code").textContent = code;
      (0, eval)(script);
    },
    [
      readFileSync(join(here, "../../docs/open.js"), "utf8"),
      `fn main() {\n    mechanism! {\n${PENDULUM.replace(/^(?=.)/gm, "        ")}    }\n}\nmechanism! { pub Other { body a on ground { mass: 1 } } }\n`,
    ],
  );
  const links = await page.$$eval("a.open-declaration", (all) => all.map(({ textContent, href }) => [textContent, href]));
  assert.deepEqual(links.map(([text]) => text), ["Open Pendulum in motion", "Open Other in motion"]);
  const other = await opened(t, { hash: new URL(links[0][1]).hash });
  assert.equal(await other.evaluate(() => window.pendulum.editor.text), PENDULUM);
});

test("a computation that takes long can be stopped", async (t) => {
  const page = await opened(t);
  await declare(page, PENDULUM);
  const answer = page.evaluate(async () => {
    const by = { method: "Rk4", h: 1e-7 };
    return (await window.pendulum.engine.ask({ do: "move", by, span: [0, 100], x: [2, 0], frames: 1 })).answer;
  });
  await page.click("#stop");
  assert.match((await answer).why, /stopped by the button/);
  await page.waitForSelector("#stop", { state: "hidden" });
  await page.click("#again");
  await page.waitForFunction(() => window.pendulum.app.simulation.now.t < 1);
  if ((await page.getAttribute("#play", "aria-pressed")) === "false") await page.click("#play");
  await goesOn(page);
});

test("texts of any kind are answered, and a good one moves afterwards", async (t) => {
  const page = await opened(t);
  const texts = ["", "}", '"', "pub", "\u{1f600}\u0000", "(".repeat(20000), "pub A { params { a: m = 1e999 } }", `pub A { let x = ${"(".repeat(3000)}1${")".repeat(3000)} }`];
  for (const text of texts) {
    await page.evaluate((text) => (window.pendulum.editor.text = text), text);
    await page.waitForFunction(() => !window.pendulum.app.declaring && document.querySelectorAll("#problems li").length > 0);
  }
  await declare(page, PENDULUM);
  await goesOn(page);
});

test("walls are drawn where they are", async (t) => {
  const page = await opened(t);
  await declare(page, PENDULUM.replace("    body", "    point tip on bob at [0, -l, 0],\n    wall floor { gap: tip.y + 0.6 },\n    body"));
  await goesOn(page);
  await page.click("#play");
  const rows = await page.evaluate(() => {
    const { view } = window.pendulum.app;
    const context = view.canvas.getContext("2d");
    const ratio = view.canvas.width / view.canvas.clientWidth;
    const drawn = (y) => {
      const { data } = context.getImageData(0, Math.round(y * ratio), view.canvas.width, 1);
      return data.filter((_, n) => n % 4 === 3 && data[n] > 0).length / view.canvas.width;
    };
    return { on: drawn(view.on.y(-0.6)), above: drawn(view.on.y(-0.6) - 12), below: drawn(view.on.y(-0.6) + 3) };
  });
  assert.ok(rows.on > 0.99 && rows.above < 0.2 && rows.below > 0.1, JSON.stringify(rows));
  await page.locator("#canvas").screenshot({ path: join(pictures, "wall.png") });
});

test("equations follow after the motion, and stay while someone types", async (t) => {
  const page = await opened(t);
  await declare(page, PENDULUM);
  await page.waitForSelector("#panel .katex");
  await page.evaluate(() => (window.texts = new MutationObserver(() => (window.lost ||= !document.querySelector("#panel .katex"))).observe(document.getElementById("panel"), { childList: true, subtree: true })));
  await page.click(".cm-content");
  await page.keyboard.press("Control+End");
  await page.keyboard.type("// more");
  const before = await page.textContent("#panel");
  await declare(page, PENDULUM.replace("gravity: [0, -g, 0]", "gravity: [0, -2*g, 0]"));
  await page.waitForFunction((before) => document.getElementById("panel").textContent !== before, before);
  assert.equal(await page.evaluate(() => window.lost), false);
});

test("what is printed comes from a worker that the next text ends", async (t) => {
  const init = () => {
    const { postMessage, terminate } = Worker.prototype;
    window.asked = new Map();
    window.ended = new Set();
    Worker.prototype.postMessage = function (message, ...rest) {
      if (!window.asked.has(this)) window.asked.set(this, new Set());
      window.asked.get(this).add(message.request?.do);
      return postMessage.call(this, message, ...rest);
    };
    Worker.prototype.terminate = function () {
      window.ended.add(this);
      return terminate.call(this);
    };
  };
  const page = await opened(t, { init });
  const printing = () => page.waitForFunction(() => [...window.asked].some(([worker, requests]) => requests.has("describe") && !window.ended.has(worker)));
  await printing();
  await declare(page, PENDULUM);
  await printing();
  const seen = await page.evaluate(() => [...window.asked].map(([worker, requests]) => [requests.has("move"), requests.has("describe"), window.ended.has(worker)]));
  assert.deepEqual(seen, [[true, false, false], [false, true, true], [false, true, false]]);
});

test("a worker that is ended starts again", async (t) => {
  const page = await opened(t);
  await page.waitForFunction(() => window.pendulum.engine.module);
  await page.evaluate(() => window.pendulum.engine.stop("stopped"));
  await page.click("#again");
  await page.waitForFunction(() => window.pendulum.app.simulation.now.t === 0 || window.pendulum.app.simulation.past[0]?.t < 0.1);
  if ((await page.getAttribute("#play", "aria-pressed")) === "false") await page.click("#play");
  await goesOn(page);
  await declare(page, PENDULUM);
  await goesOn(page);
});

test("phones: nothing is wider than the screen", async (t) => {
  const page = await opened(t, { viewport: { width: 390, height: 800 }, hasTouch: true });
  const width = await page.evaluate(() => document.documentElement.scrollWidth);
  assert.ok(width <= 390, width);
  await page.screenshot({ path: join(pictures, "phone.png"), fullPage: true });
});

test("dark and light", async (t) => {
  const back = (page) => page.evaluate(() => getComputedStyle(document.body).backgroundColor);
  const page = await opened(t, { colorScheme: "dark" });
  assert.deepEqual([await back(page), await back(await opened(t))], ["rgb(22, 24, 27)", "rgb(251, 251, 249)"]);
  await page.waitForTimeout(800);
  await page.screenshot({ path: join(pictures, "dark.png"), fullPage: true });
});

test("keyboard and names of controls", async (t) => {
  const page = await opened(t);
  await page.focus("#canvas");
  await page.keyboard.press(" ");
  assert.equal(await page.getAttribute("#play", "aria-pressed"), "false");
  const before = await time(page);
  await page.keyboard.press("ArrowRight");
  assert.ok((await time(page)) > before);
  await page.keyboard.press("Home");
  await page.waitForFunction(() => window.pendulum.app.simulation.now.t === 0);
  await page.focus('#tabs [aria-selected="true"]');
  await page.keyboard.press("ArrowRight");
  assert.equal(await page.textContent('#tabs [aria-selected="true"]'), "Operations");
  const unnamed = await page.evaluate(() => {
    const named = (own) => own.getAttribute("aria-label") || own.labels?.length > 0 || own.textContent.trim() || own.title;
    return [...document.querySelectorAll("button, input, select")].filter((own) => !named(own)).map((own) => own.outerHTML);
  });
  assert.deepEqual(unnamed, []);
});

test("without motion where the user asks for that", async (t) => {
  const page = await opened(t, { reducedMotion: "reduce", still: true });
  await page.waitForFunction(() => window.pendulum?.app.simulation?.now);
  await page.waitForTimeout(500);
  assert.equal(await time(page), 0);
});

test("without WebAssembly, a picture and a sentence", async (t) => {
  const page = await opened(t, { init: () => delete window.WebAssembly, still: true });
  await page.waitForSelector("#without:not([hidden]) svg");
  assert.match(await page.textContent("#without"), /WebAssembly/);
});
