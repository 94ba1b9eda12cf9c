// Khronos' glTF validator finds no problem in the server's GLBs, and finds the problems of damaged ones.
import assert from "node:assert/strict";
import {test} from "node:test";
import {glb_of, numbers_of, parts_of, validated} from "./support/glb.mjs";
import {bare, coat, exported, eyes, light_mesh, nose, scene_of, start, whiskers} from "./support/scenes.mjs";

const files = ["fields", "shells", "cards?cards=1000"];
const models = {
  "creature with eyes, whiskers, a nose and two coats": [["fields?coat=mane", "shells?coat=mane", "cards?cards=1000&coat=mane"], "creature", 300,
    eyes, whiskers, nose, {op: "set_coats", coats: [{name: "fur", coat}, {name: "mane", coat, begins: {length: 2}}]}],
  "sphere without texture coordinates": [["fields", "shells?shells=3", "cards?cards=1000"], "sphere", 500],
  "plane with texture coordinates and long thin fur": [files, "plane", 200, {op: "length", flood: true, value: 0.1},
    {op: "paint", flood: true, field: "density", value: 0.5, brush: {strength: 1}}],
  "bare torus": [files, "torus", 200, bare],
};
const scenes = {};
start(async () => {
  for (const [name, [, ...model]] of Object.entries(models)) scenes[name] = await scene_of(...model);
});

/** The server's exports of scenes, with the validator's reports. */
const reports = new Map();
async function report(name, query) {
  const key = `${name} ${query}`;
  if (!reports.has(key)) {
    const file = await exported(scenes[name], query);
    reports.set(key, {...file, ...await validated(file.bytes)});
  }
  return reports.get(key);
}

for (const [name, [queries]] of Object.entries(models)) {
  for (const query of queries) {
    test(`${query} of a ${name}: no error, warning, info or hint`, async () => {
      const {found, info} = await report(name, query);
      assert.deepEqual(found, []);
      assert.ok(info.hasDefaultScene);
    });
  }
  test(`the light mesh of a ${name}: nothing`, async () => {
    assert.deepEqual((await validated(await light_mesh(scenes[name]))).found, []);
  });
}

const sphere = "sphere without texture coordinates";

test("triangles are as many as the server says", async () => {
  for (const [name, query] of [[sphere, "fields"], [sphere, "shells?shells=3"], ["bare torus", "shells"]]) {
    const {about, info} = await report(name, query);
    assert.equal(info.totalTriangleCount, about.triangles, `${name}, ${query}`);
  }
});

/** Number of the fur's triangles in each scene of a file of cards. */
function triangles_of_levels({json}) {
  return json.scenes.map(({name, nodes}, level) => {
    assert.equal(name, `LOD${level}`);
    const fur = json.nodes[nodes.find((node) => json.nodes[node].name === `fur_LOD${level}`)];
    return json.meshes[fur.mesh].primitives.reduce((sum, {indices}) => sum + json.accessors[indices].count / 3, 0);
  });
}

test("cards have three levels of detail, each with its share of the triangles", async () => {
  const {bytes, about, info} = await report(sphere, "cards?cards=1000");
  const body = scenes[sphere].triangles;
  const levels = triangles_of_levels(parts_of(bytes));
  assert.equal(levels.length, 3);
  assert.equal(levels[0] + body, about.triangles);
  assert.ok(levels[1] < 0.6 * levels[0] && levels[2] < 0.6 * levels[1] && levels[2] > 0, levels.join());
  assert.equal(info.totalTriangleCount, levels[0] + levels[1] + levels[2] + body);  // counts the body only once
});

/** The first primitive of the skin, which names its positions, normals and triangles. */
const skin = ({json}) => json.meshes[0].primitives[0];
const damages = [
  ["an accessor that counts too much", "ACCESSOR_TOO_LONG", (file) => { file.json.accessors[skin(file).attributes.POSITION].count *= 9; }],
  ["triangles that do not come out even", "MESH_PRIMITIVE_INCOMPATIBLE_MODE", (file) => { file.json.accessors[skin(file).indices].count -= 1; }],
  ["a vertex that there is not", "ACCESSOR_INDEX_OOB", (file) => { numbers_of(file, skin(file).indices)[7] = 60000; }],
  ["a position that is no number", "ACCESSOR_INVALID_FLOAT", (file) => { numbers_of(file, skin(file).attributes.POSITION)[4] = NaN; }],
  ["a position out of its bounds", "ACCESSOR_ELEMENT_OUT_OF_MAX_BOUND", (file) => { numbers_of(file, skin(file).attributes.POSITION)[4] = 99; }],
  ["a long normal", "ACCESSOR_VECTOR3_NON_UNIT", (file) => { numbers_of(file, skin(file).attributes.NORMAL)[0] += 1; }],
  ["a texture that there is not", "UNRESOLVED_REFERENCE", (file) => { file.json.materials.at(-1).pbrMetallicRoughness.baseColorTexture = {index: 99}; }],
  ["a mesh that nothing shows", "UNUSED_OBJECT", (file) => { file.json.meshes.push(file.json.meshes[0]); }],
  ["a torn picture", "IMAGE_UNRECOGNIZED_FORMAT", (file) => { file.binary[file.json.bufferViews[file.json.images[0].bufferView].byteOffset] ^= 255; }],
];

test("the validator finds what is damaged", async () => {
  const {bytes} = await report(sphere, "shells?shells=3");
  assert.deepEqual((await validated(glb_of(parts_of(bytes)))).found, []);  // taken apart and put together again it is valid
  for (const [what, code, damage] of damages) {
    const file = parts_of(bytes);
    damage(file);
    const {found} = await validated(glb_of(file));
    assert.ok(found.some((issue) => issue.split(" ")[1] === code), `${what}: ${code}, not ${found.slice(0, 3)}`);
  }
  const {found} = await validated(bytes.subarray(0, bytes.length / 2));
  assert.ok(found.some((issue) => issue.startsWith("error GLB_")), `half a file: ${found}`);
});
