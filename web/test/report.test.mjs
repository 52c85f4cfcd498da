// A report of the crate `charts` in a browser: `node --test test/`, after `cargo run -p charts --example report`. REPORT
// is the file, CHROMIUM the browser.
import assert from "node:assert/strict";
import { existsSync, mkdirSync } from "node:fs";
import { dirname, join, resolve } from "node:path";
import { after, before, test } from "node:test";
import { fileURLToPath, pathToFileURL } from "node:url";
import { launched, watched } from "../browser.mjs";

const here = dirname(fileURLToPath(import.meta.url));
const file = resolve(process.env.REPORT ?? join(here, "../../out/report.html"));
const pictures = join(dirname(file), "pictures");
/** Charts, their panels, and numbers of curves and cells in the example. */
const [LINES, MAP] = [0, 1];
const [COST, MOTION] = [0, 1];
const [SLOW, FAST] = [1, 2];
const SIDE = 40;

assert.ok(existsSync(file), `${file} is missing: run cargo run -p charts --example report`);
mkdirSync(pictures, { recursive: true });
let browser;

before(async () => {
  browser = await launched();
});
after(() => browser?.close());

/** Opens the report, and waits until it is drawn. */
async function opened(t, options) {
  const page = await watched(t, browser, options);
  await page.goto(pathToFileURL(file).href);
  await page.waitForFunction(() => window.charts?.every((chart) => chart.panels.every((panel) => panel.frame)));
  return page;
}

const panelOf = (page, chart, panel) => page.locator("section.chart").nth(chart).locator(".panel").nth(panel);

/** Scrolls to a panel; returns the place on the screen of parts of its plot's sides. */
async function onScreen(page, chart, panel, part) {
  const canvas = panelOf(page, chart, panel).locator("> canvas");
  await canvas.scrollIntoViewIfNeeded();
  const box = await canvas.boundingBox();
  const { left, right, top, bottom } = await page.evaluate(([chart, panel]) => window.charts[chart].panels[panel].frame, [chart, panel]);
  return [box.x + left + (right - left) * part[0], box.y + bottom - (bottom - top) * part[1]];
}

/** Parts of the plot's sides at which a tolerance of the example is. */
const partOf = (curve, exponent) => [(exponent - 2) / 11, (curve === SLOW ? 0.25 + 0.25 * exponent : 0.5 + 0.125 * exponent) / 4];

/** Colour of a canvas in the middle of a mark. */
const colorAt = (page, [x, y]) =>
  page.evaluate(([x, y]) => {
    const canvas = document.elementFromPoint(x, y);
    const box = canvas.getBoundingClientRect();
    const ratio = canvas.width / box.width;
    return [...canvas.getContext("2d").getImageData((x - box.left) * ratio, (y - box.top) * ratio, 1, 1).data];
  }, [x, y]);

/** Name, labels, values and note that a panel shows, or null. */
async function shown(page, chart, panel) {
  const values = panelOf(page, chart, panel).locator(".values");
  if (await values.isHidden()) return null;
  return values.evaluate((box) => {
    const texts = (tag) => [...box.querySelectorAll(tag)].map((own) => own.textContent);
    return { name: texts("strong")[0], labels: texts("dt"), values: texts("dd"), note: box.lastChild.nodeType === 3 ? box.lastChild.data : "" };
  });
}

test("hovering shows the values of a mark where it is drawn, and lifts its curve out", async (t) => {
  const page = await opened(t);
  const slow = await onScreen(page, LINES, COST, partOf(SLOW, 5));
  const fast = await onScreen(page, LINES, COST, partOf(FAST, 8));
  assert.deepEqual(await colorAt(page, slow), [213, 94, 0, 255]);
  assert.deepEqual(await colorAt(page, fast), [34, 34, 34, 255]);
  await page.mouse.move(slow[0] + 4, slow[1] - 3);
  const labels = ["error (rad)", "time (µs)"];
  assert.deepEqual(await shown(page, LINES, COST), { name: "Slow", labels, values: ["10⁻⁵", "31.62"], note: "tolerance 1e-5" });
  assert.deepEqual(await colorAt(page, slow), [213, 94, 0, 255]);
  assert.ok((await colorAt(page, fast))[3] < 100, "the other curve is behind");
  await page.screenshot({ path: join(pictures, "hover.png") });
  await page.mouse.move(...fast);
  assert.deepEqual(await shown(page, LINES, COST), { name: "Fast & </script>", labels, values: ["10⁻⁸", "31.62"], note: "tolerance 1e-8" });
  // far from all curves, and outside of the plot
  await page.mouse.move(...(await onScreen(page, LINES, COST, [0.1, 0.9])));
  assert.equal(await shown(page, LINES, COST), null);
  assert.deepEqual(await colorAt(page, fast), [34, 34, 34, 255]);
  await page.mouse.move(...(await onScreen(page, LINES, MOTION, [(Math.PI - 1) / 10, 0.5])));
  assert.equal((await shown(page, LINES, MOTION)).name, "computed");
});

test("arrow keys step along a curve and from curve to curve, aloud", async (t) => {
  const page = await opened(t);
  const said = () => page.textContent("#said");
  await panelOf(page, LINES, COST).locator("> canvas").focus();
  await page.keyboard.press("ArrowRight");
  assert.equal(await said(), "Slow; error (rad) 0.001; time (µs) 10; tolerance 1e-3");
  await page.keyboard.press("ArrowRight");
  assert.equal(await said(), "Slow; error (rad) 10⁻⁴; time (µs) 17.78; tolerance 1e-4");
  await page.keyboard.press("ArrowUp");
  assert.equal(await said(), "Fast & </script>; error (rad) 10⁻⁴; time (µs) 10; tolerance 1e-4");
  for (let n = 0; n < 3; n++) await page.keyboard.press("ArrowLeft");
  assert.equal(await said(), "Fast & </script>; error (rad) 0.001; time (µs) 7.499; tolerance 1e-3");
  await page.keyboard.press("ArrowDown");
  assert.equal((await shown(page, LINES, COST)).name, "Slow");
  await page.keyboard.press("Escape");
  assert.equal(await shown(page, LINES, COST), null);
});

test("a map shows its cells", async (t) => {
  const page = await opened(t);
  const cell = (column, row) => onScreen(page, MAP, 0, [(column + 0.5) / SIDE, (row + 0.5) / SIDE]);
  await page.mouse.move(...(await cell(30, 10)));
  const labels = ["product (m³)", "x (m)", "y (m)"];
  // 10^(3 x y² - 2)
  assert.deepEqual(await shown(page, MAP, 0), { name: undefined, labels, values: ["0.01438", "0.7625", "0.2625"], note: "" });
  await page.mouse.move(...(await cell(39, 39)));
  assert.equal((await shown(page, MAP, 0)).values[0], "none");
  assert.deepEqual(await colorAt(page, await cell(37, 39)), [255, 255, 255, 255]);
  assert.deepEqual(await colorAt(page, await cell(3, 0)), [68, 1, 84, 255]);
  await panelOf(page, MAP, 0).locator("> canvas").focus();
  await page.mouse.move(0, 0);
  await page.keyboard.press("ArrowRight");
  await page.keyboard.press("Shift+ArrowRight");
  await page.keyboard.press("ArrowDown");
  assert.equal(await page.textContent("#said"), "product (m³) 0.03497; x (m) 0.7625; y (m) 0.4875");
});

test("entries of the legend hide curves and show them again", async (t) => {
  const page = await opened(t);
  const slow = await onScreen(page, LINES, COST, partOf(SLOW, 9));
  const button = page.getByRole("button", { name: "Slow" });
  await button.click();
  assert.equal(await button.getAttribute("aria-pressed"), "false");
  assert.equal((await colorAt(page, slow))[3], 0);
  await page.mouse.move(...slow);
  assert.equal(await shown(page, LINES, COST), null);
  await button.click();
  await page.mouse.move(...slow);
  assert.equal((await shown(page, LINES, COST)).name, "Slow");
  assert.equal(await page.getByRole("button", { name: "implicit methods" }).count(), 0);
});

test("colours follow those of the system", async (t) => {
  const page = await opened(t);
  const fast = await onScreen(page, LINES, COST, partOf(FAST, 8));
  const card = () => page.evaluate(() => getComputedStyle(document.querySelector("section")).backgroundColor);
  assert.equal(await card(), "rgb(255, 255, 255)");
  await page.emulateMedia({ colorScheme: "dark" });
  // drawn anew
  await page.evaluate(() => new Promise((next) => requestAnimationFrame(() => requestAnimationFrame(next))));
  assert.equal(await card(), "rgb(30, 33, 37)");
  assert.deepEqual(await colorAt(page, fast), [230, 230, 227, 255]);
  assert.deepEqual(await colorAt(page, await onScreen(page, LINES, COST, partOf(SLOW, 5))), [228, 150, 89, 255]);
  await page.screenshot({ path: join(pictures, "dark.png"), fullPage: true });
});

test("fits on a phone, where a tap shows values", async (t) => {
  const page = await opened(t, { viewport: { width: 360, height: 740 }, hasTouch: true, isMobile: true });
  const overhang = () => page.evaluate(() => document.documentElement.scrollWidth - window.innerWidth);
  assert.ok((await overhang()) <= 0);
  const [cost, motion] = [await panelOf(page, LINES, COST).boundingBox(), await panelOf(page, LINES, MOTION).boundingBox()];
  assert.ok(motion.y >= cost.y + cost.height, "panels are below one another");
  for (const exponent of [3, 12]) {
    await page.touchscreen.tap(...(await onScreen(page, LINES, COST, partOf(SLOW, exponent))));
    assert.equal((await shown(page, LINES, COST)).note, `tolerance 1e-${exponent}`);
    const box = await panelOf(page, LINES, COST).locator(".values").boundingBox();
    assert.ok(box.x >= 0 && box.x + box.width <= 360, `values from ${box.x} on, ${box.width} wide`);
    assert.ok((await overhang()) <= 0);
  }
  assert.match(await page.textContent("#said"), /^Slow; error \(rad\) 10⁻¹²/);
  await page.screenshot({ path: join(pictures, "phone.png"), fullPage: true });
  // narrower, as after a turn
  await page.setViewportSize({ width: 300, height: 600 });
  await page.waitForFunction(() => {
    const [{ canvas }] = window.charts[0].panels;
    return canvas.clientWidth < 270 && canvas.width === Math.round(canvas.clientWidth * window.devicePixelRatio);
  }, null, { timeout: 5000 });
  assert.ok((await overhang()) <= 0);
});
