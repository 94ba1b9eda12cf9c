// Mouse, pen and touch on the model, for each way in which a tool works.
import assert from "node:assert/strict";
import {test} from "node:test";
import {openStudio, server, start} from "./support/own.mjs";

let studio, id;
start();

async function fresh(name, context = {}) {
  id = (await server.creature(name)).id;
  studio = await openStudio({scene: id, context});
  await studio.ready();
}
const steps = async () => (await server.get(`/v1/scenes/${id}/log`)).entries;
const commandsOf = (entry) => [entry.commands].flat();

/** Waits for a step of this operation. A count of steps would not do: a blower goes on making some after the hand has left. */
async function logged(op) {
  const ops = async () => (await steps()).map((entry) => commandsOf(entry)[0].op);
  for (let tries = 0; tries < 600 && !(await ops()).includes(op); ++tries) await studio.page.waitForTimeout(50);
  assert.ok((await ops()).includes(op), `no ${op} among ${await ops()}`);
}

test("a drag on the fur is one undo step of the comb, and the picture follows", async () => {
  await fresh("comb");
  await studio.tool("comb");
  await studio.drag([[0.45, 0.5], [0.6, 0.45]]);
  const scene = await studio.settled(server, id, 1);
  await studio.page.waitForFunction((revision) => window.marks.frame.some((frame) => frame.revision >= revision), scene.revision);
  assert.equal(scene.undo_steps, 1);
  const [first] = await steps();
  assert.equal(commandsOf(first)[0].op, "comb");
  assert.ok(first.touched > 0);
  await studio.page.getByRole("button", {name: "Undo"}).click();
  await studio.page.waitForFunction(() => document.querySelector('[aria-label="Undo"]').disabled);
  assert.equal((await server.get(`/v1/scenes/${id}`)).undo_steps, 0);
  await studio.page.keyboard.press("Control+Shift+Z");
  await studio.page.waitForFunction(() => !document.querySelector('[aria-label="Undo"]').disabled);
  assert.equal((await server.get(`/v1/scenes/${id}`)).undo_steps, 1);
  await studio.finish();
});

/** Positions along the top of the creature's head, with the fur that grows there. */
function crest() {
  const view = {camera: {auto: "top"}, width: 400, height: 400};
  return Promise.all([270, 280, 290, 300].map((y) => server.post(`/v1/scenes/${id}/pick`, {view, pixel: [200, y], reach: "skin"})));
}

async function growMohawk() {
  const stroke = {samples: (await crest()).map(({position}) => ({position}))};
  const brush = {radius: 0.04, strength: 1, falloff: "constant"};
  await server.post(`/v1/scenes/${id}/commands`, {commands: [{op: "lift", stroke, brush}, {op: "length", mode: "set", value: 0.15, stroke, brush}]});
}

test("a mohawk is combed by its tips, where no skin is under the pointer", async () => {
  await fresh("mohawk");
  await growMohawk();
  const top = Math.max(...(await crest()).map(({position}) => position[1]));
  await studio.page.keyboard.press("2");
  await studio.seen("rest");
  await studio.tool("comb");
  for (let pass = 0; pass < 3; ++pass) await studio.drag([[0.7, 0.3], [0.74, 0.12], [0.56, 0.13]], {steps: 12});
  const combs = async () => (await steps()).map((entry) => commandsOf(entry)[0]).filter(({op}) => op === "comb");
  const ended = async () => (await combs()).filter(({stroke}) => stroke.last).length;
  for (let tries = 0; tries < 600 && await ended() < 3; ++tries) await studio.page.waitForTimeout(50);
  const parts = await combs();
  assert.ok(parts.every(({brush}) => brush.reach === "fur"));
  const {size} = await server.get(`/v1/scenes/${id}`);
  const high = parts.flatMap(({stroke}) => stroke.samples).filter(({position}) => position?.[1] > top + 0.05 * size);
  assert.ok(high.length >= 8, `${high.length} positions among the tips`);
  const back = (await crest()).map(({direction, inclination}) => -direction[2] * inclination);
  assert.ok(back.every((lean) => lean > 0) && Math.max(...back) > 0.2, `roots follow their tips: ${back.join()}`);
  await studio.finish();
});

test("beside the model a drag turns the view and changes nothing", async () => {
  await fresh("orbit");
  const pictures = () => studio.page.evaluate(() => window.marks.frame.length);
  const cameras = [];
  studio.page.on("request", (request) => { if (request.url().includes("/frames")) cameras.push(request.postDataJSON().camera.position[0]); });
  const before_drag = await pictures();
  await studio.drag([[0.04, 0.9], [0.2, 0.8]]);
  await studio.page.waitForFunction((count) => window.marks.frame.length > count, before_drag);
  await studio.drag([[0.6, 0.5], [0.5, 0.5]], {button: "middle"});
  await studio.page.mouse.wheel(0, -240);
  await studio.page.getByRole("button", {name: "Front view"}).click();
  await studio.seen("rest");
  assert.ok(new Set(cameras).size > 2, `the camera moves: ${cameras.join()}`);
  assert.equal((await server.get(`/v1/scenes/${id}`)).revision, 0);
  await studio.finish();
});

test("Ctrl inverts, Shift smooths, [ and ] size the brush", async () => {
  await fresh("keys");
  await studio.tool("lift");
  const radius = () => studio.page.evaluate(() => JSON.parse(localStorage.getItem("pelage.brush")).radius);
  const first = await radius();
  await studio.page.keyboard.press("]");
  const second = await radius();
  assert.ok(second > first);
  await studio.page.keyboard.press("[");
  await studio.page.keyboard.press("[");
  assert.ok(await radius() < first);
  await studio.page.keyboard.down("Control");
  await studio.drag([[0.45, 0.5], [0.55, 0.5]]);
  await studio.page.keyboard.up("Control");
  await studio.settled(server, id, 1);
  await studio.page.keyboard.down("Shift");
  await studio.drag([[0.45, 0.55], [0.55, 0.55]]);
  await studio.page.keyboard.up("Shift");
  await studio.page.waitForFunction(() => document.querySelector('[aria-label="Undo"]').disabled === false);
  for (let tries = 0; tries < 100 && (await server.get(`/v1/scenes/${id}`)).undo_steps < 2; ++tries) await studio.page.waitForTimeout(50);
  const entries = await steps();
  const made = entries.filter(({kind}) => kind === "do").map((entry) => commandsOf(entry)[0]);
  assert.equal(made[0].op, "lift");
  assert.equal(made[0].brush.invert, true);
  assert.equal(made[1].op, "smooth");
  await studio.finish();
});

test("blow and pull act where the hand is", async () => {
  await fresh("wind");
  await studio.tool("blow");
  await studio.drag([[0.48, 0.5], [0.54, 0.5]]);
  await logged("blow");
  await studio.tool("attract");
  await studio.drag([[0.5, 0.5], [0.56, 0.42]]);
  await logged("attract");
  await studio.finish();
});

test("X mirrors: both sides are combed in one step", async () => {
  await fresh("mirror");
  await studio.page.keyboard.press("1");
  await studio.seen("rest");
  await studio.page.keyboard.press("x");
  await studio.tool("comb");
  await studio.drag([[0.56, 0.45], [0.58, 0.6]]);
  await studio.page.waitForFunction(() => !document.querySelector('[aria-label="Undo"]').disabled);
  for (let tries = 0; tries < 100 && (await server.get(`/v1/scenes/${id}`)).undo_steps < 1; ++tries) await studio.page.waitForTimeout(50);
  assert.equal(commandsOf((await steps())[0])[0].brush.symmetry.planes.length, 1);
  const {size, bounds, revision} = await server.get(`/v1/scenes/${id}`);
  const middle = (bounds.min[0] + bounds.max[0]) / 2;
  const view = {camera: {auto: "front"}, width: 400, height: 400};
  const differs = await server.get(`/v1/scenes/${id}/compare?from=0&to=${revision}`);
  assert.ok(differs.touched > 0 && size > 0 && Number.isFinite(middle));
  const sides = await Promise.all([160, 240].map((x) => server.post(`/v1/scenes/${id}/pick`, {view, pixel: [x, 200]})));
  assert.ok(sides.every(({hit}) => hit));
  assert.ok(Math.abs(sides[0].direction[0] + sides[1].direction[0]) < 0.35, "leans are mirror images");
  await studio.finish();
});

test("a pen's pressure comes to the log", async () => {
  await fresh("pen");
  await studio.tool("comb");
  const devtools = await studio.context.newCDPSession(studio.page);
  const pen = async (type, share, force) => {
    const [x, y] = await studio.at(...share);
    await devtools.send("Input.dispatchMouseEvent", {type, x, y, button: "left", buttons: 1, clickCount: 1, force, tiltX: 20, pointerType: "pen"});
  };
  await pen("mousePressed", [0.45, 0.5], 0.3);
  for (let k = 1; k <= 8; ++k) await pen("mouseMoved", [0.45 + 0.015 * k, 0.5], 0.3 + 0.05 * k);
  await pen("mouseReleased", [0.57, 0.5], 0.7);
  await studio.settled(server, id, 1);
  const pressures = (await steps()).flatMap((entry) => commandsOf(entry)[0].stroke.samples.map(({pressure = 1}) => pressure));
  assert.ok(pressures.some((pressure) => pressure > 0.25 && pressure < 0.9), pressures.join());
  await studio.finish();
});

test("one finger grooms, two move the camera", async () => {
  await fresh("touch", {hasTouch: true, viewport: {width: 1180, height: 820}});
  await studio.tool("comb");
  const devtools = await studio.context.newCDPSession(studio.page);
  const touch = async (type, ...shares) => {
    const touchPoints = [];
    for (const [k, share] of shares.entries()) {
      const [x, y] = await studio.at(...share);
      touchPoints.push({x, y, id: k});
    }
    await devtools.send("Input.dispatchTouchEvent", {type, touchPoints});
  };
  await touch("touchStart", [0.45, 0.5]);
  for (let k = 1; k <= 8; ++k) await touch("touchMove", [0.45 + 0.015 * k, 0.5]);
  await touch("touchEnd");
  await studio.settled(server, id, 1);
  const {undo_steps} = await server.get(`/v1/scenes/${id}`);
  assert.equal(undo_steps, 1);
  const pictures = await studio.page.evaluate(() => window.marks.frame.length);
  await touch("touchStart", [0.08, 0.85], [0.2, 0.85]);
  for (let k = 1; k <= 8; ++k) await touch("touchMove", [0.08 + 0.01 * k, 0.85], [0.2 + 0.02 * k, 0.85]);
  await touch("touchEnd");
  await studio.page.waitForFunction((count) => window.marks.frame.length > count, pictures);
  assert.equal((await server.get(`/v1/scenes/${id}`)).undo_steps, 1);
  await studio.finish();
});

test("guides are drawn, moved and deleted, and stay one step", async () => {
  await fresh("guides");
  await studio.tool("flow");
  await studio.drag([[0.56, 0.52], [0.53, 0.56], [0.5, 0.6]], {steps: 12});
  await studio.settled(server, id, 1);
  const handle = () => studio.page.getByRole("button", {name: /^Guide 1, point 1;/});
  await handle().waitFor();
  const before_move = commandsOf((await steps()).at(-1))[0].curves[0];
  const box = await handle().boundingBox();
  await studio.page.mouse.move(box.x + box.width / 2, box.y + box.height / 2);
  await studio.page.mouse.down();
  await studio.page.mouse.move(box.x - 25, box.y + 5, {steps: 6});
  await studio.page.mouse.up();
  await studio.settled(server, id, 2);
  const lines = async () => (await (await fetch(`${server.address}/v1/scenes/${id}/log?format=jsonl`)).text()).trim().split("\n").filter(Boolean).map((line) => JSON.parse(line));
  for (let tries = 0; tries < 100 && JSON.stringify((await lines())[0]?.curves[0]) === JSON.stringify(before_move); ++tries) await studio.page.waitForTimeout(50);
  assert.equal((await lines()).length, 1);
  assert.notDeepEqual((await lines())[0].curves[0], before_move);
  await handle().focus();
  await studio.page.keyboard.press("Delete");
  for (let tries = 0; tries < 100 && (await lines()).length > 0; ++tries) await studio.page.waitForTimeout(50);
  assert.deepEqual(await lines(), []);
  await studio.finish();
});

test("guides reach what lies around them and no farther", async () => {
  await fresh("reach");
  await studio.tool("flow");
  await studio.drag([[0.45, 0.55], [0.55, 0.5]], {steps: 20});
  await logged("flow");
  const {touched, commands} = (await steps()).at(-1);
  assert.ok([commands].flat()[0].reach < 0.3);
  const {vertices} = await server.get(`/v1/scenes/${id}`);
  assert.ok(touched > 0 && touched < 0.5 * vertices, `${touched} of ${vertices} vertices`);
  await studio.finish();
});

test("a flood, and a blower of the scene that is moved in the picture", async () => {
  await fresh("standing");
  await studio.tool("lift");
  await studio.page.getByRole("button", {name: "Lift everywhere"}).click();
  await studio.settled(server, id, 1);
  await studio.tool("blow");
  await studio.page.getByRole("button", {name: "Place one"}).click();
  await studio.settled(server, id, 2);
  const blower = async () => (await server.get(`/v1/scenes/${id}/settings`)).blowers[0];
  const placed = await blower();
  const handle = studio.page.getByRole("button", {name: `Blower ${placed.name}`, exact: true});
  await handle.focus();
  await studio.page.keyboard.press("ArrowRight");
  await studio.settled(server, id, 3);
  assert.notDeepEqual((await blower()).source, placed.source);
  await studio.page.getByRole("button", {name: "Use", exact: true}).click();
  await studio.settled(server, id, 4);
  assert.equal(commandsOf((await steps()).at(-1))[0].blower, placed.name);
  await studio.finish();
});

test("every tool that works everywhere does so at one press", async () => {
  await fresh("all of it");
  const tried = [];
  for (const tool of await studio.page.locator(".palette [data-tool]").evaluateAll((tools) => tools.map(({dataset}) => dataset.tool))) {
    await studio.tool(tool);
    await studio.panel("Tool");
    const everywhere = studio.page.getByRole("button", {name: /everywhere$/}).or(studio.page.getByRole("group", {name: /everywhere$/}).getByRole("button", {name: "Down"}));
    if (await everywhere.count() === 0) continue;
    const answer = studio.page.waitForResponse((response) => response.url().endsWith(`${id}/commands`));
    await everywhere.click();
    assert.equal((await answer).status(), 200, `${tool}: ${await (await answer).text()}`);
    tried.push(tool);
  }
  assert.ok(tried.includes("comb") && tried.length > 6, tried.join(", "));
  await studio.finish();
});
