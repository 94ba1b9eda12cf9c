// Several scenes of one model: what is seen and what the hand does belong to the scene that is open.
import assert from "node:assert/strict";
import {test} from "node:test";
import {openStudio, server, start} from "./support/own.mjs";

let studio, first, second;

/** A ball of one colour: the same model for all, at the same revision. */
async function ball(name, colour) {
  const {id} = await server.post("/v1/scenes", {name, model: {builtin: "sphere", triangles: 2000}});
  await server.post(`/v1/scenes/${id}/commands`, {commands: ["root_colour", "tip_colour"].map((field) => ({op: "paint", flood: true, field, colour}))});
  return id;
}

async function prepare() {
  first = await ball("red ball", "#ff0000");
  second = await ball("blue ball", "#0000ff");
  studio = await openStudio({scene: first});
  await studio.ready();
  await studio.panel("Files");
}
start({prepare, finish: async () => studio?.finish()});

const openId = () => studio.page.evaluate(() => new URLSearchParams(location.search).get("scene"));
const row = (name) => studio.page.locator(".scene-open", {hasText: name});
/** By a press of the row's button, wherever the pointer is. */
const open = (name) => row(name).evaluate((button) => button.click());

/** The colour in the middle of the picture, as red, green, blue. */
const middle = () => studio.page.evaluate(() => {
  const picture = document.querySelector("canvas.picture[data-front]"), copy = document.createElement("canvas");
  [copy.width, copy.height] = [picture.width, picture.height];
  copy.getContext("2d").drawImage(picture, 0, 0);
  return [...copy.getContext("2d").getImageData(picture.width / 2, picture.height / 2, 1, 1).data];
});

test("a scene of the same model and revision is shown with its own picture", async () => {
  await studio.seen("rest");
  const [r, , b] = await middle();
  assert.ok(r > 2 * b, `${r} red, ${b} blue`);
  await open("blue ball");
  await studio.page.waitForFunction((id) => new URLSearchParams(location.search).get("scene") === id, second);
  await studio.seen("rest");
  const [red_now, , blue_now] = await middle();
  assert.ok(blue_now > 2 * red_now, `${red_now} red, ${blue_now} blue`);
});

test("of two scenes opened one soon after the other, the last stays", async () => {
  await studio.page.route(`**/v1/scenes/${first}`, async (route) => { await new Promise((wake) => setTimeout(wake, 600)); await route.continue(); });
  const slow = studio.page.waitForResponse((answer) => answer.url().endsWith(first));
  await studio.page.evaluate(() => { for (const button of document.querySelectorAll(".scene-open")) button.disabled = false; });
  await open("red ball");
  await open("blue ball");
  await slow;
  await studio.page.waitForTimeout(100);
  assert.equal(await openId(), second);
  await studio.page.unroute(`**/v1/scenes/${first}`);
});

test("a stroke stays with the scene that it began on", async () => {
  await open("red ball");
  await studio.page.waitForFunction((id) => new URLSearchParams(location.search).get("scene") === id, first);
  await studio.seen();
  const before = await Promise.all([first, second].map((id) => server.get(`/v1/scenes/${id}`)));
  const [x, y] = await studio.at(0.5, 0.5);
  await studio.page.mouse.move(x, y);
  await studio.page.mouse.down();
  await studio.page.mouse.move(x + 30, y, {steps: 8});
  await open("blue ball");
  await studio.page.waitForFunction((id) => new URLSearchParams(location.search).get("scene") === id, second);
  await studio.page.mouse.move(x + 60, y, {steps: 8});
  await studio.page.mouse.up();
  await studio.settled(server, first, before[0].revision + 1);
  await studio.page.waitForFunction(() => !Object.keys(localStorage).some((name) => name.startsWith("pelage.outbox")));
  const after = await Promise.all([first, second].map((id) => server.get(`/v1/scenes/${id}`)));
  assert.ok(after[0].revision > before[0].revision);
  assert.equal(after[1].revision, before[1].revision, "the other scene was groomed");
});

/** How many cells of a sheet show something, each another thing. */
const differentCells = (image, [columns, rows]) => {
  const pen = new OffscreenCanvas(image.naturalWidth, image.naturalHeight).getContext("2d", {willReadFrequently: true});
  pen.drawImage(image, 0, 0);
  const [width, height] = [Math.floor(image.naturalWidth / columns), Math.floor(image.naturalHeight / rows)], seen = new Set();
  for (let k = 0; k < columns * rows; ++k) {
    const {data} = pen.getImageData((k % columns) * width, Math.floor(k / columns) * height, width, height - 60);
    const colours = new Set(new Uint32Array(data.buffer));
    if (colours.size > 500) seen.add(data.reduce((sum, byte, at) => (sum * 31 + byte * (at % 7 + 1)) % 1000003, 7));
  }
  return seen.size;
};

test("the list shows scenes by their pictures, and sheets are made at one press", async () => {
  const shown = (await server.creature("sheet")).id, other = (await server.creature("besides")).id;
  const studio = await openStudio({scene: shown});
  const {page} = studio;
  await studio.ready();
  await studio.seen("rest");
  await studio.panel("Files");
  await page.locator(".scene-row", {hasText: "besides"}).locator("img").waitFor({timeout: 60000});
  for (const [button, ending] of [["Contact sheet", "contact sheet.png"], ["Before and after", "before and after.png"], ["Side by side: besides", "and besides.png"]]) {
    await page.getByRole("button", {name: button}).click();
    const picture = page.locator(".sheet img");
    await picture.waitFor({timeout: 90000});
    const [width, height] = await picture.evaluate((image) => [image.naturalWidth, image.naturalHeight]);
    assert.ok(width >= 1280 && height >= 500, `${width} x ${height}`);
    if (button === "Contact sheet") assert.equal(await picture.evaluate(differentCells, [3, 2]), 6);
    const saved = page.waitForEvent("download");
    await page.getByRole("button", {name: "Download", exact: true}).click();
    assert.equal((await saved).suggestedFilename(), `sheet ${ending}`);
    await page.keyboard.press("Escape");
  }
  assert.ok(other);
  await studio.finish();
});

test("a picture stands there at once when the studio is opened again", async () => {
  const {id} = await server.creature("again");
  const studio = await openStudio({scene: id});
  const {page} = studio;
  await studio.ready();
  await studio.seen("rest");
  await page.waitForFunction(() => localStorage.getItem("pelage.last-picture")?.includes("data:image/jpeg"));
  await page.route("**/frames*", async (route) => { await new Promise((go) => setTimeout(go, 3000)); await route.continue().catch(() => undefined); });
  await page.reload();
  const stored = page.locator(".stored-picture");
  await stored.waitFor({timeout: 2500});
  assert.match(await stored.getAttribute("src"), /^data:image\/jpeg/);
  await page.unrouteAll({behavior: "ignoreErrors"});
  await studio.seen();
  assert.equal(await stored.count(), 0);
  await studio.finish();
});
