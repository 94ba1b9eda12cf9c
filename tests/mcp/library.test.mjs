// Looks and recipes: read as resources, run by their names.
import assert from "node:assert/strict";
import {readFileSync, readdirSync} from "node:fs";
import {test} from "node:test";
import {agent, start} from "./support/agent.mjs";

start();

const kinds = ["looks", "recipes"];
const folder = (kind) => new URL(`../../clients/${kind}/`, import.meta.url);
const files = (kind) => readdirSync(folder(kind)).filter((file) => file.endsWith(".json")).map((file) => file.replace(/\.json$/, "")).sort();

test("every look and recipe is a resource with what its file has", async () => {
  const {resources} = await agent.client.listResources();
  assert.deepEqual(resources.map(({uri}) => uri), kinds.flatMap((kind) => files(kind).map((name) => `pelage://${kind}/${name}`)));
  for (const {uri} of resources) {
    const [, , kind, name] = uri.split("/");
    const {contents: [{text, mimeType}]} = await agent.client.readResource({uri});
    assert.equal(mimeType, "application/json");
    assert.equal(text, readFileSync(new URL(`${name}.json`, folder(kind)), "utf8"));
  }
});

test("every look is put on, as one step", async () => {
  await agent.call("create_scene", {name: "a", model: {builtin: "sphere", triangles: 500}});
  const names = agent.tools.get("apply_look").inputSchema.properties.name.enum;
  assert.deepEqual(names, files("looks"));
  for (const name of names) await agent.call("apply_look", {scene: "a", name});
  assert.equal((await agent.call("describe_scene", {scene: "a"})).data.undo_steps, names.length);
});

test("a recipe is run with a variable of its own, and undone", async () => {
  const {data: {fields_hash: bare}} = await agent.call("create_scene", {name: "b", model: {triangles: 1000}});
  const recipe = {scene: "b", name: "creature", variables: {fur: 0.02}};
  const dry = await agent.call("run_recipe", {...recipe, dry_run: true});
  assert.ok(dry.data.results.some(({touched}) => touched > 500));
  assert.equal((await agent.call("describe_scene", {scene: "b"})).data.revision, 0);
  await agent.call("run_recipe", recipe);
  const {undo_steps, fields_hash} = (await agent.call("describe_scene", {scene: "b"})).data;
  assert.ok(undo_steps > 10 && fields_hash !== bare);
  await agent.call("undo", {scene: "b", steps: undo_steps});
  assert.equal((await agent.call("describe_scene", {scene: "b"})).data.fields_hash, bare);
  const {data: changed} = await agent.call("run_recipe", {scene: "b", name: "creature"});
  assert.notEqual(changed.fields_hash, fields_hash, "the variable does nothing");
});
