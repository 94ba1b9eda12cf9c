// Steps, layers, the mask and the comparison of revisions, against what the server then has.
import assert from "node:assert/strict";
import {execFileSync} from "node:child_process";
import {dirname} from "node:path";
import {test} from "node:test";
import {openStudio, server, start} from "./support/own.mjs";
import {bin} from "./support/server.mjs";

let studio, page, id;
start();

const path = (of) => `/v1/scenes/${id}/${of}`;
const command = (body) => server.post(path("commands"), body);
const entries = async () => (await server.get(path("log"))).entries;
const kinds = async () => (await entries()).map(({kind}) => kind);
const described = () => server.get(`/v1/scenes/${id}`);
const hashes = async () => (await described()).fields_hash;
const button = (name) => page.getByRole("button", {name, exact: true});
const at = (y, z) => ({position: [0.2, y, z]});
const stroke = (...samples) => ({samples});

/** A scene with these commands, open in a panel. */
async function open(name, panel, commands, context = {}) {
  id = (await server.creature(name)).id;
  const revisions = [];
  for (const one of commands) revisions.push((await command(one)).revision);
  studio = await openStudio({scene: id, kept: {panel, author: "me"}, context});
  page = studio.page;
  await studio.seen();
  return revisions;
}
const step = (revision) => page.locator(`.step[data-revision="${revision}"]`);
const go = (revision) => step(revision).locator(".step-go").click();
const more = (revision) => step(revision).locator(".step-more").click();
const three = [
  {op: "length", flood: true, value: 0.04},
  {op: "comb", brush: {radius: 0.1}, stroke: stroke(at(0.6, -0.2), at(0.62, 0))},
  {op: "noise", flood: true, amount: 0.3},
];

test("going to a step undoes and redoes where that leads there, and reverts where it does not", async () => {
  await open("going", "history", three);
  const at_three = await hashes();
  await go(1);
  await studio.settled(server, id, 4);
  assert.deepEqual((await kinds()).slice(3), ["undo"]);
  assert.equal((await described()).redo_steps, 2);
  await page.locator('.step-here[data-revision="1"]').waitFor();
  await go(2);
  await studio.settled(server, id, 5);
  assert.equal((await described()).redo_steps, 1, "going forward by one redoes one step");
  await page.locator('.step-here[data-revision="2"]').waitFor();
  await go(3);
  await studio.settled(server, id, 6);
  assert.equal(await hashes(), at_three);
  await page.locator('.step-here[data-revision="3"]').waitFor();
  await page.locator(".step-go", {hasText: "First groom"}).click();
  await studio.settled(server, id, 7);
  await page.locator(".step-here", {hasText: "First groom"}).waitFor();
  assert.deepEqual((await kinds()).slice(3), ["undo", "redo", "redo", "undo"]);
  await command({op: "lift", flood: true});  // nothing can be redone now
  await page.locator('.step-here[data-revision="8"]').waitFor();
  await go(3);
  await studio.settled(server, id, 9);
  assert.equal((await kinds())[8], "revert");
  assert.equal(await hashes(), at_three);
  await page.locator('.step-here[data-revision="3"]').waitFor();
  assert.equal(await page.locator(".step-out", {hasText: "Lift everywhere"}).count(), 1);
  await studio.finish();
});

test("an earlier step changes after a dry run, with its stroke as it was, and can be dropped", async () => {
  await open("amended", "history", [three[0], {...three[1], stroke: {id: "a", part: 0, last: false, ...three[1].stroke}},
    {...three[1], stroke: {id: "a", part: 1, last: true, samples: [at(0.64, 0.1), at(0.66, 0.2)]}}, three[2]]);
  await more(3);
  await page.locator(".step-detail").getByLabel("Strength, as a number", {exact: true}).fill("0.3");
  await page.locator(".step-detail").getByLabel("Strength, as a number", {exact: true}).press("Enter");
  const before_try = (await described()).revision;
  await button("Try").click();
  await page.locator(".verdict li").first().waitFor();
  assert.match(await page.locator(".verdict").innerText(), /Comb: \d+ vertices \(currently \d+\+\)/);
  assert.equal((await described()).revision, before_try, "a dry run changes nothing");
  await button("Apply").click();
  await studio.settled(server, id, before_try + 1);
  const lines = await (await fetch(server.address + path("log?format=jsonl"))).text();
  const comb = JSON.parse(lines.split("\n")[1]);
  assert.equal(comb.brush.strength, 0.3);
  assert.equal(comb.stroke.samples.length, 4, "the whole stroke");
  const amended = await described();
  assert.equal(amended.undo_steps, 4);
  await page.locator(".step-inner").first().waitFor();
  assert.equal(await page.locator(".step-inner").count(), 2, "the step and the one after it ran again");
  await more(6);
  await button("Drop this step").click();
  await studio.settled(server, id, amended.revision + 1);
  const left = (await (await fetch(server.address + path("log?format=jsonl"))).text()).trim().split("\n").map((line) => JSON.parse(line).op);
  assert.deepEqual(left, ["length", "noise"]);
  await page.keyboard.press("Control+z");
  await studio.settled(server, id, amended.revision + 3);
  assert.equal(await hashes(), amended.fields_hash);
  await studio.finish();
});

test("a copied step runs as it stands: pelage, curl, Python and JSON", async () => {
  await open("it's mine", "history", three, {permissions: ["clipboard-read", "clipboard-write"]});
  await more(2);
  const copied = async (label) => {
    await page.getByRole("group", {name: "Copy as"}).getByRole("button", {name: label, exact: true}).click();
    await page.locator(".message", {hasText: `as ${label}`}).waitFor();
    return page.evaluate(() => navigator.clipboard.readText());
  };
  const env = {...process.env, PATH: `${bin}:${process.env.PATH}`};
  let {revision} = await described();
  for (const [label, run] of [["Command line", "sh"], ["curl", "sh"], ["Python", "python3"]]) {
    execFileSync(run, {input: await copied(label), env, cwd: dirname(bin), stdio: ["pipe", "ignore", "ignore"]});
    const after_run = await described();
    assert.equal(after_run.revision, ++revision, label);
    const newest = (await entries()).at(-1);
    assert.equal(newest.commands.op, "comb");
    assert.equal(newest.commands.stroke.samples.length, 2);
  }
  assert.equal(JSON.parse(await copied("JSON")).op, "comb");
  await studio.finish();
});

test("text that must not go to the clipboard is shown to be copied by hand", async () => {
  await open("by hand", "history", three.slice(0, 1));
  await page.evaluate(() => { navigator.clipboard.writeText = () => Promise.reject(new Error("no")); });
  await more(1);
  await button("JSON").click();
  assert.match(await page.getByLabel("Text to copy").inputValue(), /"op": "length"/);
  await page.keyboard.press("Escape");
  await page.getByLabel("Text to copy").waitFor({state: "detached"});
  await studio.finish();
});

test("checkpoints are named and gone to; a branch opens as a scene of its own", async () => {
  await open("named", "history", three);
  await page.getByLabel("Name of the checkpoint").fill("soft");
  await button("Checkpoint").click();
  await page.locator('.step[data-revision="4"]').waitFor();
  await more(2);
  await button("Checkpoint here").click();
  await page.getByLabel("Name of the checkpoint").last().fill("combed");
  await page.getByLabel("Name of the checkpoint").last().press("Enter");
  await studio.settled(server, id, 5);
  assert.deepEqual((await server.get(path("settings"))).checkpoints.map(({name, revision}) => [name, revision]).sort(), [["combed", 2], ["soft", 4]]);
  const chips = page.getByRole("group", {name: "Go to a checkpoint"});
  await chips.getByRole("button", {name: "combed"}).click();
  await page.locator('.step-here[data-revision="2"]').waitFor();
  await chips.getByRole("button", {name: "soft"}).click();  // the name stays, although it is younger than the state
  await page.locator('.step-here[data-revision="4"]').waitFor();
  await button("Branch from here").click();
  await page.locator(".scene-name", {hasText: "named, "}).waitFor();
  const {scenes} = await server.get("/v1/scenes");
  assert.equal(scenes.find(({name}) => name.startsWith("named, ")).revision, 2);
  await studio.finish();
});

test("layers are added, weighed, muted, moved, merged and removed", async () => {
  await open("layers", "layers", [three[0]]);
  const layers = async () => (await described()).edit_layers;
  const until = async (check) => {
    for (let tries = 0; tries < 200; ++tries) {
      if (check(await layers())) return;
      await page.waitForTimeout(50);
    }
    assert.fail(JSON.stringify(await layers()));
  };
  await button("Add a layer").click();
  await until((all) => all.length === 1);
  await page.getByLabel("Tools write to layer 1").waitFor();
  assert.ok(await page.getByLabel("Tools write to layer 1").isChecked(), "a new layer is taken in hand");
  await button("Rename layer 1").click();
  await page.getByLabel("New name of layer 1").fill("ruff");
  await page.getByLabel("New name of layer 1").press("Enter");
  await until((all) => all[0].name === "ruff");
  await page.getByLabel("Tools write to ruff").waitFor();
  assert.ok(await page.getByLabel("Tools write to ruff").isChecked(), "and stays in hand under its new name");
  await button("Add a layer").click();
  await until((all) => all.length === 2);
  await page.getByLabel("Weight of ruff, as a number").fill("2.5");
  await page.getByLabel("Weight of ruff, as a number").press("Enter");
  await until((all) => all[0].weight === 2.5);
  await page.getByLabel("Weight of layer 2", {exact: true}).focus();
  await page.keyboard.press("Home");
  await until((all) => all[1].weight === 0);
  await button("Mute layer 2").click();
  await until((all) => all[1].muted);
  await button("Only layer 2").click();
  await until((all) => all[0].muted && !all[1].muted);
  await page.locator('[aria-label="Only layer 2"][aria-pressed="true"]').click();
  await until((all) => !all[0].muted && all[1].muted);
  await button("Move ruff").focus();
  await page.keyboard.press("ArrowUp");
  await until((all) => all[1].name === "ruff");
  await page.waitForFunction(() => document.querySelector("[data-layer]").dataset.layer === "ruff");
  const from = await button("Move ruff").boundingBox(), to = await page.locator('[data-layer="layer 2"]').boundingBox();
  await page.mouse.move(from.x + 5, from.y + 8);
  await page.mouse.down();
  await page.mouse.move(from.x + 5, to.y + to.height - 4, {steps: 6});
  await page.mouse.up();
  await until((all) => all[0].name === "ruff");
  await page.getByLabel("Tools write to ruff").check();
  await page.getByRole("tab", {name: "Tool", exact: true}).click();
  await page.keyboard.press("l");
  await button("Length everywhere").click();
  await studio.settled(server, id, (await described()).revision);
  await page.getByRole("tab", {name: "Layers"}).click();
  await button("Merge ruff down").click();
  await until((all) => all.length === 1);
  await page.waitForFunction(() => document.querySelectorAll(".layer").length === 2);
  assert.ok(await page.getByLabel("Base groom").isChecked(), "the tools' layer is gone");
  await button("Remove layer 2").click();
  await until((all) => all.length === 0);
  await studio.finish();
});

test("the mask is shown, inverted, painted and cleared", async () => {
  await open("masked", "tool", [three[0], {op: "mask", sphere: {centre: [0.2, 0.6, 0], radius: 0.3}}]);
  const last = async () => (await entries()).at(-1).commands;
  const overlays = [];
  page.on("request", (request) => { if (request.url().includes("/frames")) overlays.push(request.postDataJSON().overlay); });
  await page.keyboard.press("m");
  assert.equal(await button("Show").getAttribute("aria-pressed"), "true");
  await page.waitForTimeout(300);
  assert.equal(overlays.at(-1), "mask");
  await page.keyboard.press("Control+i");
  await studio.settled(server, id, 3);
  assert.equal((await last()).action, "invert");
  await page.getByText("Grow, shrink and blur by").click();
  await page.getByLabel("Distance, as a number").fill("0.1");
  await page.getByLabel("Distance, as a number").press("Enter");
  await button("Grow").click();
  await studio.settled(server, id, 4);
  assert.equal((await last()).distance, 0.1);
  await button("Shrink").click();
  await studio.settled(server, id, 5);
  await button("Blur").click();
  await studio.settled(server, id, 6);
  assert.equal((await last()).action, "smooth");
  await button("Clear").click();
  await studio.settled(server, id, 7);
  await button("Protect").click();
  await studio.ready();
  await studio.drag([[0.45, 0.5], [0.55, 0.5]]);
  await studio.settled(server, id, 8);
  const painted = await last();
  assert.equal(painted.op, "paint");
  assert.equal(painted.field, "mask");
  assert.equal(painted.value, 0);
  assert.equal(await button("Show").getAttribute("aria-pressed"), "true");
  await page.keyboard.press("m");
  await studio.tool("comb");
  await button("Protect").click();
  assert.equal(await button("Show").getAttribute("aria-pressed"), "true", "the mask is shown while it is painted");
  await studio.tool("comb");
  assert.equal(await button("Show").getAttribute("aria-pressed"), "false", "and not longer");
  await studio.finish();
});

test("an earlier revision is wiped over the present one and follows the camera", async () => {
  await open("compared", "history", three);
  const asked = [];
  page.on("request", (request) => { if (request.url().includes("/frames")) asked.push(request.postDataJSON()); });
  await more(1);
  await button("Compare with now").click();
  const divider = page.getByRole("slider", {name: "Divider between earlier and now"});
  await divider.waitFor();
  await page.waitForFunction(() => document.querySelector(".compare-past").width === document.querySelector(".picture").width);
  const past = asked.filter(({revision}) => revision === 1).at(-1);
  assert.deepEqual(past.camera, asked.filter(({revision}) => revision === undefined).at(-1).camera);
  await divider.focus();
  await page.keyboard.press("Shift+ArrowLeft");
  assert.equal(await divider.getAttribute("aria-valuenow"), "40");
  const box = await page.locator(".surface").boundingBox();
  await page.mouse.move(box.x + 0.4 * box.width, box.y + 0.8 * box.height);
  await page.mouse.down();
  await page.mouse.move(box.x + 0.7 * box.width, box.y + 0.8 * box.height, {steps: 4});
  await page.mouse.up();
  assert.equal(await divider.getAttribute("aria-valuenow"), "70");
  await studio.drag([[0.04, 0.9], [0.2, 0.8]]);
  const turned = () => asked.some(({revision, format, camera}) => revision === 1 && format === undefined && camera.position[0] !== past.camera.position[0]);
  for (let tries = 0; tries < 400 && !turned(); ++tries) await page.waitForTimeout(50);
  assert.ok(turned(), "the full picture of the earlier one from the new position");
  await button("Show what changed").click();
  for (let tries = 0; tries < 400 && !asked.some(({overlay}) => overlay === "difference"); ++tries) await page.waitForTimeout(50);
  assert.equal(asked.find(({overlay}) => overlay === "difference").overlay_from, 1);
  assert.ok(asked.filter(({revision}) => revision === 1).every(({overlay}) => overlay !== "difference"), "the earlier one is shown as it was");
  await button("Close the comparison").click();
  await divider.waitFor({state: "detached"});
  await studio.finish();
});

test("a batch is one step with the words of its first command", async () => {
  await open("batch", "history", [{commands: [{op: "length", flood: true, value: 0.02}, {op: "noise", flood: true, amount: 0.2}]}]);
  await page.locator(".step-name", {hasText: "Length everywhere and 1 more"}).waitFor();
  await more(1);
  await studio.finish();
});
