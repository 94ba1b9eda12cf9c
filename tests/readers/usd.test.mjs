// TinyUSDZ reads the server's USD files: the numbers of curves and points match the answer, points are in the bounds, and each number is
// the same.
import assert from "node:assert/strict";
import {test} from "node:test";
import {bare, coat, dry_run, exported, scene_of, start, whiskers} from "./support/scenes.mjs";
import {layer_of, numbers_of, scene_of as usd_scene_of} from "./support/tinyusd.mjs";

const thin = {...coat, count: 30};
const thin_coat = {op: "set_coat", coat: thin};
let creature, torus, bald, maned;
start(async () => {
  creature = await scene_of("creature", 300, thin_coat, whiskers);
  torus = await scene_of("torus", 500, thin_coat);
  bald = await scene_of("torus", 500, bare);
  maned = await scene_of("creature", 300, whiskers,
    {op: "set_coats", coats: [{name: "fur", coat: thin}, {name: "the \"mane\"", coat: thin, id: 5, begins: {length: 2}}]});
});

const arrays = ["int[] curveVertexCounts", "point3f[] points", "float[] widths", "float3[] extent", "color3f[] primvars:displayColor",
  "float3[] primvars:groom_color", "int[] primvars:groom_id", "int[] primvars:groom_group_id", "int[] primvars:groom_guide",
  "texCoord2f[] primvars:st", "float2[] primvars:groom_root_uv"];

/** Returns the bounds of all points, extended by half of each point's width. */
function bounds_of(points, widths) {
  const low = [Infinity, Infinity, Infinity], high = [-Infinity, -Infinity, -Infinity];
  points.forEach((position, k) => {
    const half = widths[Math.floor(k / 3)] / 2;
    low[k % 3] = Math.min(low[k % 3], position - half);
    high[k % 3] = Math.max(high[k % 3], position + half);
  });
  return [...low, ...high];
}

const close = (found, expected, what) => {
  assert.equal(found.length, expected.length, what);
  found.forEach((number, k) => assert.ok(Math.abs(number - expected[k]) <= 1e-6, `${what}: ${number}, not ${expected[k]}`));
};

/** Throws unless the reader's counts and bounds of a file agree with the server's description. */
function check({bytes, about}, scene) {
  const {root} = usd_scene_of(bytes);
  const layer = layer_of(bytes);
  const [counts, points, widths, extent] = arrays.slice(0, 4).map((name) => numbers_of(layer, name));
  assert.equal(counts.length, about.strands, "curves");
  assert.equal(counts.reduce((sum, count) => sum + count, 0), about.points, "points of all curves");
  assert.equal(points.length, 3 * about.points, "points");
  assert.equal(widths.length, about.points, "widths");
  close(bounds_of(points, widths), extent, "bounds");
  assert.deepEqual([root.primName, ...root.children.map(({primName}) => primName)], ["groom", "fur"]);
  const {min, max} = scene.bounds;
  close(root.children[0].globalMatrix.slice(12, 15), min.map((low, k) => (low + max[k]) / 2), "centre of the model");
  return layer;
}

/** Throws unless each number that the reader returns is exactly the number in the file. */
function check_numbers(bytes, layer) {
  const text = new TextDecoder().decode(bytes);
  for (const name of arrays) assert.deepEqual(numbers_of(layer, name), numbers_of(text, name), name);
}

const asked = [["all strands", "usda", 0], ["guides", "usda?every=8", 1], ["wider strands", "usda?every=8&widen=true", 0],
  ["no whiskers", "usda?every=8&curves=false", 1]];
for (const [what, query, guide] of asked) {
  test(`${what} of a creature`, async () => {
    const file = await exported(creature, query);
    assert.deepEqual(await dry_run(creature, query), file.about);
    assert.equal(file.bytes.length, file.about.bytes);
    const layer = check(file, creature);
    check_numbers(file.bytes, layer);
    assert.deepEqual([...numbers_of(layer, "int[] primvars:groom_guide")], [guide]);
  });
}

test("strands of two coats are groups with their numbers", async () => {
  const file = await exported(maned, "usda");
  const layer = check(file, maned);
  check_numbers(file.bytes, layer);
  const groups = numbers_of(layer, "int[] primvars:groom_group_id");
  assert.deepEqual([...new Set(groups)], [0, 5, 8]);
  const {about} = await exported(maned, "usda?coat=fur&curves=false");
  assert.equal([...groups].filter((group) => group === 0).length, about.strands);
});

test("guides are about one strand of eight", async () => {
  const many = await scene_of("torus", 500);
  const [all, guides] = [await dry_run(many, "usda"), await dry_run(many, "usda?every=8")];
  assert.ok(Math.abs(guides.strands / all.strands - 1 / 8) < 0.02);
});

test("texture coordinates of the roots", async () => {
  const file = await exported(torus, "usda");
  const layer = check(file, torus);
  check_numbers(file.bytes, layer);
  assert.equal(numbers_of(layer, "texCoord2f[] primvars:st").length, 2 * file.about.strands);
});

test("no strands at all", async () => {
  const {bytes, about} = await exported(bald, "usda");
  assert.equal(about.strands, 0);
  assert.equal(numbers_of(layer_of(bytes), "int[] curveVertexCounts").length, 0);
});

const damages = [
  ["a curve too few", /curveVertexCounts = \[\d+, /, "curveVertexCounts = [", /curves/],
  ["a point too few", /points = \[\([^)]*\), /, "points = [", /points/],
  ["bounds that are too small", /extent = \[\([^,]*/, "extent = [(0", /bounds/],
  ["another centre", /translate = \([^,]*/, "translate = (9", /centre/],
  ["counts that are no integers", "int[] curveVertexCounts", "float[] curveVertexCounts", /TinyUSDZ.*BasisCurves/s],
  ["points of two coordinates", /points = \[\([^,]*, /, "points = [(", /TinyUSDZ/],
  ["half a file", /[^]{2000}$/, "", /TinyUSDZ/],
];

test("the reader finds what is damaged", async () => {
  const {bytes, about} = await exported(torus, "usda?every=32");
  const text = new TextDecoder().decode(bytes);
  for (const [what, pattern, instead, message] of damages) {
    const damaged = text.replace(pattern, instead);
    assert.notEqual(damaged, text, what);
    assert.throws(() => check({bytes: new TextEncoder().encode(damaged), about}, torus), message, what);
  }
});

// Checks what the page on export says about programs that build on this reader.
test("the reader's scenes have no data of curves", async () => {
  const {root, meshes} = usd_scene_of((await exported(torus, "usda?every=8")).bytes);
  assert.equal(meshes, 0);
  assert.deepEqual([root.children[0].nodeType, root.children[0].contentId], ["xform", -1]);
});
