// Coat, look, light and eyes: each finished change is one undo step, and what the server then has is what the panel shows.
import assert from "node:assert/strict";
import {test} from "node:test";
import {openStudio, server, start} from "./support/own.mjs";

let studio, page, id;
start();

async function open(name, panel) {
  id = (await server.creature(name)).id;
  studio = await openStudio({scene: id, kept: {panel}});
  page = studio.page;
  await studio.ready();
}
const settings = () => server.get(`/v1/scenes/${id}/settings`);
const steps = async () => (await server.get(`/v1/scenes/${id}`)).undo_steps;

async function stepsAre(count) {
  for (let tries = 0; tries < 400 && await steps() < count; ++tries) await page.waitForTimeout(50);
  assert.equal(await steps(), count);
}

test("a look by its picture is one step", async () => {
  await open("looks", "coat");
  const before_look = (await settings()).coats[0].coat;
  await page.getByRole("group", {name: "Looks to begin with"}).getByRole("button", {name: /leopard/i}).click();
  await stepsAre(1);
  const {coat} = (await settings()).coats[0];
  assert.notDeepEqual(coat, before_look);
  assert.equal(coat.pattern.kind, "rosettes");
  await studio.finish();
});

test("a slider that is dragged is one step, tried in the picture meanwhile", async () => {
  await open("slider", "coat");
  const slider = page.getByLabel("Bend", {exact: true});
  await slider.scrollIntoViewIfNeeded();
  const box = await slider.boundingBox();
  await page.mouse.move(box.x + box.width * 0.3, box.y + box.height / 2);
  await page.mouse.down();
  for (let k = 0; k <= 10; ++k) await page.mouse.move(box.x + box.width * (0.3 + 0.05 * k), box.y + box.height / 2);
  await page.waitForTimeout(800);
  assert.equal(await steps(), 0, "nothing of the scene changes while it is dragged");
  await page.mouse.up();
  await stepsAre(1);
  assert.ok((await settings()).coats[0].coat.bend > 0.5);
  await studio.finish();
});

test("a light is added, dragged around the model and taken away", async () => {
  await open("lights", "light");
  await page.setViewportSize({width: 1280, height: 800});  // so that the handle has room to be dragged
  const first = (await settings()).lights;
  await page.getByText("Each light").click();
  await page.getByRole("button", {name: "Add a light"}).click();
  await stepsAre(1);
  assert.equal((await settings()).lights.length, first.length + 1);
  const handle = page.getByRole("button", {name: "Light 2", exact: true}).and(page.locator(".handle"));
  const box = await handle.boundingBox();
  await page.mouse.move(box.x + box.width / 2, box.y + box.height / 2);
  await page.mouse.down();
  await page.mouse.move(box.x - 90, box.y + 40, {steps: 10});
  await page.mouse.up();
  await stepsAre(2);
  assert.notDeepEqual((await settings()).lights[1].direction, first[1].direction);
  await page.getByRole("button", {name: /^Delete light/}).click();
  await stepsAre(3);
  assert.equal((await settings()).lights.length, first.length);
  await studio.finish();
});

test("an eye stands where the model is pressed, with its pair, and no fur grows on it", async () => {
  await open("eyes", "look");
  const {length} = (await settings()).eyes;
  await page.getByRole("button", {name: /place an eye/i}).click();
  await page.locator(".hint-line").waitFor();
  await page.mouse.click(...await studio.at(0.5, 0.5));
  await stepsAre(1);
  const {eyes} = await settings();
  assert.equal(eyes.length, length + 2);
  const [one, other] = eyes.slice(-2).map(({position}) => position);
  const {bounds, size} = await server.get(`/v1/scenes/${id}`);
  assert.ok(Math.abs(one[0] + other[0] - bounds.min[0] - bounds.max[0]) < 0.03 * size, "a pair in the mirror");
  const query = {nearest: one};
  assert.ok((await server.post(`/v1/scenes/${id}/pick`, query)).painted.density < 0.2);
  await page.waitForFunction(() => !document.querySelector('[aria-label="Undo"]').disabled);  // the page knows of it too
  await page.keyboard.press("Control+z");
  await page.waitForFunction(() => document.querySelector('[aria-label="Undo"]').disabled);
  assert.equal((await settings()).eyes.length, length);
  await studio.finish();
});

test("handles move, size and turn an eye in the picture, and its pair follows", async () => {
  await open("handles", "look");
  await page.keyboard.press("1");
  await studio.seen("rest");
  const before_drag = (await settings()).eyes;
  assert.equal(before_drag.length, 2);
  let steps = 0;
  for (const [name, by] of [["Size of eye 1", [0, -12]], ["Eye 1", [0, 24]], ["Where eye 1 looks", [20, 30]]]) {
    const box = await page.getByRole("button", {name, exact: true}).and(page.locator(".handle")).boundingBox();
    const [x, y] = [box.x + box.width / 2, box.y + box.height / 2];
    await page.mouse.move(x, y);
    await page.mouse.down();
    await page.mouse.move(x + by[0], y + by[1], {steps: 6});
    await page.mouse.up();
    await stepsAre(++steps);
  }
  const eyes = (await settings()).eyes;
  const {bounds, size} = await server.get(`/v1/scenes/${id}`);
  for (const [k, eye] of eyes.entries()) {
    assert.ok(eye.radius > before_drag[k].radius, `radius ${eye.radius}`);
    assert.ok(eye.position[1] < before_drag[k].position[1], "it is lower");
  }
  assert.ok(Math.abs(eyes[0].radius - eyes[1].radius) < 1e-9);
  assert.ok(Math.abs(eyes[0].position[0] + eyes[1].position[0] - bounds.min[0] - bounds.max[0]) < 0.01 * size);
  assert.ok(Math.abs(eyes[0].gaze[0] + eyes[1].gaze[0]) < 1e-6 && Math.abs(eyes[0].gaze[1] - eyes[1].gaze[1]) < 1e-6);
  await studio.finish();
});

test("coats are added, groomed, muted, renamed, ordered and removed", async () => {
  await open("coats", "coat");
  const coats = async (check) => {
    for (let tries = 0; tries < 400; ++tries) {
      const now = (await settings()).coats;
      if (check(now)) return now;
      await page.waitForTimeout(50);
    }
    assert.fail(JSON.stringify((await settings()).coats.map(({name, id, muted}) => ({name, id, muted}))));
  };
  const button = (name) => page.getByRole("button", {name, exact: true});
  await page.getByLabel("Where a new coat grows").selectOption({label: "Everywhere"});
  await button("Add a coat").click();
  await coats((all) => all.length === 2);
  await page.getByLabel("Tools work on coat 2").waitFor();
  await page.getByRole("radio", {name: "Tools work on coat 2", checked: true}).waitFor();  // a new coat is taken in hand
  const slider = page.getByLabel("Bend", {exact: true});
  await slider.fill("0.75");
  const bent = await coats((all) => all[1].coat.bend > 0.7);
  assert.ok(bent[0].coat.bend < 0.5, "the sliders are those of the chosen coat");
  const before = await steps();
  await page.locator(".surface").focus();
  await studio.drag([[0.5, 0.5], [0.55, 0.52]]);
  await stepsAre(before + 1);
  const {entries} = await server.get(`/v1/scenes/${id}/log`);
  assert.deepEqual(entries.at(-1).commands.coats, ["coat 2"]);
  await studio.panel("Coat");
  await button("Rename coat 2").click();
  await page.getByLabel("New name of coat 2").fill("mane");
  await page.getByLabel("New name of coat 2").press("Enter");
  await coats((all) => all[1]?.name === "mane");
  await page.getByRole("radio", {name: "Tools work on mane", checked: true}).waitFor();
  await button("Move mane up").click();
  await coats((all) => all[0].name === "mane" && all[0].id === 1);
  await button("Mute mane").click();
  await coats((all) => all[0].muted);
  await page.getByRole("radio", {name: "All coats", checked: true}).waitFor();  // a muted one is taken out of the hand
  assert.ok(await button("Mute fur").isDisabled(), "one is seen");
  await button("Remove mane").click();
  await coats((all) => all.length === 1);
  await studio.finish();
});
