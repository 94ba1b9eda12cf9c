// Models, recipes and samples into the studio, pictures and steps out of it.
import assert from "node:assert/strict";
import {execFileSync} from "node:child_process";
import {mkdtempSync, readFileSync, rmSync, writeFileSync} from "node:fs";
import {tmpdir} from "node:os";
import {join} from "node:path";
import {test} from "node:test";
import {gltfFolder, hoofFile, objFolder} from "./support/models.mjs";
import {openStudio, server, start} from "./support/own.mjs";
import {bin} from "./support/server.mjs";

const recipes = new URL("../../clients/recipes/", import.meta.url).pathname;
let studio, folder;

async function prepare() {
  folder = mkdtempSync(join(tmpdir(), "pelage-files-"));
  const {id} = await server.creature("start");
  studio = await openStudio({scene: id, alone: true});
  studio.expected.push(/Failed to load resource/);  // what the server refuses is part of the tests
  await studio.ready();
  await studio.panel("Files");
}
async function finish() {
  rmSync(folder, {recursive: true, force: true});
  await studio?.finish();
}
start({prepare, finish});

/** A drop as the system makes it, with real files and folders. */
async function drop(...paths) {
  const session = await studio.context.newCDPSession(studio.page);
  for (const type of ["dragEnter", "dragOver", "drop"]) {
    await session.send("Input.dispatchDragEvent", {type, x: 600, y: 400, data: {items: [], files: paths, dragOperationsMask: 1}});
  }
  await session.detach();
}
const card = () => studio.page.getByRole("group", {name: "Upload"});
const press = (name) => studio.page.getByRole("button", {name, exact: true}).click();
const openId = () => studio.page.evaluate(() => new URLSearchParams(location.search).get("scene"));
const linesOf = async (id) => (await (await fetch(`${server.address}/v1/scenes/${id}/log?format=jsonl`)).text()).trim();

async function uploaded(name) {
  await press("Upload");
  await card().getByText(`${name} is loaded`).waitFor({timeout: 60000});
  return server.get(`/v1/scenes/${await openId()}`);
}

test("a folder with an OBJ, its materials and its picture becomes a scene with a skin texture", async () => {
  await drop(objFolder(folder));
  await card().getByText("Its texture is uploaded, too.").waitFor();
  const scene = await uploaded("box");
  assert.equal(scene.model, "obj");
  assert.equal(scene.triangles, 12);
  assert.match(await linesOf(scene.id), /set_skin_texture/);
  await card().getByText("polygons were split into triangles").waitFor();
});

test("materials named after hooves are left bare, and tools work on one by its name", async () => {
  await drop(hoofFile(folder));
  const scene = await uploaded("strip");
  await card().getByText("Left bare: Hoof.").waitFor();
  await press("Good");
  const sent = studio.page.waitForRequest((request) => request.url().endsWith(`${scene.id}/commands`));
  await studio.page.getByRole("tab", {name: "Tool"}).click();
  await studio.page.getByRole("combobox", {name: "Material"}).selectOption("Pelt");
  assert.deepEqual((await sent).postDataJSON().material, {name: "Pelt"});
  assert.equal((await (await sent).response()).status(), 200);
  await studio.panel("Files");
});

test("of several pictures one is used, and the card says which", async () => {
  await drop(objFolder(folder, {two: true}));
  await card().getByText(/use 2 pictures.*Skin\.PNG is used/).waitFor();
  await press("Cancel");
});

test("an OBJ without its materials comes, and says what is missing", async () => {
  await drop(join(objFolder(folder), "box.obj"));
  await card().getByText(/the box\.mtl is missing/).waitFor();
  await press("Cancel");
});

test("a lone picture beside an OBJ that names none is its skin texture", async () => {
  const lone = objFolder(folder, {materials: false});
  await drop(join(lone, "box.obj"), join(lone, "pictures", "Skin.PNG"));
  await card().getByText("Its texture is uploaded, too.").waitFor();
  const scene = await uploaded("box");
  assert.match(await linesOf(scene.id), /set_skin_texture/);
  await card().getByText(/Skin\.PNG was dropped with the model/).waitFor();
});

test("a glTF of several files is packed; if some are missing, the card names them", async () => {
  const gltf = gltfFolder(folder);
  await drop(gltf);
  const scene = await uploaded("box");
  assert.equal(scene.model, "glb");
  assert.equal(scene.triangles, 12);
  await drop(join(gltf, "box.gltf"));
  await card().getByText("Files are missing: the box.bin, skin.png.").waitFor();
  await press("Close");
});

test("other axes are another upload into the same scene", async () => {
  await drop(objFolder(folder));
  const first = await uploaded("box");
  await press("Other axes…");
  await card().getByLabel("Up", {exact: true}).selectOption("z");
  await card().getByLabel("Front", {exact: true}).selectOption("-y");
  const second = await uploaded("box");
  assert.equal(second.id, first.id);
  assert.ok(second.revision > first.revision);
});

test("what was groomed before other axes were chosen goes over", async () => {
  await drop(objFolder(folder));
  const {id, revision} = await uploaded("box");
  const combed = await server.post(`/v1/scenes/${id}/commands`, {op: "comb", flood: true, direction: [1, 0, 0]});
  assert.ok(combed.revision > revision);
  await press("Other axes…");
  await press("Upload");
  await card().getByText(/The groom was transferred/).waitFor({timeout: 60000});
  const now = await server.get(`/v1/scenes/${id}`);
  const before = (await server.get("/v1/scenes")).scenes.find(({name}) => name === `box before ${now.revision}`);
  assert.match(await linesOf(before.id), /comb/);
});

test("an upload says how far it is, and cancelled it leaves no scene", async () => {
  const large = join(folder, "large.obj");
  writeFileSync(large, readFileSync(join(objFolder(folder), "box.obj"), "utf8") + "# what takes its time\n".repeat(200000));
  const ids = async () => (await server.get("/v1/scenes")).scenes.map(({id}) => id);
  const before_upload = await ids();
  const line = await studio.context.newCDPSession(studio.page);
  await line.send("Network.emulateNetworkConditions", {offline: false, latency: 0, downloadThroughput: -1, uploadThroughput: 400000});
  await drop(large);
  await press("Upload");
  await card().getByText(/Sending the model: [1-9]\d?%/).waitFor();
  assert.equal((await ids()).length, before_upload.length + 1);
  await press("Cancel");
  await card().getByRole("button", {name: "Upload", exact: true}).waitFor();
  await line.send("Network.emulateNetworkConditions", {offline: false, latency: 0, downloadThroughput: -1, uploadThroughput: -1});
  await line.detach();
  await press("Cancel");
  assert.deepEqual(await ids(), before_upload);
});

test("what is no model is refused in words, and leaves no scene", async () => {
  const broken = join(folder, "broken.ply");
  writeFileSync(broken, "ply\nformat nonsense 1.0\n");
  const scenes = async () => (await server.get("/v1/scenes")).scenes.length;
  const before_drop = await scenes();
  await drop(broken);
  await press("Upload");
  await card().getByRole("alert").waitFor();
  assert.equal(await scenes(), before_drop);
  await press("Close");
  const text = join(folder, "notes.txt");
  writeFileSync(text, "no model");
  await drop(text);
  await card().getByText("There is no model among these files.").waitFor();
  await press("Close");
});

test("a new version of a model keeps the groom, and the scene as it was stays", async () => {
  await drop(join(objFolder(folder, {materials: false}), "box.obj"));
  const first = await uploaded("box");
  await server.post(`/v1/scenes/${first.id}/commands`, {commands: [{op: "length", flood: true, value: 0.11, brush: {strength: 1}}, {op: "set_coat", coat: {wetness: 0.7}}]});
  await studio.page.waitForFunction(() => !document.querySelector('[aria-label="Undo"]').disabled);
  await press("Good");
  await drop(join(objFolder(folder, {materials: false}), "box.obj"));
  await card().getByLabel("A new version of box: keep its groom").check();
  await card().getByText(/KiB/).waitFor();
  const second = await uploaded("box");
  assert.equal(second.id, first.id);
  assert.equal(second.undo_steps, 0);
  await card().getByText("The previous scene, with its steps, is in the list.").waitFor();
  assert.equal(await card().getByText("Other axes…").count(), 0);
  const length = async (id) => (await server.post(`/v1/scenes/${id}/pick`, {nearest: [0.5, 0.5, 1]})).length;
  assert.ok(Math.abs(await length(second.id) - 0.11) < 1e-4, String(await length(second.id)));
  assert.equal((await server.get(`/v1/scenes/${second.id}/settings`)).coats[0].coat.wetness, 0.7);
  const before = (await server.get("/v1/scenes")).scenes.find(({name}) => name === `box before ${second.revision}`);
  assert.equal(before.undo_steps, 1);
});

test("a sample's recipe gives the very steps that the command line gives", async () => {
  await press("Best in show");
  await studio.page.waitForFunction(() => document.querySelector(".scene-name").textContent === "Best in show", null, {timeout: 240000});
  const sample = await server.get(`/v1/scenes/${await openId()}`);
  const other = await server.post("/v1/scenes", {name: "cli", model: {builtin: "creature", triangles: 20000}, fur: {form: "animal", length: 0.03}, ground: true});
  execFileSync(join(bin, "pelage"), ["--server", server.address, "run", "cli", join(recipes, "creature.json")], {stdio: "ignore"});
  assert.equal(await linesOf(sample.id), await linesOf(other.id));
});

test("the groom goes out as a recipe and comes in again", async () => {
  const {id} = await server.creature("groomed");
  await server.post(`/v1/scenes/${id}/commands`, {op: "length", flood: true, value: 0.08, brush: {strength: 1}});
  await server.post(`/v1/scenes/${id}/commands`, {op: "comb", brush: {radius: 0.2}, stroke: {samples: [{position: [0.2, 0.6, -0.2]}, {position: [0.2, 0.62, 0]}]}});
  await server.post(`/v1/scenes/${id}/commands`, {op: "set_coat", coat: {wetness: 0.7}});
  await studio.page.goto(`${server.address}/?scene=${id}`);
  await studio.ready();
  await studio.panel("Files");
  const waiting = studio.page.waitForEvent("download");
  await press("Recipe");
  const path = join(folder, "groom.recipe.json");
  await (await waiting).saveAs(path);
  const lines = (await linesOf(id)).split("\n");
  assert.deepEqual(JSON.parse(readFileSync(path, "utf8")).steps, lines.map((line) => JSON.parse(line)));
  const bare = await server.creature("bare");
  await studio.page.goto(`${server.address}/?scene=${bare.id}`);
  await studio.ready();
  await drop(path);
  await studio.page.getByText(`${lines.length} steps are done.`).waitFor();
  assert.equal((await server.get(`/v1/scenes/${bare.id}`)).fields_hash, (await server.get(`/v1/scenes/${id}`)).fields_hash);
});

test("a recipe with a pick and a loop runs up to the step that breaks its assert", async () => {
  const {id} = await server.post("/v1/scenes", {name: "picked", model: {builtin: "sphere", triangles: 2000}});
  await studio.page.goto(`${server.address}/?scene=${id}`);
  await studio.ready();
  const dab = {op: "length", value: "${value}", brush: {radius: 0.1}, stroke: {samples: [{position: {at: "${top}"}}]}};
  const path = join(folder, "picked.json");
  writeFileSync(path, JSON.stringify({steps: [{pick: {farthest: {direction: [0, 1, 0]}}, as: "top"},
    {for: {value: [0.1, 0.2], least: [1, 1000000]}, steps: [{...dab, assert: {min_vertices: "${least}"}}]}, {op: "lift", flood: true}]}));
  await drop(path);
  await studio.page.getByText("picked.json stopped after 2 of 3 steps.").waitFor({timeout: 60000});
  await studio.page.getByText(/^length touched \d+ vertices/).waitFor();
  assert.equal((await server.get(`/v1/scenes/${id}`)).revision, 2);
});

test("pictures have the size that was asked for; maps and the log come too", async () => {
  const {id} = await server.post("/v1/scenes", {name: "torus", model: {builtin: "torus", triangles: 2000}});
  await studio.page.setViewportSize({width: 1024, height: 400});  // fewer pixels to draw
  await studio.page.goto(`${server.address}/?scene=${id}`);
  await studio.ready();
  await studio.panel("Files");
  const taken = async (button) => {
    const waiting = studio.page.waitForEvent("download", {timeout: 120000});
    await press(button);
    const got = await waiting;
    return {name: got.suggestedFilename(), bytes: readFileSync(await got.path())};
  };
  await studio.seen("rest");
  const seen = await taken("Download PNG");
  const pixels = await studio.page.evaluate(() => { const {width, height} = document.querySelector("canvas.picture[data-front]"); return [width, height]; });
  assert.deepEqual([seen.bytes.readUInt32BE(16), seen.bytes.readUInt32BE(20)], pixels);
  await studio.page.getByLabel("Size", {exact: true}).first().selectOption("2x");
  const picture = await taken("PNG");
  const box = await studio.page.locator(".surface").boundingBox();
  assert.equal(picture.name, "torus.png");
  assert.deepEqual([picture.bytes.readUInt32BE(16), picture.bytes.readUInt32BE(20)], [2 * Math.round(box.width), 2 * Math.round(box.height)]);
  const plain = (await taken("EXR")).bytes;
  assert.equal(plain.readUInt32LE(0), 0x01312f76);
  const channels = (exr) => ["A", "R", "Z", "shadow.Y"].filter((name) => [1, 2].some((type) => exr.includes(`\0${name}\0${String.fromCharCode(type)}\0\0\0`)));
  assert.deepEqual(channels(plain), ["A", "R"]);
  await studio.page.getByText("AOVs in the EXR").click();
  for (const name of ["Depth", "Unshadowed share"]) await studio.page.getByLabel(name, {exact: true}).check();
  assert.deepEqual(channels((await taken("EXR")).bytes), ["A", "R", "Z", "shadow.Y"]);
  await studio.page.getByText("Maps of the groom").click();
  const map = await taken("Map");
  assert.equal(map.name, "torus.length.png");
  assert.equal((await taken("Log (lines)")).name, "torus.jsonl");
});

test("scenes are branched and removed, with a question", async () => {
  await studio.page.getByRole("button", {name: "Branch torus", exact: true}).click();
  await studio.page.waitForFunction(() => document.querySelector(".scene-name").textContent === "torus, branch");
  const branched = await openId();
  await studio.page.getByRole("button", {name: "Remove torus, branch", exact: true}).click();
  await press("Keep");
  assert.ok((await server.get("/v1/scenes")).scenes.some(({id}) => id === branched));
  await studio.page.getByRole("button", {name: "Remove torus, branch", exact: true}).click();
  await studio.page.getByRole("dialog").getByRole("button", {name: "Remove", exact: true}).click();
  await studio.page.waitForFunction((gone) => new URLSearchParams(location.search).get("scene") !== gone, branched);
  assert.ok(!(await server.get("/v1/scenes")).scenes.some(({id}) => id === branched));
});

test("a model that lies on its side is turned with its fur", async () => {
  const {id} = await server.creature("lying");
  const studio = await openStudio({scene: id});
  await studio.ready();
  const height = async () => { const {min, max} = (await server.get(`/v1/scenes/${id}`)).bounds; return max[1] - min[1]; };
  const stood = await height();
  await studio.panel("Files");
  await studio.page.getByText("Turn the model").click();
  await studio.page.getByRole("button", {name: "Roll over"}).click();
  await studio.settled(server, id, 1);
  assert.ok(await height() < 0.8 * stood, `${await height()} high, ${stood} before`);
  await studio.page.waitForFunction(() => window.marks.frame.at(-1)?.revision === 1 && window.marks.proxy.at(-1)?.revision === 1);
  for (let quarter = 0; quarter < 3; ++quarter) {
    await studio.page.getByRole("button", {name: "Roll over"}).click();
    await studio.settled(server, id, 2 + quarter);
  }
  assert.equal(await height(), stood);
  await studio.finish();
});
