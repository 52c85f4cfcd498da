// The page in Firefox, at $FIREFOX; skipped without it.
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { dirname, join, resolve } from "node:path";
import { test } from "node:test";
import { fileURLToPath, pathToFileURL } from "node:url";
import { firefox } from "../firefox.mjs";

const here = dirname(fileURLToPath(import.meta.url));
const file = resolve(process.env.PAGE ?? join(here, "../../out/pendulum.html"));
const path = process.env.FIREFOX;

test("Firefox moves, draws a thousand, and computes the bits of other machines", { skip: path ? false : "no Firefox" }, async (t) => {
  const { open, run, close } = await firefox(path);
  t.after(close);
  await open(pathToFileURL(file).href);
  const seen = await run(async () => {
    const until = async (holds) => {
      while (!holds()) await new Promise((next) => setTimeout(next, 20));
    };
    await until(() => window.pendulum?.app.simulation?.now?.t > 0);
    const moved = performance.now();
    const { app, editor } = window.pendulum;
    document.getElementById("crowd").click();
    await until(() => app.simulation.now.crowd && app.simulation.now.t > 1);
    const [from, began] = [app.drawn, performance.now()];
    await new Promise((next) => setTimeout(next, 2000));
    const rate = ((app.drawn - from) / (performance.now() - began)) * 1000;
    const good = editor.text;
    editor.text = good.replace("revolute", "revolut");
    await until(() => document.querySelector(".cm-lintRange-error"));
    const marked = document.querySelector(".cm-lintRange-error").textContent;
    editor.text = good;
    await until(() => document.querySelectorAll("#problems li").length === 0 && document.querySelector("#panel .katex"));
    return { moved, rate, marked, again: app.playing };
  });
  t.diagnostic(`moved within ${Math.round(seen.moved)} ms; ${seen.rate.toFixed(1)} frames per second with 1000 pendulums`);
  assert.deepEqual([seen.marked, seen.again], ["revolut", true]);
  const cases = JSON.parse(readFileSync(join(here, "../tests/bits.json"), "utf8"));
  for (const { text, request, x } of cases) {
    const bits = await run(
      async (text, request) => {
        const { app, engine } = window.pendulum;
        app.simulation = null;
        await engine.ask({ do: "declare", text, method: "Vern9" });
        const { answer } = await engine.ask(request);
        const words = new BigUint64Array(Float64Array.from(answer.x).buffer);
        return [...words].map((word) => word.toString(16).padStart(16, "0"));
      },
      text,
      request,
    );
    assert.deepEqual(bits, x);
  }
});
