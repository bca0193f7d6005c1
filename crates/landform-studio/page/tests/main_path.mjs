// The main path in Chromium: open, drag, grow, undo, compare seeds, paint, export. `node tests/main_path.mjs [ADDRESS]`;
// without an address the stand-in server is started. SHOTS: folder for pictures; CHROMIUM: the browser.
import assert from "node:assert/strict";
import { mkdir } from "node:fs/promises";
import { readFileSync } from "node:fs";
import { createRequire } from "node:module";
import { join } from "node:path";
import { chromium } from "playwright-core";
import { serve } from "./mock.mjs";

const shots = process.env.SHOTS ?? "build/shots";
const recipe = process.env.RECIPE ?? "first_mountains";
const key = process.env.KEY ?? "talus_angle";
const only = process.env.ONLY?.split(",");
await mkdir(shots, { recursive: true });
const mock = process.argv[2] ? null : await serve();
const address = process.argv[2] ?? `http://127.0.0.1:${mock.address().port}/`;
const browser = await chromium.launch({
  executablePath: process.env.CHROMIUM ?? "/usr/bin/chromium",
  args: ["--no-sandbox", "--use-gl=angle", "--use-angle=swiftshader", "--enable-unsafe-swiftshader"],
});
const context = await browser.newContext({ viewport: { width: 1600, height: 1000 } });
if (process.env.ASSETS) {
  // The files of this folder in place of those in the program.
  for (const file of ["studio.js", "studio.css"]) await context.route(`**/${file}`, (route) => route.fulfill({ path: join(process.env.ASSETS, file) }));
}
const page = await context.newPage();
const troubles = [];
page.on("console", (m) => m.type() === "error" && troubles.push(m.text()));
page.on("pageerror", (e) => troubles.push(e.message));
const by = (name) => page.getByTestId(name);
const shot = (name) => page.screenshot({ path: join(shots, `${name}.png`) });
const settled = async () => {
  await page.waitForFunction(() => !document.querySelector(".level .busy, .level .settling"), null, { timeout: 90_000 });
  await page.waitForTimeout(700);
};
const axe = readFileSync(createRequire(import.meta.url).resolve("axe-core/axe.min.js"), "utf8");
const found = [];
/** What axe finds in the state that is shown. */
async function checkAccess(state) {
  await page.evaluate(axe);
  const { violations } = await page.evaluate(() => window.axe.run(document, { resultTypes: ["violations"] }));
  for (const v of violations) found.push(`${v.impact}: ${state}: ${v.id}: ${v.nodes.slice(0, 4).map((n) => n.target.join(" ")).join(" | ")}`);
}
let passed = 0, failed = 0;
async function part(name, act) {
  if (only && !only.includes(name.split(" ")[0])) return;
  const start = Date.now();
  try {
    await act();
    passed++;
    console.log(`ok   ${name} (${Date.now() - start} ms)`);
  } catch (error) {
    failed++;
    console.log(`FAIL ${name}: ${error.message.split("\n").slice(0, 6).join("\n")}`);
    await shot(`fail_${name.split(" ")[0]}`);
  }
}

const began = Date.now();
await page.goto(address);
await page.waitForSelector("[data-ready=true], .welcome .picture", { timeout: 20_000 });
console.log(`first paint of the studio after ${Date.now() - began} ms`);

await part("open a gallery landscape", async () => {
  if (await page.locator(".welcome").count()) {
    await shot("01_empty");
    await checkAccess("01_empty");
  }
  else await by("gallery-button").click();
  await by(`open-${recipe}`).click();
  await page.waitForSelector("[data-testid=app][data-ready=true] .steps .step", { timeout: 60_000 });
  await settled();
  await shot("02_opened");
  assert.match(await by("level").textContent(), /preview|full size/);
});

await part("hover reads the ground", async () => {
  const box = await by("land-canvas").boundingBox();
  await page.mouse.move(box.x + box.width / 2, box.y + box.height * 0.5);
  await page.waitForFunction(() => /elevation/.test(document.querySelector("[data-testid=readout]")?.textContent ?? ""));
  assert.match(await by("readout").textContent(), /slope.*°/);
});

await part("grow while watching", async () => {
  await by("play").click();
  await page.waitForTimeout(2500);
  await shot("03_growing");
  if ((await by("play").getAttribute("aria-label")) === "Pause") await by("play").click();
  await page.waitForTimeout(300);
  await shot("04_paused");
  if (await by("scrub").isEnabled()) {
    await by("scrub").evaluate((e) => { e.value = "1"; e.dispatchEvent(new Event("input", { bubbles: true })); });
    await page.waitForTimeout(400);
    await shot("05_scrubbed");
    await page.getByText("To the newest").click();
  }
  await by("stop").click({ force: true }).catch(() => {});
});

await part("slider changes one value", async () => {
  await by("step-1-1").click();
  const before = await value(key);
  const slider = by(`slider-${key}`);
  await slider.waitFor();
  const box = await slider.boundingBox();
  const start = { x: box.x + box.width * 0.25, y: box.y + box.height / 2 };
  await page.mouse.move(start.x, start.y);
  await page.mouse.down();
  for (let i = 1; i <= 20; i++) {
    await page.mouse.move(start.x + i * 3, start.y);
    await page.waitForTimeout(50);
  }
  await shot("06_dragging");
  await page.mouse.up();
  await page.waitForTimeout(500);
  assert.notEqual(await value(key), before);
  await settled();
  await shot("07_released");
});

await part("undo gives the value back", async () => {
  const before = await value(key);
  await by("undo").click();
  await page.waitForFunction(([k, b]) => document.querySelector(`[data-testid=row-${k}] .field`)?.value !== b, [key, before], { timeout: 5000 });
  await settled();
});

await part("map and both views", async () => {
  await by("view-map").click();
  await page.waitForTimeout(800);
  await shot("08_map");
  await by("view-both").click();
  await by("colours").selectOption("field:drainage_area");
  await page.waitForTimeout(1200);
  await shot("09_both");
  await checkAccess("09_both");
  await by("colours").selectOption("auto");
  await by("view-land").click();
});

await part("measures", async () => {
  await by("tab-measures").click();
  await page.waitForTimeout(400);
  await shot("10_measures");
  await checkAccess("10_measures");
});

await part("text and its mistakes", async () => {
  await by("text-button").click();
  await page.waitForTimeout(500);
  await shot("11_text");
  const text = await by("text").inputValue();
  await by("text").fill(text.replace("[[stage]]", "[[stag]]"));
  await page.waitForSelector(".editor-faults .fault", { timeout: 5000 });
  await shot("12_mistake");
  await checkAccess("12_mistake");
  await by("text").fill(text);
  await page.waitForFunction(() => !document.querySelector(".editor-faults .fault"), null, { timeout: 5000 });
  await by("text-button").click();
});

await part("recipe form", async () => {
  await by("tab-recipe").click();
  await page.waitForTimeout(300);
  await shot("13_recipe");
  await checkAccess("13_recipe");
  await by("tab-step").click();
});

await part("stages to add", async () => {
  await by("add-step").click();
  await page.waitForTimeout(300);
  await page.getByLabel("Search stages").fill("diffusion");
  await page.waitForTimeout(200);
  await shot("14_add");
  await checkAccess("14_add");
  await page.getByLabel("Close").click();
});

await part("compare two seeds", async () => {
  await settled();
  await by("compare-button").click();
  await by("contact-button").click();
  await page.waitForFunction(() => document.querySelectorAll("[data-testid=contact-picture]:not([disabled])").length >= 4, null, { timeout: 90_000 });
  await page.waitForTimeout(1500);
  await shot("15_seeds");
  await checkAccess("15_seeds");
  const seed = await page.getByTestId("contact-picture").first().getAttribute("aria-label");
  await page.getByTestId("contact-picture").first().click();
  await page.waitForTimeout(400);
  await settled();
  await shot("16_wipe");
  await checkAccess("16_wipe");
  await by("compare-button").click();
  await by("tab-recipe").click();
  assert.equal(`Take seed ${await by("seed").inputValue()}`, seed);
  await by("tab-step").click();
});

const paints = await by("tool-raise").count();
if (paints) await part("paint with mouse and keys", async () => {
  await by("tool-raise").click();
  const box = await by("land-canvas").boundingBox();
  await page.mouse.move(box.x + box.width * 0.5, box.y + box.height * 0.5);
  await page.waitForTimeout(400);
  await shot("17_brush");
  await page.mouse.down();
  for (let i = 0; i < 12; i++) {
    await page.mouse.move(box.x + box.width * 0.5 + i * 8, box.y + box.height * 0.5);
    await page.waitForTimeout(30);
  }
  await page.mouse.up();
  await page.keyboard.press("ArrowLeft");
  await page.keyboard.press("Space");
  await page.waitForTimeout(1200);
  await shot("18_painted");
  await checkAccess("18_painted");
  await by("tool-raise").click();
});

await part("light", async () => {
  await by("light").click();
  await page.waitForTimeout(200);
  await shot("19_light");
  await checkAccess("19_light");
  await by("light").click();
});

await part("near view", async () => {
  const box = await by("land-canvas").boundingBox();
  await page.mouse.move(box.x + box.width / 2, box.y + box.height / 2);
  for (let i = 0; i < 9; i++) await page.mouse.wheel(0, -120);
  for (let i = 0; i < 3; i++) await by("land-canvas").press("ArrowDown");
  await page.waitForTimeout(1200);
  await shot("20_near");
  await by("land-canvas").press("Home");
});

await part("export", async () => {
  await by("export-button").click();
  await page.waitForTimeout(300);
  await shot("21_export");
  await by("export-unreal").click();
  await page.waitForSelector(".files a, .modal .fault", { timeout: 120_000 });
  await shot("22_exported");
  await checkAccess("22_exported");
  assert.equal(await page.locator(".modal .fault").count(), 0);
  await page.keyboard.press("Escape");
});

await part("small window", async () => {
  await page.setViewportSize({ width: 1180, height: 720 });
  await page.waitForTimeout(800);
  await shot("23_small");
  await page.setViewportSize({ width: 1600, height: 1000 });
});

await part("access: no serious findings in any state seen", async () => {
  await checkAccess("studio");
  const serious = found.filter((f) => /^(serious|critical)/.test(f));
  for (const f of found) console.log(`     ${f}`);
  assert.equal(serious.length, 0);
});

if (process.env.EVENTS) await part("latency of a drag", async () => {
  await by("step-1-1").click();
  const box = await by(`slider-${key}`).boundingBox();
  const at = (i) => [box.x + box.width * (0.35 + 0.15 * Math.sin(i / 9)), box.y + box.height / 2];
  await page.mouse.move(...at(0));
  await page.mouse.down();
  const start = Date.now();
  for (let i = 1; i <= Number(process.env.EVENTS); i++) {
    await page.mouse.move(...at(i));
    await page.waitForTimeout(Math.max(0, start + 50 * i - Date.now()));
  }
  const took = Date.now() - start;
  await page.mouse.up();
  await by("log-button").click();
  const lines = await page.locator(".log-lines .latency").allTextContents();
  console.log(`     ${process.env.EVENTS} events in ${took} ms; ${lines.at(-1)}`);
  await shot("24_latency");
  await by("log-button").click();
  await settled();
});

const lag = await page.evaluate(() => [...document.querySelectorAll(".log-strip span")].map((s) => s.textContent).find((t) => /to picture/.test(t ?? "")));
console.log(`latency: ${lag ?? "not measured"}`);
for (const t of troubles) console.log(`console: ${t}`);
console.log(`${passed} passed, ${failed + (troubles.length ? 1 : 0)} failed`);
await browser.close();
mock?.closeAllConnections();
mock?.close();
process.exit(failed || troubles.length ? 1 : 0);

async function value(key) {
  return by(`row-${key}`).locator(".field").first().inputValue();
}
