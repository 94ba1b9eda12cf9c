// The contract that the build generates has no problems, and the linter finds problems that are put into it.
import assert from "node:assert/strict";
import {mkdtempSync, readFileSync, rmSync, writeFileSync} from "node:fs";
import {tmpdir} from "node:os";
import {join} from "node:path";
import {after, test} from "node:test";
import {problems_of} from "./lint.mjs";
import {fault} from "./rules.mjs";

const contract = join(process.env.PELAGE_BIN, "openapi.json");
const folder = mkdtempSync(join(tmpdir(), "pelage-openapi-"));
after(() => rmSync(folder, {recursive: true}));

/** Returns the problems of the contract after these changes, each as "rule pointer". */
async function broken_by(changes) {
  const document = JSON.parse(readFileSync(contract, "utf8"));
  for (const change of changes) change(document);
  const file = join(folder, "openapi.json");
  writeFileSync(file, JSON.stringify(document));
  return (await problems_of(file)).map(({rule, at}) => `${rule} ${at}`);
}
const run = (document) => document.paths["/v1/scenes/{id}/commands"].post;
const body = (document) => run(document).requestBody.content["application/json"];

test("the contract has no problem", async () => {
  const problems = await problems_of(contract);
  assert.deepEqual(problems, [], problems.map(({rule, message, at}) => `${rule} ${at}: ${message}`).join("\n"));
});

const breaks = [
  ["an operation without a description", "pelage/described #/paths/~1v1~1scenes~1{id}~1commands/post", (document) => delete run(document).description],
  ["a parameter without one", "pelage/described #/components/parameters/Wait", (document) => delete document.components.parameters.Wait.description],
  ["a member without one", "pelage/described #/components/schemas/Comb/properties/keep_inclination", ({components}) => delete components.schemas.Comb.properties.keep_inclination.description],
  ["a member of one of two forms without one", "pelage/described #/components/schemas/Camera/oneOf/1/properties/fov_degrees", ({components}) => delete components.schemas.Camera.oneOf[1].properties.fov_degrees.description],
  ["a type without one", "pelage/described #/components/schemas/Stroke", ({components}) => delete components.schemas.Stroke.description],
  ["a torn description", "pelage/whole-sentences #/components/schemas/Trim/description", ({components}) => { components.schemas.Trim.description = "Of the fur."; }],
  ["a request without an example", "pelage/exampled #/paths/~1v1~1scenes~1{id}~1undo/post/requestBody", (document) => delete document.paths["/v1/scenes/{id}/undo"].post.requestBody.content["application/json"].example],
  ["a required parameter without one", "pelage/exampled #/components/parameters/SceneId", ({components}) => delete components.parameters.SceneId.example],
  ["a number without a unit", "pelage/measured #/components/schemas/Blow/properties/fall", ({components}) => delete components.schemas.Blow.properties.fall["x-unit"]],
  ["a command that breaks its schema", "no-invalid-media-type-examples #/paths/~1v1~1scenes~1{id}~1commands/post", (document) => { body(document).examples.comb.value.lean = 2; }],
  ["a parameter that breaks its schema", "no-invalid-parameter-examples #/paths/~1v1~1scenes~1{id}~1compare/get", (document) => { document.paths["/v1/scenes/{id}/compare"].get.parameters[0].example = -1; }],
  ["a type's example that breaks it", "no-invalid-schema-examples #/components/schemas/Brush", ({components}) => { components.schemas.Brush.examples[0].radius = -1; }],
  ["a word that OpenAPI does not have", "struct #/paths/~1v1~1scenes~1{id}~1redo/post/responses/default", (document) => { document.paths["/v1/scenes/{id}/redo"].post.responses.default = {descripton: "A refusal."}; }],
];

test("the linter finds each fault and its position", async () => {
  const problems = await broken_by(breaks.map(([, , change]) => change));
  for (const [what, where] of breaks) assert.ok(problems.some((problem) => problem.startsWith(where)), `${what}: ${where}`);
});

test("what a whole description is", () => {
  for (const words of ["A radius.", "`radius` counts.", "2 or more.", "png and png16: sRGB. exr: linear.", "sRGB, linear: as light."]) assert.equal(fault(words), undefined, words);
  for (const words of ["", "a radius.", "A radius", "Of the brush.", "Radius.", "A `radius.", "A radius (in sizes.", "That made it."]) assert.ok(fault(words), words);
});
