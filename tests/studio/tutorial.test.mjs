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
