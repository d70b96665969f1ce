// The page in headless Chromium: shows a running scene, its buttons work, also on a phone; the one-file export plays from file://.
//
// Usage: node page_in_browser.mjs <murosimf> <folder for pictures> [chromium]
// Exit: 0 all well, 1 not, 77 there is no Chromium or playwright-core (the test is skipped).
import assert from "node:assert/strict";
import { spawn, spawnSync } from "node:child_process";
import { createSocket } from "node:dgram";
import { mkdirSync, statSync } from "node:fs";
import { join } from "node:path";
import { pathToFileURL } from "node:url";
import { children, launch, serveBy } from "./served_page.mjs";

const [program, pictures, given] = process.argv.slice(2);
mkdirSync(pictures, { recursive: true });
const serve = serveBy(program), start = (...words) => serve("run", ...words);

const browser = await launch(given);
// Pixels are drawn by software: of each window a quarter of them, which changes no layout. Shadows, which cost as much again, are
// drawn where there is a mouse.
const windowOf = (width, height, hasTouch) => browser.newContext({ viewport: { width, height }, deviceScaleFactor: 0.25, hasTouch });
const desktop = await windowOf(1280, 760, false), tablet = await windowOf(960, 600, true), phone = await windowOf(390, 780, true);
const problems = [];
async function open(address, where = tablet) {
  const page = await where.newPage();
  page.on("pageerror", (error) => problems.push(String(error)));
  page.on("console", (line) => { if (line.type() === "error") problems.push(line.text()); });
  await page.goto(address);
  await page.waitForSelector('body[data-ready="poses"]', { timeout: 60000 });
  return page;
}
const state = (page) => page.evaluate(() => window.murosimf.state());
// Patient: a browser that draws in software on a busy machine takes seconds for a click.
async function until(page, good, what) {
  for (const end = Date.now() + 120000; Date.now() < end;) {
    if (good(await state(page))) return;
    await page.waitForTimeout(100);
  }
  assert.fail(`never: ${what}; ${JSON.stringify(await state(page))}`);
}
// How many colors a picture of the view has: one that is empty has few.
const colors = (page) => page.evaluate(async () => {
  window.murosimf.view.redraw();
  const view = document.getElementById("view");
  const bitmap = await new Promise((resolve) => requestAnimationFrame(() => {
    window.murosimf.view.draw();
    resolve(createImageBitmap(view));
  }));
  const canvas = new OffscreenCanvas(160, 95);
  const pen = canvas.getContext("2d");
  pen.drawImage(bitmap, 0, 0, 160, 95);
  const data = pen.getImageData(0, 0, 160, 95).data;
  const all = new Set();
  for (let i = 0; i < data.length; i += 4) all.add(`${data[i] >> 4},${data[i + 1] >> 4},${data[i + 2] >> 4}`);
  return all.size;
});

async function testDesktop() {
  const run = await start("duel", "--duration", "60", "--set", "red.*.level=simplified_dynamics", "--roboviz", "0");
  const begin = Date.now();
  const page = await open(run.address, desktop);
  console.log(`page shows the scene after ${Date.now() - begin} ms`);
  assert.equal(await page.textContent("#messages"), "", "nothing to complain about");
  assert.equal(await page.textContent("#name"), "Duel");
  await until(page, (now) => now && now.time > 0, "time goes on");
  assert.ok((await colors(page)) > 30, "something is drawn");
  await page.click("#play");
  await until(page, (now) => now.paused, "paused");
  const stands = (await state(page)).time;
  await page.click("#step");
  await until(page, (now) => now.time > stands && now.paused, "one step");
  await page.evaluate(() => window.murosimf.select(window.murosimf.scene().text.entities.findIndex((one) => one.name === "red1")));
  await page.selectOption('select[aria-label="level"]', "full_dynamics");
  const red = await page.evaluate(() => window.murosimf.scene().text.entities.findIndex((one) => one.name === "red1"));
  await until(page, (now) => now.entities[red].level === "full_dynamics", "another level");
  assert.ok(await page.locator("#ghosts").isHidden(), "no robot tells where it believes to be");
  await page.click("#contacts");
  await page.click('button[aria-label="Push right"]');
  await page.waitForSelector("#messages div:has-text('push')", { timeout: 60000 });
  await page.click("#play");
  await until(page, (now) => now.time > stands + 0.5, "goes on");
  await page.screenshot({ path: join(pictures, "desktop.png") });
  await page.click('#tabs button:has-text("Plots")');
  await page.fill('input[aria-label="Number to plot"]', "red1.torso.position.z");
  await page.press('input[aria-label="Number to plot"]', "Enter");
  await page.waitForFunction(() => document.querySelector('input[aria-label="Number to plot"]').value === "");
  await page.fill('input[aria-label="Number to plot"]', "ball.ball.linear_velocity.x");
  await page.press('input[aria-label="Number to plot"]', "Enter");
  await page.waitForFunction(() => [...document.querySelectorAll(".plot .value")].filter((one) => one.textContent).length === 2);
  await page.waitForTimeout(500);
  await page.click('#tabs button:has-text("Events")');
  assert.match(await page.textContent("#panel"), /red1/);
  await page.click('#tabs button:has-text("Plots")');
  await page.click("#above");
  await page.waitForTimeout(300);
  await page.screenshot({ path: join(pictures, "plots.png") });
  await page.click("#play");
  await until(page, (now) => now.paused, "paused again");
  await pushByDragging(page, "red1");
  await goBackOnTheTimeLine(page);
  await lookThroughACamera(page, "blue1");
  await seeDrawings(page, run.said());
  await page.click("#reset");
  await until(page, (now) => now.time === 0, "back at the start");
  await page.close();
  await run.end();
}

// Pulls at the trunk of a robot where it is seen: a push to the right of the picture.
async function pushByDragging(page, robot) {
  await page.click("#push_mode");
  const at = await page.evaluate((name) => {
    const { view, scene } = window.murosimf;
    const entity = scene().text.entities.findIndex((one) => one.name === name);
    const { x, y, z } = view.basePlace(entity).clone().project(view.camera);
    const box = document.getElementById("view").getBoundingClientRect();
    return { x: box.left + (x + 1) / 2 * box.width, y: box.top + (1 - y) / 2 * box.height, z };
  }, robot);
  await page.mouse.move(at.x, at.y);
  await page.mouse.down();
  await page.mouse.move(at.x + 20, at.y, { steps: 3 });
  await page.mouse.move(at.x + 60, at.y, { steps: 3 });
  assert.ok(await page.evaluate(() => window.murosimf.view.arrow.visible), "an arrow shows the pull");
  await page.mouse.up();
  const line = page.locator(`#messages div:has-text('${robot}.'):has-text('.push = [')`).last();
  await line.waitFor({ timeout: 20000 });
  const force = /push = \[([-\d.]+), ([-\d.]+), 0/.exec(await line.textContent());
  assert.ok(Number(force[1]) > 0.1 && Math.abs(Number(force[2])) < 0.2 * Number(force[1]), `to the right: ${force}`);
  await page.click("#push_mode");
}

// Drags the thumb of the time line to its middle.
async function goBackOnTheTimeLine(page) {
  const before = await state(page), box = await page.locator("#time").boundingBox();
  const share = (before.time - before.begin) / (before.end - before.begin);
  const to = (before.begin + before.time) / 2;
  const place = (part) => box.x + 8 + part * (box.width - 16); // of a thumb 16 px wide
  await page.mouse.move(place(share), box.y + box.height / 2);
  await page.mouse.down();
  await page.mouse.move(place((to - before.begin) / (before.end - before.begin)), box.y + box.height / 2, { steps: 4 });
  await page.mouse.up();
  await until(page, (now) => now.time < before.time - 0.1 && now.paused, "back by the time line");
  assert.ok(Math.abs((await state(page)).time - to) < 1, "about where it was dragged to");
}

async function lookThroughACamera(page, robot) {
  await page.click('#tabs button:has-text("Camera")');
  const name = await page.evaluate((name) => [...document.querySelectorAll('select[aria-label="Camera"] option')]
    .map((one) => one.value).find((one) => one.startsWith(`${name}.`)), robot);
  assert.ok(name, "it has a camera");
  await page.selectOption('select[aria-label="Camera"]', name);
  await page.click("#play");
  await page.waitForFunction(() => {
    const picture = document.getElementById("picture");
    const data = picture.getContext("2d").getImageData(0, 0, picture.width, picture.height).data;
    return new Set(data).size > 3; // a canvas that is empty has one value, one color four at most
  }, undefined, { timeout: 60000 });
  assert.match(await page.textContent("#panel"), /Drawn for who looks/, "no software reads it");
  await page.screenshot({ path: join(pictures, "camera.png") });
  await page.click("#play");
  await until(page, (now) => now.paused, "paused after the camera");
}

// A circle and a text as agents of the league send them for RoboViz; the panel switches their group.
async function seeDrawings(page, said) {
  const port = Number(/RoboViz on 127.0.0.1:(\d+)/.exec(said)[1]);
  const numbers = (...all) => Buffer.from(all.map((one) => one.toFixed(4).slice(0, 6)).join(""));
  const corners = [[0, 0, 0], [2, 0, 0], [2, 1, 0], [1, 1, 0], [1, 2, 0], [0, 2, 0]]; // an L of 3 square meters
  const orange = Buffer.from([255, 128, 0]), group = Buffer.from("blue.1.plan\0");
  const packet = Buffer.concat([Buffer.from([1, 0]), numbers(0.5, 0.25, 1, 2), orange, group,
    Buffer.from([2, 0]), numbers(0, 0, 0.5), orange, Buffer.from("plan A\0"), group,
    Buffer.from([1, 4, 6]), orange, Buffer.from([255]), numbers(...corners.flat()), group, Buffer.from([0, 0]), Buffer.from("blue\0")]);
  const door = createSocket("udp4");
  await new Promise((done) => { door.send(packet, port, "127.0.0.1", done); });
  door.close();
  await page.click('#tabs button:has-text("Scene")');
  const box = page.locator("label:has-text('roboviz/blue.1.plan') input");
  await box.waitFor({ timeout: 20000 });
  const things = () => page.evaluate(() => window.murosimf.view.drawings.world.children.flatMap((group) => group.children).length);
  assert.equal(await things(), 3);
  const area = await page.evaluate(() => {
    const filled = window.murosimf.view.drawings.world.children.flatMap((one) => one.children)
      .find((one) => one.geometry?.getIndex()?.count === 12 && one.geometry.getAttribute("position").count === 6);
    const at = filled.geometry.getAttribute("position"), index = [...filled.geometry.getIndex().array];
    let sum = 0;
    for (let i = 0; i < index.length; i += 3) {
      const [a, b, c] = index.slice(i, i + 3);
      sum += Math.abs((at.getX(b) - at.getX(a)) * (at.getY(c) - at.getY(a)) - (at.getY(b) - at.getY(a)) * (at.getX(c) - at.getX(a))) / 2;
    }
    return sum;
  });
  assert.ok(Math.abs(area - 3) < 1e-6, `the triangles of an L cover it: ${area}`);
  await page.screenshot({ path: join(pictures, "drawings.png") });
  await box.uncheck();
  assert.equal(await things(), 0);
  await box.check();
  assert.equal(await things(), 3);
}

// A robot that localizes itself: its ghost stands where it says, and can be switched.
async function testGhosts() {
  const run = await start("self_localization", "--duration", "0.04");
  const page = await open(run.address);
  await until(page, (now) => now && now.paused && now.beliefs?.some((one) => one), "a robot tells where it believes to be");
  const ghost = () => page.evaluate(() => {
    const { view, state, scene } = window.murosimf;
    const entity = scene().text.entities.findIndex((one) => one.name === "robot");
    const group = view.ghosts.world.children[0];
    const at = view.basePlace(entity).clone();
    const truth = at.clone();
    at.applyMatrix4(group.matrix);
    return { shown: group.visible, meshes: group.children.length, at: at.toArray(), truth: truth.toArray(), said: state().beliefs[entity] };
  });
  const seen = await ghost();
  assert.ok(seen.shown && seen.meshes > 5, "a whole robot");
  assert.ok(Math.hypot(seen.at[0] - seen.said[0], seen.at[1] - seen.said[1]) < 1e-3, `where it says: ${JSON.stringify(seen)}`);
  assert.ok(Math.abs(seen.at[2] - seen.truth[2]) < 1e-6, "at its height");
  assert.ok(Math.hypot(seen.at[0] - seen.truth[0], seen.at[1] - seen.truth[1]) > 0.05, "it does not know its place yet");
  await page.evaluate(() => window.murosimf.select(window.murosimf.scene().text.entities.findIndex((one) => one.name === "robot")));
  await page.click("#follow");
  await page.waitForTimeout(300);
  await page.screenshot({ path: join(pictures, "ghosts.png") });
  await page.click("#ghosts");
  assert.equal((await ghost()).shown, false);
  await page.keyboard.press("g");
  assert.equal((await ghost()).shown, true);
  await page.close();
  await run.end();
}

async function testPhone() {
  const run = await start("three_on_three", "--duration", "60");
  const page = await open(run.address, phone);
  await until(page, (now) => now && now.time > 1, "time goes on");
  const box = await page.evaluate(() => ({ page: document.documentElement.scrollWidth, window: innerWidth }));
  assert.ok(box.page <= box.window, "nothing stands beside the screen");
  const names = await page.evaluate(() => window.murosimf.view.names);
  assert.ok(names.length > 0 && names.length <= 6, `${names.length} names are shown`);
  for (const [i, a] of names.entries()) {
    assert.ok(a.bottom - a.top <= 16.01, `a name is ${a.bottom - a.top} px high`);
    for (const b of names.slice(i + 1)) {
      assert.ok(Math.min(a.right, b.right) <= Math.max(a.left, b.left) || Math.min(a.bottom, b.bottom) <= Math.max(a.top, b.top),
        "names do not cover each other");
    }
  }
  await page.screenshot({ path: join(pictures, "phone.png") });
  await page.click("#toggle_panel");
  await page.click("#panel .list button:has-text('blue2')");
  await page.click("#follow");
  await page.waitForTimeout(500);
  await page.screenshot({ path: join(pictures, "phone_panel.png") });
  await page.close();
  await run.end();
}

async function testReconnect() {
  const run = await start("walk", "--duration", "60");
  const port = new URL(run.address).port;
  const page = await open(run.address);
  await run.end();
  await page.waitForSelector("#state.bad", { timeout: 20000 });
  const again = spawn(program, ["run", "walk", "--duration", "60", "--web", port], { stdio: "ignore" });
  children.add(again);
  await page.waitForSelector("#state:not(.bad)", { timeout: 30000 });
  again.kill("SIGKILL");
  await page.close();
}

async function testExport() {
  const file = join(pictures, "game.html");
  const made = spawnSync(program, ["run", "three_on_three", "--duration", "10", "--html", file]);
  assert.equal(made.status, 0, String(made.stderr));
  console.log(`10 s of three_on_three: ${statSync(file).size} bytes`);
  const page = await open(pathToFileURL(file).href, desktop);
  await until(page, (now) => now && now.time > 0.5 && !now.paused, "it plays");
  await page.click("#play");
  await page.evaluate(() => {
    const time = document.getElementById("time");
    time.value = "8";
    time.dispatchEvent(new Event("change"));
  });
  await until(page, (now) => Math.abs(now.time - 8) < 0.01 && now.paused, "it can be sought in");
  assert.ok((await colors(page)) > 30, "something is drawn");
  await page.screenshot({ path: join(pictures, "export.png") });
  await page.close();
}

// As agents of the league send them for RoboViz: a circle and a triangle of the set `name`, which is shown; a radius of 0: nothing is.
function circlePacket(name, radius) {
  const show = Buffer.from(`\0\0${name}\0`), color = Buffer.from([255, 128, 0]), set = Buffer.from(`${name}\0`);
  const numbers = (...all) => Buffer.from(all.map((one) => one.toFixed(4).slice(0, 6)).join(""));
  const circle = Buffer.concat([Buffer.from([1, 0]), numbers(0.5, 0.25, radius, 2), color, set]);
  const triangle = Buffer.concat([Buffer.from([1, 4, 3]), color, Buffer.from([255]), numbers(0, 0, 0, 1, 0, 0, 0, 1, 0), set]);
  return radius > 0 ? Buffer.concat([circle, triangle, show]) : show;
}

// Another program draws a circle, and takes it away; what time that was, a recording says in every form.
async function testDrawingsOfThen() {
  const html = join(pictures, "drawn.html"), file = join(pictures, "drawn.mcap");
  const child = spawn(program, ["run", "duel", "--duration", "4", "--speed", "1", "--roboviz", "0", "--html", html,
    "--record", file], { stdio: ["ignore", "ignore", "pipe"] });
  children.add(child);
  const port = await new Promise((done) => child.stderr.on("data", (text) => {
    const found = /RoboViz on 127.0.0.1:(\d+)/.exec(text);
    if (found) done(Number(found[1]));
  }));
  const door = createSocket("udp4"), ended = new Promise((done) => { child.on("exit", done); });
  for (const radius of [0.5, 1, 0]) {
    await new Promise((done) => { setTimeout(done, 800); });
    await new Promise((done) => { door.send(circlePacket("blue.1.plan", radius), port, "127.0.0.1", done); });
  }
  door.close();
  assert.equal(await ended, 0);
  const replay = await serve("replay", file);
  const spans = [];
  for (const address of [pathToFileURL(html).href, replay.address]) {
    const page = await open(address);
    if (!(await state(page)).paused) await page.click("#play");
    await until(page, (now) => now.paused, "paused");
    spans.push(await timesOfRadii(page));
    if (address.startsWith("file:")) await switchGroup(page, spans[0][0].from);
    await page.close();
  }
  await replay.end();
  for (const span of spans) assert.deepEqual(span.map((one) => one.radius), [0.5, 1], JSON.stringify(spans));
  for (const i of [0, 1]) assert.ok(Math.abs(spans[0][i].from - spans[1][i].from) < 0.21, JSON.stringify(spans));
}

const seekTo = (page, to) => page.evaluate((value) => {
  const time = document.getElementById("time");
  time.value = String(value);
  time.dispatchEvent(new Event("change"));
}, to);
const radiiDrawn = (page) => page.evaluate(() => window.murosimf.view.drawings.world.children.flatMap((group) =>
  group.children.map((one) => one.geometry.parameters).filter((ring) => ring?.innerRadius)
    .map((ring) => (ring.innerRadius + ring.outerRadius) / 2)));
const trianglesDrawn = (page) => page.evaluate(() => window.murosimf.view.drawings.world.children.flatMap((group) =>
  group.children.filter((one) => one.geometry.getAttribute("position").count === 3)).map((one) => one.geometry.getIndex().count / 3));

// From when to when which circle is seen, by going through the time line backward.
async function timesOfRadii(page) {
  const found = [], drawnAtOnce = page.url().startsWith("file:");
  for (let tenth = 38; tenth >= 0; tenth -= 2) {
    await seekTo(page, tenth / 10);
    await page.waitForFunction((time) => Math.abs(window.murosimf.state().time - time) < 0.02, tenth / 10);
    if (!drawnAtOnce) await page.waitForTimeout(150); // the server looks for drawings up to 25 times per second
    const [radius] = await radiiDrawn(page);
    if (radius === undefined) continue;
    if (found[0] && Math.abs(found[0].radius - radius) < 1e-6) found[0].from = tenth / 10;
    else found.unshift({ radius: Math.round(1000 * radius) / 1000, from: tenth / 10, to: tenth / 10 });
  }
  return found;
}

async function switchGroup(page, time) {
  await seekTo(page, time);
  await page.waitForFunction(() => window.murosimf.view.drawings.world.children.length === 1);
  assert.deepEqual(await trianglesDrawn(page), [1]);
  const box = page.locator("label:has-text('roboviz/blue.1.plan') input");
  await box.waitFor({ timeout: 20000 });
  await page.screenshot({ path: join(pictures, "drawn.png") });
  await box.uncheck();
  assert.deepEqual(await radiiDrawn(page), []);
  await box.check();
  assert.equal((await radiiDrawn(page)).length, 1);
}

// A recording: played by the server over all of its time, and as one file.
async function testRecording() {
  const file = join(pictures, "game.mcap"), html = join(pictures, "recording.html");
  const made = spawnSync(program, ["run", "duel", "--duration", "4", "--record", file]);
  assert.equal(made.status, 0, String(made.stderr));
  const replay = await serve("replay", file);
  const page = await open(replay.address);
  await until(page, (now) => now && now.end === 4 && now.time > 0.2, "it plays");
  const seek = (to) => page.evaluate((value) => {
    const time = document.getElementById("time");
    time.value = String(value);
    time.dispatchEvent(new Event("change"));
  }, to);
  await seek(3);  // where it has not been yet
  await until(page, (now) => Math.abs(now.time - 3) < 0.011 && now.paused, "it can be sought in");
  await page.click("#contacts");
  assert.ok((await colors(page)) > 30, "something is drawn");
  await page.screenshot({ path: join(pictures, "recording.png") });
  await page.click("#play");
  await until(page, (now) => now.time === 4 && now.paused, "it comes to its end");
  await page.click("#play");
  await until(page, (now) => now.time < 3, "and begins again");
  await page.close();
  await replay.end();
  assert.equal(spawnSync(program, ["replay", file, "--html", html]).status, 0);
  const alone = await open(pathToFileURL(html).href);
  await until(alone, (now) => now && now.time > 0.2 && now.end === 4, "the file plays");
  await alone.close();
}

let failed = false;
for (const test of [testDesktop, testGhosts, testPhone, testReconnect, testExport, testRecording, testDrawingsOfThen]) {
  problems.length = 0;
  try {
    await test();
    const real = problems.filter((text) => !(test === testReconnect && text.includes("WebSocket")));
    assert.deepEqual(real, [], "nothing on the console");
    console.log(`${test.name}: ok`);
  } catch (error) {
    failed = true;
    console.log(`${test.name}: FAILED\n${error.stack}`);
  }
}
await browser.close();
process.exit(failed ? 1 : 0);
