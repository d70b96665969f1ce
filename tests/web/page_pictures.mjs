// The pictures of docs/web.md: web.png, the page beside a game with a robot that was pushed over, and web_phone.png, the same on a phone.
//
// Usage: node page_pictures.mjs <murosimf> <folder for pictures> [chromium]
// Exit: 0 all well, 1 not, 77 there is no Chromium or playwright-core. scripts/doc_pictures runs it.
import { mkdirSync } from "node:fs";
import { join } from "node:path";
import { launch, serveBy } from "./served_page.mjs";

const [program, pictures, given] = process.argv.slice(2);
mkdirSync(pictures, { recursive: true });
const pushed = "red2", push = "8:red2.j_torso.push=[0, -60, 0, 0.1]", shown = 9; // [s]

const browser = await launch(given);

async function open(address, viewport, hasTouch) {
  const context = await browser.newContext({ viewport, hasTouch });
  const page = await context.newPage();
  await page.goto(address);
  await page.waitForSelector('body[data-ready="poses"]', { timeout: 60000 });
  return page;
}
const select = (page) => page.evaluate((name) => {
  window.murosimf.select(window.murosimf.scene().text.entities.findIndex((one) => one.name === name));
}, pushed);
// Goes back to an instant, by the time line.
const seek = (page, time) => page.evaluate((to) => {
  const line = document.getElementById("time");
  line.value = to;
  for (const event of ["pointerdown", "input", "change"]) line.dispatchEvent(new Event(event));
}, time);
// Looks at what is selected, from [m] there.
const look = (page, from) => page.evaluate((offset) => {
  const { view } = window.murosimf, place = view.basePlace(view.selected);
  view.controls.target.copy(place);
  view.camera.position.copy(place).add({ x: offset[0], y: offset[1], z: offset[2] });
  view.controls.update();
}, from);
const shoot = async (page, name) => {
  await page.waitForTimeout(3000); // a browser that draws in software
  await page.screenshot({ path: join(pictures, name) });
};

const run = await serveBy(program)("run", "match", "--duration", "60", "--speed", "2", "--at", push);
const page = await open(run.address, { width: 1180, height: 640 }, false);
await page.waitForFunction((least) => window.murosimf.state().time > least, shown, { timeout: 120000 });
await page.click("#play");
await page.waitForFunction(() => window.murosimf.state().paused);
await seek(page, shown);
await page.waitForFunction((time) => Math.abs(window.murosimf.state().time - time) < 0.1, shown);
await select(page);
await page.click("#contacts");
await look(page, [0.4, -1.9, 0.9]);
await shoot(page, "web.png");

const phone = await open(run.address, { width: 390, height: 700 }, true);
await select(phone);
await phone.click("#toggle_panel");
await phone.click("#contacts");
await phone.click("#follow");
await look(phone, [0.2, -1.5, 1.2]);
await phone.locator("#panel .details").first().scrollIntoViewIfNeeded();
await shoot(phone, "web_phone.png");
await browser.close();
await run.end();
