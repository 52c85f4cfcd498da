// Firefox for the tests, by its remote protocol Marionette: no driver is needed.
import { spawn } from "node:child_process";
import { existsSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { connect } from "node:net";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { setTimeout as pause } from "node:timers/promises";

/** Time until Firefox has started, in ms. */
const LIMIT = 60000;

/** Starts Firefox. Resolves to functions that open an address, run a script in its page, and close the browser. */
export async function firefox(path) {
  const profile = mkdtempSync(join(tmpdir(), "firefox-"));
  writeFileSync(join(profile, "user.js"), 'user_pref("marionette.port", 0);\n');
  const args = ["--headless", "--no-remote", "--marionette", "--profile", profile];
  const browser = spawn(path, args, { stdio: "ignore", env: { ...process.env, HOME: profile } });
  const port = await portIn(join(profile, "MarionetteActivePort"));
  const { send, socket } = await connected(port);
  await send("WebDriver:NewSession", {});
  await send("WebDriver:SetTimeouts", { script: LIMIT });
  return {
    open: (url) => send("WebDriver:Navigate", { url }),
    /** Runs a function in the page, and resolves to what it resolves to. */
    run: async (script, ...given) => {
      const text = `const done = arguments[arguments.length - 1]; (${script})(...[...arguments].slice(0, -1)).then((value) => done({ value }), (error) => done({ error: String(error) }));`;
      const { value } = await send("WebDriver:ExecuteAsyncScript", { script: text, args: given, sandbox: null });
      if (value.error) throw new Error(value.error);
      return value.value;
    },
    close: async () => {
      socket.destroy();
      browser.kill();
      await new Promise((ended) => (browser.exitCode === null ? browser.once("exit", ended) : ended()));
      rmSync(profile, { recursive: true, force: true, maxRetries: 5 });
    },
  };
}

async function portIn(file) {
  for (let waited = 0; waited < LIMIT; waited += 100) {
    if (existsSync(file) && readFileSync(file, "utf8")) return Number(readFileSync(file, "utf8"));
    await pause(100);
  }
  throw new Error("Firefox does not start");
}

/** Connects. Messages are JSON after their length and a colon: `[0, id, command, parameters]`, `[1, id, error, result]`. */
async function connected(port) {
  const socket = connect(port, "127.0.0.1");
  const waiting = new Map();
  let rest = Buffer.alloc(0);
  const greeting = new Promise((resolve) => waiting.set(0, [resolve]));
  socket.on("data", (data) => {
    rest = Buffer.concat([rest, data]);
    for (;;) {
      const colon = rest.indexOf(":");
      const end = colon + 1 + Number(rest.subarray(0, colon));
      if (colon < 0 || rest.length < end) return;
      const message = JSON.parse(rest.subarray(colon + 1, end));
      rest = rest.subarray(end);
      const [, id, error, result] = Array.isArray(message) ? message : [1, 0, null, message];
      const [resolve, reject] = waiting.get(id);
      error ? reject(new Error(`${error.error}: ${error.message}`)) : resolve(result);
    }
  });
  await greeting;
  let last = 0;
  const send = (command, parameters) =>
    new Promise((...settled) => {
      waiting.set(++last, settled);
      const text = JSON.stringify([0, last, command, parameters]);
      socket.write(`${Buffer.byteLength(text)}:${text}`);
    });
  return { send, socket };
}
