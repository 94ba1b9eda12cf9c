// Faster hands: keys that are held, the pie menu, colours, presets, a steady hand, and buttons where there are no keys.
import assert from "node:assert/strict";
import {test} from "node:test";
import {openStudio, server, start} from "./support/own.mjs";

let id;
start({prepare: async () => { id = (await server.creature("hand")).id; }});

const open = async (options = {}) => {
  const studio = await openStudio({scene: id, ...options});
  await studio.ready();
  return studio;
};
const brush = (studio) => studio.page.evaluate(() => JSON.parse(localStorage.getItem("pelage.brush")));
const newest = async () => (await server.get(`/v1/scenes/${id}/log`)).entries.flatMap(({commands}) => [commands ?? []].flat()).at(-1);
const revision = async () => (await server.get(`/v1/scenes/${id}`)).revision;

test("a held F sizes the brush, Shift+F its strength, and no stroke is made", async () => {
  const studio = await open({kept: {brush: {radius: 0.05, strength: 0.5}}});
  const {page} = studio;
  const before_keys = await revision();
  const [x, y] = await studio.at(0.5, 0.55);
  await page.mouse.move(x, y);
  await page.keyboard.down("f");
  await page.mouse.move(x + 40, y, {steps: 4});
  await page.keyboard.up("f");
  const wider = await brush(studio);
  assert.ok(wider.radius > 0.07, `radius ${wider.radius}`);
  await page.mouse.move(x, y);
  await page.keyboard.down("Shift");
  await page.keyboard.down("F");
  await page.mouse.move(x - 60, y, {steps: 4});
  await page.keyboard.up("F");
  await page.keyboard.up("Shift");
  const weaker = await brush(studio);
  assert.ok(weaker.strength < 0.35, `strength ${weaker.strength}`);
  assert.equal(weaker.radius, wider.radius);
  await page.mouse.move(x - 120, y);
  assert.deepEqual(await brush(studio), weaker, "the pointer is free again");
  assert.equal(await revision(), before_keys);
  await studio.finish();
});

test("Space opens tools around the pointer, and the one that it goes to is taken", async () => {
  const studio = await open();
  const {page} = studio;
  const [x, y] = await studio.at(0.5, 0.55);
  await page.mouse.move(x, y);
  await page.keyboard.down(" ");
  await page.locator(".pie-tool").first().waitFor();
  await page.mouse.move(x + 80, y, {steps: 4});
  await page.locator('.pie-tool[aria-checked="true"]', {hasText: "Length"}).waitFor();
  await page.keyboard.up(" ");
  await page.locator('[data-tool="length"][aria-pressed="true"]').waitFor();
  assert.equal(await page.locator(".pie").count(), 0);
  await studio.finish();
});

test("a colour is chosen on the wheel, by swatches and from the fur", async () => {
  const studio = await open();
  const {page} = studio;
  await studio.tool("paint");
  const button = page.locator(".colour-button").first(), card = page.locator(".colour-card:popover-open");
  const colour = async () => (await page.evaluate(() => JSON.parse(localStorage.getItem("pelage.tool-values")))).paint.colour;
  await button.click();
  const wheel = await card.locator("canvas").boundingBox();
  await page.mouse.click(wheel.x + 0.85 * wheel.width, wheel.y + 0.5 * wheel.height);
  const [red, green, blue] = [1, 3, 5].map(((hex) => (at) => parseInt(hex.slice(at, at + 2), 16))(await colour()));
  assert.ok(red > 200 && green < 140 && blue < 140, `${red} ${green} ${blue}`);
  await card.getByRole("button", {name: "#8a4b22"}).click();
  assert.equal(await colour(), "#8a4b22");
  await card.getByRole("textbox").fill("12ab9F");
  await page.keyboard.press("Enter");
  assert.equal(await colour(), "#12ab9f");
  const before_drop = await revision();
  await card.getByRole("button", {name: "From the fur"}).click();
  await studio.page.getByText("Press on the fur").waitFor();
  await page.mouse.click(...await studio.at(0.55, 0.55));
  await page.waitForFunction(() => JSON.parse(localStorage.getItem("pelage.tool-values")).paint.colour !== "#12ab9f");
  const [r, , b] = [1, 3, 5].map(((hex) => (at) => parseInt(hex.slice(at, at + 2), 16))(await colour()));
  assert.ok(r > b, "a fox is red");
  assert.equal(await revision(), before_drop, "the press painted nothing");
  await studio.finish();
});

test("settings are saved under a name and removed again", async () => {
  const studio = await open({kept: {brush: {radius: 0.03}, "tool-values": {comb: {lean: 0.2}}}});
  const {page} = studio;
  await page.getByRole("button", {name: "Save…"}).click();
  await page.getByLabel("Name of the preset").fill("Whiskers");
  await page.keyboard.press("Enter");
  await page.getByRole("button", {name: "Brush up"}).click();
  await page.getByLabel("Radius, as a number").first().fill("0.2");
  await page.keyboard.press("Enter");
  await page.reload();
  await page.getByRole("button", {name: "Whiskers", exact: true}).click();
  assert.equal((await brush(studio)).radius, 0.03);
  assert.equal((await page.evaluate(() => JSON.parse(localStorage.getItem("pelage.tool-values")))).comb.lean, 0.2);
  await page.getByRole("button", {name: "Forget Whiskers"}).click();
  assert.equal(await page.getByRole("button", {name: "Whiskers", exact: true}).count(), 0);
  await studio.finish();
});

/** How far samples of the newest stroke lie from the line between its ends, in pixels of the mean. */
async function roughness(studio) {
  const before_stroke = await revision();
  const [x, y] = await studio.at(0.4, 0.55);
  await studio.page.mouse.move(x, y);
  await studio.page.mouse.down();
  for (let k = 1; k <= 40; ++k) await studio.page.mouse.move(x + 4 * k, y + (k % 2 ? 9 : -9));
  const sent = studio.page.waitForRequest((request) => request.url().endsWith(`${id}/commands`) && request.postDataJSON()?.stroke?.last === true);
  await studio.page.mouse.up();
  await sent;
  await studio.settled(server, id, before_stroke + 1);
  return studio.heights.reduce((sum, height) => sum + Math.abs(height - y + studio.top), 0) / studio.heights.length;
}

test("a steady hand draws a smoother line", async () => {
  const rough = {};
  for (const steady of [0, 1]) {
    const studio = await open({kept: {steady}});
    studio.heights = [];
    studio.top = (await studio.page.locator(".surface").boundingBox()).y;
    studio.page.on("request", (request) => { if (request.url().endsWith(`${id}/commands`)) studio.heights.push(...(request.postDataJSON()?.stroke?.samples ?? []).map(({screen}) => screen[1])); });
    rough[steady] = await roughness(studio);
    await studio.finish();
  }
  assert.ok(rough[0] > 5 && rough[1] < 0.4 * rough[0], `${rough[0]} and ${rough[1]} pixels`);
});

test("the mirror belongs to the hand and is no step", async () => {
  const studio = await open();
  const before_mirror = await revision();
  await studio.page.keyboard.press("x");
  await studio.page.locator('[aria-label="Mirror"][aria-pressed="true"]').waitFor();
  await studio.page.waitForTimeout(300);
  assert.equal(await revision(), before_mirror);
  await studio.drag([[0.5, 0.55], [0.56, 0.5]]);
  await studio.settled(server, id, before_mirror + 1);
  assert.equal((await newest()).brush.symmetry.planes.length, 1);
  await studio.finish();
});

test("a screen without keys has buttons for the opposite and for smooth", async () => {
  const studio = await open({context: {hasTouch: true, viewport: {width: 1180, height: 820}}});
  const {page} = studio;
  const button = (name) => page.locator(".hand-buttons").getByRole("button", {name});
  await studio.tool("lift");
  await button("Opposite").click();
  const before_stroke = await revision();
  await studio.drag([[0.5, 0.55], [0.56, 0.5]]);
  await studio.settled(server, id, before_stroke + 1);
  assert.equal((await newest()).brush.invert, true);
  await button("Opposite").click();
  await button("Smooth").click();
  await studio.drag([[0.45, 0.55], [0.51, 0.5]]);
  for (let tries = 0; tries < 200 && (await newest()).op !== "smooth"; ++tries) await page.waitForTimeout(50);
  assert.equal((await newest()).op, "smooth");
  await studio.finish();
});

test("a part of the model is chosen by a press, and is all that tools change then", async () => {
  const studio = await open();
  await studio.page.getByRole("button", {name: "A part…"}).press("Enter");  // a click could miss it: the panel still grows
  await studio.page.getByText("Press on the part").waitFor();
  const sent = studio.page.waitForRequest((request) => request.url().endsWith(`${id}/commands`));
  await studio.page.mouse.move(...await studio.at(0.5, 0.55));
  await studio.page.waitForFunction(() => document.querySelector(".surface").dataset.hand === "groom");
  await studio.page.mouse.click(...await studio.at(0.5, 0.55));
  const {op, part} = (await sent).postDataJSON();
  assert.equal((await (await sent).response()).status(), 200);
  assert.equal(op, "mask");
  assert.equal(part.position.length, 3);
  await studio.finish();
});

test("an alpha is sent as a picture, and each stroke names it", async () => {
  const studio = await open();
  const {page} = studio;
  const put = page.waitForResponse((response) => response.url().endsWith(`${id}/pictures`));
  await page.getByLabel("Alpha").selectOption("Streaks");
  const {picture, width} = await (await put).json();
  assert.equal(width, 64);
  await page.waitForFunction(() => document.querySelector('select option[value="Streaks"]').selected);
  const sent = page.waitForRequest((request) => request.url().includes(`${id}/commands`));
  await studio.drag([[0.45, 0.55], [0.55, 0.55]]);
  assert.equal((await sent).postDataJSON().brush.alpha, picture);
  assert.equal((await (await sent).response()).status(), 200);
  await page.getByLabel("Alpha").selectOption("");
  const plain = page.waitForRequest((request) => request.url().includes(`${id}/commands`));
  await studio.drag([[0.45, 0.55], [0.55, 0.55]]);
  assert.equal((await plain).postDataJSON().brush.alpha, undefined);
  await studio.finish();
});

test("keys work where the pointer is", async () => {
  const studio = await open();
  const {page} = studio;
  await page.getByRole("button", {name: "Undo"}).focus();
  await page.getByRole("tab", {name: "Coat"}).focus();
  await page.mouse.move(5, 5);
  await page.mouse.move(...await studio.at(0.5, 0.5));
  assert.equal(await page.evaluate(() => document.activeElement.className), "surface");
  await page.keyboard.press("s");
  await page.locator('[data-tool="smooth"][aria-pressed="true"]').waitFor();
  await studio.finish();
});

test("what the mask protects is hidden and not touched, until it is shown again", async () => {
  const own = (await server.creature("hidden")).id;
  await server.post(`/v1/scenes/${own}/commands`, {op: "mask", sphere: {centre: [0, 0.75, 0.55], radius: 0.15}});  // its head
  const studio = await openStudio({scene: own});
  await studio.ready();
  const {page} = studio;
  const [x, y] = await studio.at(0.6, 0.62);  // its hind side
  const hand = (wanted) => page.waitForFunction((what) => document.querySelector(".surface").dataset.hand === what, wanted);
  const redness = async () => page.evaluate(([left, top]) => {
    const canvas = document.querySelector("canvas.picture[data-front]"), box = canvas.getBoundingClientRect();
    const pixel = new OffscreenCanvas(1, 1).getContext("2d");
    pixel.drawImage(canvas, (left - box.left) * canvas.width / box.width, (top - box.top) * canvas.height / box.height, 1, 1, 0, 0, 1, 1);
    const [red, , blue] = pixel.getImageData(0, 0, 1, 1).data;
    return red - blue;  // fur of a fox is red, the background is grey
  }, [x, y]);
  await page.mouse.move(x, y);
  await hand("groom");
  const furry = await redness();
  const frame = page.waitForRequest((request) => request.url().includes("/frames") && JSON.parse(request.postData()).masked === true);
  await page.getByRole("button", {name: "Hide the rest"}).click();
  await (await frame).response();
  await page.waitForFunction(() => window.marks.proxy.length > 1);
  await page.mouse.move(x + 3, y);
  await hand("turn");
  await page.mouse.move(...await studio.at(0.37, 0.45));
  await hand("groom");
  assert.ok(furry > 25 && (await redness()) < 12, `${furry} before, ${await redness()} after`);
  await page.mouse.move(x, y);
  await page.keyboard.press("Shift+M");
  await hand("groom");
  await studio.finish();
});
