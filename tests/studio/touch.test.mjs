// The hand touches the fur that is seen, and what is seen is the scene that is open.
import assert from "node:assert/strict";
import {test} from "node:test";
import {openStudio, server, start} from "./support/own.mjs";

let id;
start({prepare: async () => { id = (await server.creature("touch")).id; }});

/** The camera of the newest picture that was asked for, as a view for picks. */
async function viewOf(studio) {
  const box = await studio.page.locator(".surface").boundingBox();
  const camera = await studio.page.evaluate(() => window.asked.findLast(({view}) => !view.endsWith("-tool")).camera);
  return {camera, width: Math.round(box.width), height: Math.round(box.height)};
}

/** Remembers the requests of frames, and holds answers of a scene back for a while. */
const watched = () => {
  const send = window.fetch;
  window.asked = [];
  window.held = {};
  window.fetch = async (path, options) => {
    if (!/\/frames/.test(path)) return send(path, options);
    const scene = path.split("/")[3];
    window.asked.push({scene, ...JSON.parse(options.body)});
    const answer = await send(path, options);
    if (window.held[scene] ?? window.held.all) await new Promise((go) => setTimeout(go, window.held[scene] ?? window.held.all));
    return answer;
  };
};

async function open() {
  const studio = await openStudio({scene: id, before: watched, kept: {brush: {radius: 0.04}}});
  await studio.ready();
  await studio.seen("rest");
  return studio;
}

const handOf = (studio) => studio.page.locator(".surface").getAttribute("data-hand");

/** Going left along a line of the picture, from inside of the model: the last pixel with skin, and the last with fur. */
async function edgesAt(view, y, from) {
  const at = (x, reach) => server.post(`/v1/scenes/${id}/pick`, {view, pixel: [x, y], reach});
  let skin = from;
  while (skin > 4 && (await at(skin - 4, "skin")).hit) skin -= 4;
  let fur = skin;
  while (fur > 2 && (await at(fur - 2, "fur")).strand) fur -= 2;
  return {skin, fur};
}

test("fur is touched where no skin lies under it, and the cursor says so before", async () => {
  const studio = await open();
  const {page} = studio;
  const view = await viewOf(studio);
  const y = 0.58 * view.height, {skin, fur} = await edgesAt(view, y, 0.5 * view.width);
  assert.ok(fur < skin - 4, `fur to ${fur}, skin to ${skin}`);
  const [left, top] = await studio.at(0, 0);
  await page.mouse.move(left + 0.5 * (skin + fur), top + y);
  await page.waitForFunction(() => document.querySelector(".surface").dataset.hand === "groom");
  await page.mouse.down();
  await page.mouse.move(left + skin + 30, top + y - 20, {steps: 10});
  await page.mouse.up();
  const {revision} = await studio.settled(server, id, 1);
  const {entries} = await server.get(`/v1/scenes/${id}/log`);
  assert.ok(entries.at(-1).touched > 0);
  assert.ok(revision >= 1);
  await studio.finish();
});

test("a stroke begins in the air where the ring reaches fur; farther away a drag turns", async () => {
  const studio = await open();
  const {page} = studio;
  const view = await viewOf(studio);
  const before_stroke = (await server.get(`/v1/scenes/${id}`)).revision;
  const y = 0.58 * view.height, {fur} = await edgesAt(view, y, 0.5 * view.width);
  const [left, top] = await studio.at(0, 0);
  await page.mouse.move(left + fur - 12, top + y);
  await page.waitForFunction(() => document.querySelector(".surface").dataset.hand === "groom");
  await page.mouse.down();
  await page.mouse.move(left + fur + 40, top + y - 20, {steps: 12});
  await page.mouse.up();
  await studio.settled(server, id, before_stroke + 1);
  await page.mouse.move(left + fur - 150, top + y);
  await page.waitForFunction(() => document.querySelector(".surface").dataset.hand === "turn");
  assert.equal(await page.locator(".surface").evaluate((element) => getComputedStyle(element).cursor), "grab");
  await studio.finish();
});

test("the hand learns of fur that grew", async () => {
  const studio = await open();
  const {page} = studio;
  const loaded = await page.evaluate(() => window.marks.proxy.length);
  const {revision} = await server.post(`/v1/scenes/${id}/commands`, {op: "length", flood: true, mode: "set", value: 0.2, brush: {strength: 1}});
  await page.waitForFunction(([count, wanted]) => window.marks.proxy.length > count && window.marks.proxy.at(-1).revision >= wanted, [loaded, revision]);
  await server.post(`/v1/scenes/${id}/undo`, {});
  await studio.finish();
});

test("of two scenes opened one after the other only the last is seen", async () => {
  const other = (await server.creature("other")).id, third = (await server.creature("third")).id;
  const studio = await open();
  const {page} = studio;
  await page.evaluate((slow) => { window.held[slow] = 1200; }, other);
  await studio.panel("Files");
  const scene = (name) => page.locator(".scene-open", {hasText: new RegExp(`^${name}`)});
  await scene("other").click();
  await page.waitForFunction((slow) => window.asked.some(({scene}) => scene === slow), other);
  await scene("third").click();
  await page.locator(".scene-name", {hasText: "third"}).waitFor();
  const from = await page.evaluate(() => window.marks.frame.length);
  await studio.seen("rest");
  await page.waitForTimeout(1800);
  const seen = await page.evaluate((first) => [...new Set(window.marks.frame.slice(first).map(({scene}) => scene))], from);
  assert.deepEqual(seen, [third]);
  await studio.finish();
});

test("a setting that is tried in one scene is not seen in the next", async () => {
  const next = (await server.creature("next")).id;
  const studio = await open();
  const {page} = studio;
  await studio.panel("Coat");
  const slider = page.locator(".panel input[type=range], aside input[type=range]").first();
  await slider.evaluate((element) => { element.value = "0.9"; element.dispatchEvent(new Event("input", {bubbles: true})); });
  await page.waitForFunction((own) => window.asked.some(({scene}) => scene !== own), id);
  await studio.panel("Files");
  await page.locator(".scene-open", {hasText: /^next/}).click();
  await page.locator(".scene-name", {hasText: "next"}).waitFor();
  await studio.seen("rest");
  const last = await page.evaluate(() => window.marks.frame.at(-1).scene);
  assert.equal(last, next);
  await studio.finish();
});

test("cube and ring move with the picture, and not before it", async () => {
  const studio = await open();
  const {page} = studio;
  const cube = () => page.locator(".view-cube svg").innerHTML();
  const before_turn = await cube();
  await page.evaluate(() => { window.held.all = 700; });
  await page.keyboard.press("1");
  await page.waitForTimeout(350);
  assert.equal(await cube(), before_turn, "the old picture is seen still");
  await page.waitForFunction((old) => document.querySelector(".view-cube svg").innerHTML !== old, before_turn);
  await page.evaluate(() => { window.held = {}; });
  await studio.seen("rest");
  await page.waitForFunction(() => !document.querySelector(".badge-pending").textContent);
  await studio.finish();
});

test("a better picture fades in over the one before", async () => {
  const studio = await openStudio({scene: id, context: {reducedMotion: "no-preference"}, before: () => {
    window.fades = 0;
    const animate = Element.prototype.animate;
    Element.prototype.animate = function (...how) { if (this.className === "picture") ++window.fades; return animate.apply(this, how); };
  }});
  await studio.ready();
  await studio.seen("rest");
  assert.ok(await studio.page.evaluate(() => window.fades) >= 1);
  assert.equal(await studio.page.locator("canvas.picture[data-front]").count(), 1);
  await studio.finish();
});

test("tools speak as artists do, and are drawn on the scene's own animal", async () => {
  const studio = await open();
  const {page} = studio;
  const trials = async () => (await server.get("/v1/scenes")).scenes.filter(({name}) => name.startsWith("studio: trial")).length;
  const before_trials = await trials();
  const jargon = /sigma|dijkstra|flip\b|lengyel|\br\d+\b|\d\+ vert|kajiya/i;
  const tools = await page.locator(".palette [data-tool]").evaluateAll((all) => all.map((one) => one.dataset.tool));
  for (const tool of tools) {
    await studio.tool(tool);
    assert.doesNotMatch(await page.locator(".panels, aside").first().innerText(), jargon, tool);
    for (const name of ["Strength", "Radius"]) assert.ok(await page.locator(`:text-is("${name}"):visible`).count() <= 1, `${tool}: one ${name}`);
  }
  for (const panel of ["History", "Files", "Light", "Coat", "Layers"]) {
    await studio.panel(panel);
    assert.doesNotMatch(await page.locator(".panels, aside").first().innerText(), jargon, panel);
  }
  await studio.panel("Tool");
  await studio.tool("part");
  await page.locator(".tool-picture[data-drawn] img").first().waitFor({timeout: 60000});
  for (let tries = 0; await trials() > before_trials; ++tries) {
    assert.ok(tries < 200, "the copy is thrown away");
    await page.waitForTimeout(50);
  }
  await studio.finish();
});

test("the first stroke of Paint paints", async () => {
  const studio = await open();
  const before_stroke = (await server.get(`/v1/scenes/${id}`)).revision;
  await studio.tool("paint");
  await studio.drag([[0.5, 0.5], [0.58, 0.48]]);
  await studio.settled(server, id, before_stroke + 1);
  const {entries} = await server.get(`/v1/scenes/${id}/log`);
  const painted = entries.map(({commands}) => [commands].flat()[0]).find((command) => command?.op === "paint");
  assert.equal(painted.field, "tip_colour");
  assert.ok(painted.colour);
  await studio.finish();
});
