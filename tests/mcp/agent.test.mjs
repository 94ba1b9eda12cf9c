// The example of docs/agents.md: an agent without any knowledge of Pelage makes a scene, looks, combs and undoes.
import assert from "node:assert/strict";
import {mkdtempSync, rmSync} from "node:fs";
import {tmpdir} from "node:os";
import {join} from "node:path";
import {test} from "node:test";
import {objFolder} from "../studio/support/models.mjs";
import {agent, pixelsOf, start, thinScene} from "./support/agent.mjs";

const scene = "fox";
const view = {width: 192, height: 192};
let first;

/** A stroke over the middle of the picture, from the schema's own forms of samples. */
const stroke = () => ({view: {...view}, samples: [{screen: [80, 96]}, {screen: [96, 96]}, {screen: [112, 96]}]});
const comb = () => ({brush: {radius: 0.15}, lean: 0.9, stroke: stroke()});
const look = async () => pixelsOf((await agent.call("look", {scene, ...view})).image);
const revision = async () => (await agent.call("describe_scene", {scene})).data.revision;

start(async () => {
  await thinScene(scene, "sphere", 3000);
  first = await look();
});

/** How many pixels differ. */
function difference(a, b) {
  assert.deepEqual([a.width, a.height, a.channels], [b.width, b.height, b.channels]);
  let count = 0;
  for (let k = 0; k < a.data.length; k += a.channels) if ([0, 1, 2].some((c) => a.data[k + c] !== b.data[k + c])) ++count;
  return count;
}

test("it combs, sees the fur change, undoes and sees it as before", async () => {
  assert.deepEqual([first.width, first.height], [192, 192]);
  const combed = await agent.call("comb", {scene, ...comb()});
  assert.equal(combed.data.revision, 2);
  assert.ok(combed.data.results[0].touched > 100);
  assert.match(combed.text, /touched \d+ vertices: direction.*`undo` takes it back/s);
  assert.ok(difference(first, await look()) > 500, "the fur has not moved");
  const undone = await agent.call("undo", {scene});
  assert.deepEqual([undone.data.undo_steps, undone.data.redo_steps], [1, 1]);
  assert.equal(difference(first, await look()), 0, "the fur is not as before");
  await agent.call("redo", {scene});
  assert.ok(difference(first, await look()) > 500);
  await agent.call("revert", {scene, revision: 1});
  assert.equal(difference(first, await look()), 0);
});

test("a dry run says what would change, shows it, and changes nothing", async () => {
  const before = await revision();
  const scenes = (await agent.call("list_scenes")).data.scenes.length;
  const dry = await agent.call("comb", {scene, ...comb(), dry_run: true});
  const preview = await agent.call("preview_change", {scene, commands: [{op: "comb", ...comb()}], camera: {auto: "three_quarter"}});
  for (const {data, text} of [dry, preview]) {
    const [{touched, mean_change, max_change}] = data.results;
    assert.ok(data.dry_run && touched > 100 && mean_change > 0 && max_change >= mean_change);
    assert.match(text, /would touch \d+ vertices.*nothing has changed/s);
  }
  assert.deepEqual(preview.data.views.map(({number}) => number), [1, 2, 3]);
  assert.deepEqual([pixelsOf(preview.image).width, pixelsOf(preview.image).height], [3 * 384 + 2 * 4, 384]);
  assert.equal(await revision(), before);
  assert.equal((await agent.call("list_scenes")).data.scenes.length, scenes, "the branch of the picture is still there");
  assert.equal(difference(first, await look()), 0);
});

test("a pixel is picked and combed from in every form that pick gives", async () => {
  const {data} = await agent.call("pick", {scene, view: {...view}, pixel: [96, 96]});
  assert.ok(data.hit && data.samples.length === 3);
  const touched = [];
  for (const sample of data.samples) {
    const end = {position: data.position.map((value, k) => value + (k === 2 ? 0.1 : 0))};
    const answer = await agent.call("comb", {scene, brush: {reach: "skin"}, stroke: {view: {...view}, samples: [sample, end]}, dry_run: true});
    touched.push(answer.data.results[0].touched);
  }
  assert.ok(touched[0] > 10 && touched.every((count) => Math.abs(count - touched[0]) <= 2), `positions differ: ${touched}`);
  const missed = await agent.call("pick", {scene, view: {...view}, pixel: [1, 1]});
  assert.equal(missed.data.hit, false);
});

test("several commands are one step, the log has them, and settings come back", async () => {
  const before = (await agent.call("describe_scene", {scene})).data;
  const commands = [{op: "length", flood: true, value: 0.02}, {op: "noise", flood: true, amount: 0.2}];
  await agent.call("run_commands", {scene, commands});
  const {data} = await agent.call("log", {scene, last: 1});
  assert.deepEqual([data.entries[0].ops, data.entries[0].author], [["length", "noise"], "scripted agent"]);
  assert.equal((await agent.call("describe_scene", {scene})).data.undo_steps, before.undo_steps + 1);
  await agent.call("undo", {scene});
  const {data: settings} = await agent.call("read_settings", {scene, only: ["coats"]});
  assert.deepEqual(Object.keys(settings), ["coats"]);
  const [{name, coat}] = settings.coats;
  await agent.call("set_coat", {scene, name, coat: {...coat, count: 12345}});
  assert.equal((await agent.call("read_settings", {scene, only: ["coats"]})).data.coats[0].coat.count, 12345);
});

test("a model is loaded from a file", async () => {
  const folder = mkdtempSync(join(tmpdir(), "pelage-mcp-"));
  try {
    const path = join(objFolder(folder), "box.obj");
    await agent.call("create_scene", {name: "box", model: {builtin: "plane", triangles: 2}});
    const {data, text} = await agent.call("load_model", {scene: "box", path, up: "z", front: "x", length: 0.1});
    assert.deepEqual([data.model, data.vertices, data.triangles, data.up, data.front], ["obj", 8, 12, "z", "x"]);
    assert.match(text, /8 vertices, 12 triangles/);
    await agent.call("noise", {scene: "box", flood: true});
    const loaded = await agent.call("load_model", {scene: "box", path});
    assert.match(loaded.text, /The groom was transferred: 0 of 8 vertices/);
    assert.equal((await agent.call("describe_scene", {scene: loaded.data.carried.before})).data.undo_steps, 1);
    assert.equal((await agent.call("load_model", {scene: "box", path, discard: true})).data.undo_steps, 0);
  } finally {
    rmSync(folder, {recursive: true});
  }
});

test("fields come from another scene, and a removed scene is gone", async () => {
  await agent.call("create_scene", {name: "twin", model: {builtin: "sphere", triangles: 3000}});
  await agent.call("length", {scene: "twin", flood: true, value: 0.01, brush: {strength: 1}});
  const {data} = await agent.call("retarget", {scene, source_scene: "twin"});
  assert.ok(data.results[0].touched > 1000);
  await agent.call("remove_scene", {scene: "twin"});
  assert.ok((await agent.call("list_scenes")).data.scenes.every(({name}) => name !== "twin"));
});
