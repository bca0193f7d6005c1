// Pictures of the gallery, taken from the studio itself: node tests/gallery.mjs ADDRESS FOLDER [NAME...]. PNG, 960 x 640.
import { chromium } from "playwright-core";
import { join } from "node:path";

const [address, folder, ...names] = process.argv.slice(2);
const browser = await chromium.launch({
  executablePath: process.env.CHROMIUM ?? "/usr/bin/chromium",
  args: ["--no-sandbox", "--use-gl=angle", "--use-angle=swiftshader", "--enable-unsafe-swiftshader"],
});
const page = await browser.newPage({ viewport: { width: 960, height: 640 }, bypassCSP: true });
for (const file of ["studio.js", "studio.css"]) await page.route(`**/${file}`, (route) => route.fulfill({ path: join("..", "assets", file) }));
await page.goto(address);
await page.addStyleTag({ content: ".app { grid-template: 'views' 1fr / 1fr !important } .app > :not(.views), .views > :not(.panes) { display: none !important } .welcome, dialog { display: block !important }" });
await page.waitForFunction(() => document.querySelector("[data-testid=app]")?.dataset.ready === "true");
const all = names.length ? names : await page.evaluate(() => fetch("/gallery.json").then((r) => r.json()).then((g) => g.map((e) => e.name)));
for (const name of all) {
  await page.evaluate(() => { document.querySelector("dialog")?.close(); document.querySelector("[data-testid=gallery-button]")?.click(); });
  await page.waitForTimeout(400);
  await page.evaluate((n) => document.querySelector(`[data-testid=open-${n}]`).click(), name);
  await page.waitForTimeout(3000);
  await page.waitForFunction(() => !document.querySelector(".level .busy, .level .settling") && document.querySelector(".level span"), null, { timeout: 300_000 });
  await page.waitForTimeout(2500);
  await page.evaluate(() => window.dispatchEvent(new Event("resize")));
  await page.waitForTimeout(500);
  await page.screenshot({ path: join(folder, `${name}.png`) });
  console.log(name, await page.evaluate(() => document.querySelector(".level").textContent));
}
await browser.close();
