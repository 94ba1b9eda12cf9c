// Khronos' glTF validator finds no problem in the server's GLBs, and finds the problems of damaged ones.
import assert from "node:assert/strict";
import {test} from "node:test";
import {glb_of, numbers_of, parts_of, validated} from "./support/glb.mjs";
import {bare, exported, eyes, light_mesh, nose, scene_of, start, whiskers} from "./support/scenes.mjs";

const models = {
  "creature with eyes, whiskers and a nose": ["creature", 1500, eyes, whiskers, nose],
  "torus with texture coordinates": ["torus", 500, {op: "paint", flood: true, field: "density", value: 0.5, brush: {strength: 1}}],
  "sphere without texture coordinates": ["sphere", 500],
  "plane with long fur": ["plane", 200, {op: "length", flood: true, value: 0.1}],
};
const files = ["fields", "shells", "cards?cards=1000"];
const scenes = {};
let bald, maned;
start(async () => {
  for (const [name, model] of Object.entries(models)) scenes[name] = await scene_of(...model);
  bald = await scene_of("torus", 500, bare);
  maned = await scene_of("creature", 1500, {op: "set_coats", coats: [{name: "fur"}, {name: "mane", begins: {length: 2}}]});
});

for (const name of Object.keys(models)) {
  for (const query of files) {
    test(`${query} of a ${name}: no error, warning, info or hint`, async () => {
      const report = await validated((await exported(scenes[name], query)).bytes);
      assert.deepEqual(report.found, []);
      assert.ok(report.info.hasDefaultScene);
    });
  }
  test(`the light mesh of a ${name}: nothing`, async () => {
    assert.deepEqual((await validated(await light_mesh(scenes[name]))).found, []);
  });
}

test("a coat of two has files of its own", async () => {
  for (const coat of ["fur", "mane"]) {
    for (const query of ["fields?", "shells?", "cards?cards=1000&"])
      assert.deepEqual((await validated((await exported(maned, `${query}coat=${coat}`)).bytes)).found, [], query);
  }
});

test("triangles are as many as the server says", async () => {
  for (const query of ["fields", "shells", "shells?shells=3"]) {
    const {bytes, about} = await exported(scenes["sphere without texture coordinates"], query);
    assert.equal((await validated(bytes)).info.totalTriangleCount, about.triangles, query);
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
  const {bytes, about} = await exported(scenes["sphere without texture coordinates"], "cards?cards=2000");
  const body = scenes["sphere without texture coordinates"].triangles;
  const levels = triangles_of_levels(parts_of(bytes));
  assert.equal(levels.length, 3);
  assert.equal(levels[0] + body, about.triangles);
  assert.ok(levels[1] < 0.6 * levels[0] && levels[2] < 0.6 * levels[1] && levels[2] > 0, levels.join());
  const {info} = await validated(bytes);  // counts the body only once
  assert.equal(info.totalTriangleCount, levels[0] + levels[1] + levels[2] + body);
});

test("bare skin has files too", async () => {
  for (const query of ["fields", "shells", "cards?cards=300"]) {
    assert.deepEqual((await validated((await exported(bald, query)).bytes)).found, [], query);
  }
});

/** The first primitive of the skin, which names its positions, normals and triangles. */
const skin = ({json}) => json.meshes[0].primitives[0];
const damages = [
  ["an accessor that counts too much", "ACCESSOR_TOO_LONG", (file) => { file.json.accessors[skin(file).attributes.POSITION].count *= 9; }],
  ["triangles that do not come out even", "MESH_PRIMITIVE_INCOMPATIBLE_MODE", (file) => { file.json.accessors[skin(file).indices].count -= 1; }],
  ["a vertex that there is not", "ACCESSOR_INDEX_OOB", (file) => { numbers_of(file, skin(file).indices)[7] = 60000; }],
  ["a place that is no number", "ACCESSOR_INVALID_FLOAT", (file) => { numbers_of(file, skin(file).attributes.POSITION)[4] = NaN; }],
  ["a place out of its bounds", "ACCESSOR_ELEMENT_OUT_OF_MAX_BOUND", (file) => { numbers_of(file, skin(file).attributes.POSITION)[4] = 99; }],
  ["a long normal", "ACCESSOR_VECTOR3_NON_UNIT", (file) => { numbers_of(file, skin(file).attributes.NORMAL)[0] += 1; }],
  ["a texture that there is not", "UNRESOLVED_REFERENCE", (file) => { file.json.materials.at(-1).pbrMetallicRoughness.baseColorTexture = {index: 99}; }],
  ["a mesh that nothing shows", "UNUSED_OBJECT", (file) => { file.json.meshes.push(file.json.meshes[0]); }],
  ["a torn picture", "IMAGE_UNRECOGNIZED_FORMAT", (file) => { file.binary[file.json.bufferViews[file.json.images[0].bufferView].byteOffset] ^= 255; }],
];

test("the validator finds what is damaged", async () => {
  const {bytes} = await exported(scenes["sphere without texture coordinates"], "shells?shells=3");
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
