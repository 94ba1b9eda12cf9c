// The default toolset of an agent: few tools and small pictures, which give access to the whole product.
import assert from "node:assert/strict";
import {mkdtempSync, readFileSync, rmSync} from "node:fs";
import {tmpdir} from "node:os";
import {join} from "node:path";
import {test} from "node:test";
import {agent, start, thinScene} from "./support/agent.mjs";

const scene = "fox";
const view = {width: 192, height: 192};

start(() => thinScene(scene, "sphere", 1000), []);

const folder = mkdtempSync(join(tmpdir(), "pelage-mcp-"));
test.after(() => rmSync(folder, {recursive: true}));

test("the usual tools take less than 30 kB of an agent's context", () => {
  const {length} = JSON.stringify([...agent.tools.values()]);
  assert.ok(length < 30_000, `${length} characters`);
  assert.ok(!agent.tools.has("comb"));
});

test("commands are described, run, amended, compared and branched", async () => {
  const all = await agent.call("describe_commands");
  assert.match(all.text, /^comb: [A-Z]/m);
  const described = await agent.call("describe_commands", {ops: ["comb", "length"]});
  assert.ok(described.data.comb.properties.brush.$ref.startsWith("#/$defs/") && described.data.$defs.Brush && described.data.length);
  const fault = await agent.refused("describe_commands", {ops: ["cmb"]});
  assert.equal(fault.nearest, "comb");

  await agent.call("run_commands", {scene, commands: [{op: "length", flood: true, value: 0.02, brush: {strength: 1}}]});
  await agent.call("run_commands", {scene, commands: [{op: "noise", flood: true, amount: 0.2}]});
  const amended = await agent.call("amend_step", {scene, revision: 2, commands: [{op: "length", flood: true, value: 0.05, brush: {strength: 1}}]});
  const {data: compared, text} = await agent.call("compare_revisions", {scene, from: 3, to: amended.data.revision});
  assert.deepEqual(compared.fields.map(({field}) => field), ["length"]);
  assert.match(text, /differ at \d+ vertices: length of/);
  const {data: branch} = await agent.call("branch_scene", {scene, name: "try", revision: 2});
  assert.ok(branch.name === "try" && branch.undo_steps === 2);
});

test("cameras have names, in pictures and in strokes", async () => {
  const of = async (camera) => (await agent.call("look", {scene, camera, ...view})).image.data;
  assert.equal(await of("left"), await of({auto: "left"}));
  const muzzle = {position: [0.4, 0.2, 4], target: [0, 0.2, 0]};
  await agent.call("name_camera", {name: "muzzle", camera: muzzle});
  assert.equal(await of("muzzle"), await of(muzzle));
  const stroke = {view: {camera: "muzzle", ...view}, samples: [{screen: [90, 96]}, {screen: [110, 96]}]};
  const {data} = await agent.call("preview_change", {scene, commands: [{op: "comb", brush: {radius: 0.2}, stroke}], camera: "muzzle"});
  assert.ok(data.results[0].touched > 10);
  const unknown = await agent.refused("views", {scene, views: [{camera: "left"}, {camera: "muzle"}]});
  assert.deepEqual([unknown.pointer, unknown.nearest], ["/views/1/camera", "muzzle"]);
  assert.equal((await agent.refused("name_camera", {name: "left", camera: muzzle})).pointer, "/name");
});

test("pictures have at most a megabyte and say what they have", async () => {
  const small = await agent.call("look", {scene, ...view});
  assert.match(small.text, /Picture: 192 x 192, image\/png, \d+ kB\./);
  assert.equal(Buffer.from(small.image.data, "base64").length, small.data.picture.bytes);
  const large = await agent.call("look", {scene, width: 1600, height: 1600, quality: "draft"});
  assert.equal(large.image.mimeType, "image/jpeg");
  assert.ok(large.data.picture.bytes <= 1_000_000);
  const sides = await agent.call("views", {scene, width: 512, height: 512, quality: "draft"});
  assert.ok(sides.data.picture.bytes <= 1_000_000);
  assert.ok(sides.data.views[0].width < 512 && sides.text.includes(`${sides.data.views[0].width} x`));
});

test("a groom is exported to a file, which is not replaced unless asked", async () => {
  const path = join(folder, "fox.usda");
  const {data} = await agent.call("export_scene", {scene, path, every: 50});
  assert.ok(data.strands > 10 && readFileSync(path, "utf8").startsWith("#usda"));
  assert.equal(readFileSync(path).length, data.bytes);
  assert.equal((await agent.refused("export_scene", {scene, path})).pointer, "/path");
  await agent.call("export_scene", {scene, path, every: 100, overwrite: true});
  assert.ok(readFileSync(path).length < data.bytes);
  assert.equal((await agent.refused("export_scene", {scene, path: join(folder, "fox.fbx")})).nearest !== undefined, true);
  assert.equal((await agent.refused("export_scene", {scene, path: "/nowhere/fox.usda"})).pointer, "/path");
});
