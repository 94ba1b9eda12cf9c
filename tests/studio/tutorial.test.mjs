// The tutorial of docs/studio.md, done as it says: from nothing to a groomed, downloaded fox.
// With PELAGE_PICTURES=FOLDER the pictures of that page are written there.
import assert from "node:assert/strict";
import {mkdirSync, readFileSync} from "node:fs";
import {join} from "node:path";
import {test} from "node:test";
import {openStudio, server, start} from "./support/own.mjs";

const folder = process.env.PELAGE_PICTURES;
start();

/** Tracing on or off, in the card of the dial. */
async function trace(studio, on) {
  await studio.page.locator(".dial-button").click();
  await studio.page.getByLabel(/Continue to Final/).setChecked(on);
  await studio.page.keyboard.press("Escape");
}

/** Waits for strands of so many passes. */
async function traced(studio, passes) {
  await studio.page.evaluate(() => { window.marks.frame.length = 0; });
  await studio.page.waitForFunction((wanted) => window.marks.frame.filter(({stage}) => stage === "traced").length >= wanted, passes, {timeout: 300000});
}

/** A picture for the page, with strands and with the pointer at a position in the picture. */
async function picture(studio, name, pointer = [0.02, 0.5]) {
  if (!folder) return;
  await trace(studio, true);
  await studio.page.evaluate(() => document.activeElement.blur());
  await studio.page.mouse.move(...await studio.at(...pointer));
  await traced(studio, 4);
  mkdirSync(folder, {recursive: true});
  await studio.page.screenshot({path: join(folder, `${name}.jpg`), type: "jpeg", quality: 82});
  await trace(studio, false);
}

/** Grey values of a part of the picture at rest, given by its middle and half its side as shares of the picture. */
async function greys(studio, [x, y], half) {
  await studio.page.waitForTimeout(400);
  await studio.seen("rest");
  await studio.page.waitForFunction(() => !document.querySelector(".badge-pending").textContent);
  return studio.page.evaluate(([x, y, half]) => {
    const picture = document.querySelector("canvas.picture[data-front]"), side = 2 * half * picture.height;
    const pen = Object.assign(document.createElement("canvas"), {width: 128, height: 128}).getContext("2d");
    pen.drawImage(picture, x * picture.width - side / 2, y * picture.height - side / 2, side, side, 0, 0, 128, 128);
    const {data} = pen.getImageData(0, 0, 128, 128);
    return Array.from({length: 128 * 128}, (_, k) => (data[4 * k] + data[4 * k + 1] + data[4 * k + 2]) / 3);
  }, [x, y, half]);
}
/** Grey values once two pictures at rest agree: the first may still be the better one of before. */
async function still_greys(studio, middle, half) {
  let before = await greys(studio, middle, half);
  for (let tries = 0; tries < 20; ++tries) {
    const now = await greys(studio, middle, half);
    if (difference(before, now) < 1) return now;
    before = now;
  }
  return assert.fail("the picture does not come to rest");
}
const difference = (a, b) => a.reduce((sum, grey, k) => sum + Math.abs(grey - b[k]), 0) / a.length;

const undo_steps = async (id) => (await server.get(`/v1/scenes/${id}`)).undo_steps;
async function stepsAre(studio, id, count) {
  for (let tries = 0; tries < 400 && await undo_steps(id) < count; ++tries) await studio.page.waitForTimeout(50);
  assert.ok(await undo_steps(id) >= count, `${await undo_steps(id)} steps, not ${count}`);
}

/** Along the flank towards the head, the lowest last. */
const against_the_fur = [[0.5, 0.46], [0.54, 0.5], [0.58, 0.52], [0.62, 0.54]].map(([y, to]) => [[0.61, y], [0.5, to]]);
const clearly = 8;  // grey values of 255, on the mean

test("a fox, groomed and downloaded", async () => {
  const studio = await openStudio({kept: {welcomed: false}, context: {colorScheme: "dark"}});
  const {page} = studio;
  await studio.ready();
  await picture(studio, "first-visit");
  await page.getByRole("button", {name: "Begin"}).click();
  const [{id}] = (await server.get("/v1/scenes")).scenes;
  const begun = await undo_steps(id);

  await page.keyboard.press("x");
  await studio.tool("comb");
  for (let press = 0; press < 4; ++press) await page.keyboard.press("]");
  await page.getByRole("button", {name: "Brush up", exact: true}).click();
  const flank = [0.56, 0.55], as_it_came = await still_greys(studio, flank, 0.1);
  for (const [k, stroke] of against_the_fur.entries()) {
    await studio.drag(stroke, {steps: 25});
    await stepsAre(studio, id, begun + 1 + k);
  }
  const combed = await greys(studio, flank, 0.1);
  assert.ok(difference(as_it_came, combed) > clearly, `the combed fur is seen: ${difference(as_it_came, combed)}`);
  await picture(studio, "comb", [0.58, 0.58]);

  await studio.tool("length");
  await page.getByRole("button", {name: "Long", exact: true}).click();
  await studio.drag([[0.4, 0.6], [0.43, 0.68]], {steps: 10});
  await stepsAre(studio, id, begun + 1 + against_the_fur.length);
  await picture(studio, "length", [0.42, 0.64]);

  await studio.panel("Coat");
  await picture(studio, "coat");
  await studio.panel("Light");
  await page.getByRole("slider", {name: "Shadow", exact: true}).waitFor();  // the ground's, which an AOV of that name is not
  await picture(studio, "light");
  await studio.panel("History");
  await picture(studio, "history");

  await studio.panel("Files");
  const download = page.waitForEvent("download");
  await page.getByRole("button", {name: /^PNG/}).click();
  const saved = await (await download).path();
  assert.equal(readFileSync(saved).subarray(1, 4).toString(), "PNG");
  await picture(studio, "files");
  await studio.finish();
});

const windows = {
  "window-dark": {viewport: {width: 1440, height: 900}, colorScheme: "dark"},
  "window-light": {viewport: {width: 1440, height: 900}, colorScheme: "light"},
  "tablet-dark": {viewport: {width: 1180, height: 820}, colorScheme: "dark", hasTouch: true},
  "tablet-light": {viewport: {width: 1180, height: 820}, colorScheme: "light", hasTouch: true},
};
const panels = {"window-dark": "coat", "window-light": "layers", "tablet-dark": "light", "tablet-light": "tool"};

if (folder) {
  for (const [name, context] of Object.entries(windows)) {
    test(`a picture of the ${name.replace("-", ", ")}`, async () => {
      const kept = {panel: panels[name], "trace-at-rest": true};
      const studio = await openStudio({context, kept});
      await studio.ready();
      await studio.page.mouse.move(...await studio.at(0.52, 0.55));
      await traced(studio, 5);
      await studio.page.screenshot({path: join(folder, `${name}.jpg`), type: "jpeg", quality: 82});
      await studio.close();
    });
  }
}
