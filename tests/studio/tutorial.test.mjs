// The tutorial of docs/studio.md, done as it says: from nothing to a groomed, downloaded fox.
// With PELAGE_PICTURES=FOLDER the pictures of that page are written there.
import assert from "node:assert/strict";
import {mkdirSync, readFileSync} from "node:fs";
import {join} from "node:path";
import {after, before, test} from "node:test";
import {Server} from "./support/server.mjs";
import {Studio, browser} from "./support/studio.mjs";

const folder = process.env.PELAGE_PICTURES;
let server, chrome;

before(async () => {
  server = await Server.start();
  chrome = await browser();
});
after(async () => {
  await chrome?.close();
  await server?.stop();
});

/** A picture for the page, once the picture at rest is there. */
async function picture(studio, name) {
  if (!folder) return;
  await studio.page.waitForTimeout(400);
  await studio.seen("rest");
  mkdirSync(folder, {recursive: true});
  await studio.page.screenshot({path: join(folder, `${name}.jpg`), type: "jpeg", quality: 82});
}

const undo_steps = async (id) => (await server.get(`/v1/scenes/${id}`)).undo_steps;
async function stepsAre(studio, id, count) {
  for (let tries = 0; tries < 400 && await undo_steps(id) < count; ++tries) await studio.page.waitForTimeout(50);
  assert.ok(await undo_steps(id) >= count, `${await undo_steps(id)} steps, not ${count}`);
}

test("a fox, groomed and downloaded", async () => {
  const kept = folder ? {dial: {kind: "tier", tier: "detailed"}, welcomed: false} : {welcomed: false};
  const studio = await Studio.open(chrome, server.address, {kept});
  const {page} = studio;
  await studio.ready();
  await picture(studio, "first-visit");
  await page.getByRole("button", {name: "Begin"}).click();
  const [{id}] = (await server.get("/v1/scenes")).scenes;
  const begun = await undo_steps(id);

  await page.keyboard.press("x");
  await stepsAre(studio, id, begun + 1);
  await studio.tool("comb");
  await studio.drag([[0.58, 0.5], [0.5, 0.56], [0.46, 0.62]], {steps: 20});
  await stepsAre(studio, id, begun + 2);
  await picture(studio, "comb");

  await studio.tool("length");
  await page.getByRole("button", {name: "Long", exact: true}).click();
  await studio.drag([[0.4, 0.6], [0.43, 0.68]], {steps: 10});
  await stepsAre(studio, id, begun + 3);
  await picture(studio, "length");

  await studio.panel("Coat");
  await picture(studio, "coat");
  await studio.panel("Light");
  await picture(studio, "light");
  await studio.panel("History");
  await picture(studio, "history");

  await studio.panel("Files");
  const download = page.waitForEvent("download");
  await page.getByRole("button", {name: /^PNG/}).click();
  const saved = await (await download).path();
  assert.equal(readFileSync(saved).subarray(1, 4).toString(), "PNG");
  await picture(studio, "files");
  studio.quiet();
  await studio.close();
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
      const kept = {dial: {kind: "tier", tier: "detailed"}, panel: panels[name], "trace-at-rest": true};
      const studio = await Studio.open(chrome, server.address, {context, kept});
      await studio.ready();
      await studio.page.mouse.move(...await studio.at(0.52, 0.55));
      await studio.seen("traced");
      await studio.page.waitForFunction(() => window.marks.frame.at(-1).stage === "traced" && window.marks.frame.filter(({stage}) => stage === "traced").length > 5, null, {timeout: 120000});
      await studio.page.screenshot({path: join(folder, `${name}.jpg`), type: "jpeg", quality: 82});
      await studio.close();
    });
  }
}
