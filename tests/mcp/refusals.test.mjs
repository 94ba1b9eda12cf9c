// Refusals name the field, the limit and the nearest name, and change nothing.
import assert from "node:assert/strict";
import {spawnSync} from "node:child_process";
import {test} from "node:test";
import {Server} from "../studio/support/server.mjs";
import {Agent, agent, program, server, start, thinScene} from "./support/agent.mjs";

const scene = "fox";
const samples = [{position: [0, 1, 0]}, {position: [0, 1, 0.1]}];
start(() => thinScene(scene, "sphere", 300));

const cases = [
  ["a number out of range", "comb", {scene, brush: {radius: -1}, stroke: {samples}}, {pointer: "/brush/radius", limit: "[0, 1e+27]"}],
  ["a name of the contract", "comb", {scene, brush: {radus: 1}, stroke: {samples}}, {pointer: "/brush/radus", nearest: "radius"}],
  ["a name of the tool", "comb", {scene, brsh: {}, stroke: {samples}}, {pointer: "/brsh", nearest: "brush", limit: /brush \|/}],
  ["a rule between members", "comb", {scene, flood: true}, {pointer: /direction/}],
  ["dry_run as text", "comb", {scene, stroke: {samples}, dry_run: "yes"}, {pointer: "/dry_run", limit: "true | false"}],
  ["no scene", "undo", {}, {pointer: "/scene"}],
  ["an unknown scene", "undo", {scene: "fxo"}, {pointer: "/scene", nearest: "fox", limit: /fox \(/}],
  ["an unknown source of fields", "retarget", {scene, source_scene: "fix"}, {pointer: "/source_scene", nearest: "fox"}],
  ["more undo than there is", "undo", {scene, steps: 7}, {pointer: "/steps", limit: "at most 1"}],
  ["a picture too large", "look", {scene, width: 9000}, {pointer: "/width", limit: /8192/}],
  ["a picture nobody can see", "look", {scene, format: "exr"}, {pointer: "/format", limit: "png | jpeg"}],
  ["a camera of a view", "views", {scene, views: [{}, {camera: {auto: "frnt"}}]}, {pointer: "/views/1/camera/auto", nearest: "front"}],
  ["a view that is none", "views", {scene, views: [7]}, {pointer: "/views/0"}],
  ["too many views", "views", {scene, views: Array(17).fill({})}, {pointer: "/views", limit: "1 to 16"}],
  ["views too large", "views", {scene, width: 2000}, {pointer: "/width", limit: /1024/}],
  ["a pixel off the view", "pick", {scene, pixel: [600, 5]}, {pointer: /pixel/}],
  ["an unknown command", "preview_change", {scene, commands: [{op: "cmb"}]}, {pointer: "/commands/0/op", nearest: "comb"}],
  ["commands that are no list", "run_commands", {scene, commands: "comb"}, {pointer: "/commands"}],
  ["an unknown look", "apply_look", {scene, name: "fx"}, {pointer: "/name", nearest: "fox"}],
  ["a path out of the looks", "apply_look", {scene, name: "../recipes/dot"}, {pointer: "/name"}],
  ["an unknown variable", "run_recipe", {scene, name: "creature", variables: {furr: 1}}, {pointer: "/variables/furr", nearest: "fur"}],
  ["a setting", "read_settings", {scene, only: ["coat"]}, {pointer: "/only/0", nearest: "coats"}],
  ["a file that is not there", "load_model", {scene, path: "/nowhere/a.obj"}, {pointer: "/path"}],
  ["a file that is no model", "load_model", {scene, path: program, format: "obj"}, {detail: /./}],
  ["a model of no known format", "load_model", {scene, path: program}, {pointer: /format/}],
];

for (const [what, tool, input, wanted] of cases) {
  test(`refused: ${what}`, async () => {
    const refusal = await agent.refused(tool, input);
    for (const [name, value] of Object.entries(wanted)) {
      if (value instanceof RegExp) assert.match(refusal[name], value);
      else assert.equal(refusal[name], value);
      assert.ok(refusal.text.includes(refusal[name]), `the text does not say the ${name}`);
    }
    assert.match(refusal.text, /^Next: ./m);
    assert.doesNotMatch(refusal.text, /pelage-mcp failed/);
    assert.equal((await agent.call("describe_scene", {scene})).data.undo_steps, 1);
  });
}

test("a tool that there is not, a resource that there is not", async () => {
  await assert.rejects(agent.client.callTool({name: "cmb", arguments: {}}), /no tool "cmb"/);
  await assert.rejects(agent.client.readResource({uri: "pelage://looks/fx"}), /no "fx" among the looks/);
  await assert.rejects(agent.client.readResource({uri: "file:///etc/passwd"}), /no resource/);
});

test("a server that is gone, a wrong token, a wrong address", async () => {
  const own = await Server.start(["--gl", "none", "--token", "right"]);
  const inside = await Agent.start("--server", own.address, "--token", "right");
  try {
    assert.deepEqual((await inside.call("list_scenes")).data.scenes, []);
    const wrong = spawnSync(process.execPath, [program, "--server", own.address, "--token", "wrong"], {input: "", encoding: "utf8"});
    assert.equal(wrong.status, 1);
    assert.match(wrong.stderr, /--token/);
    await own.stop();
    const gone = await inside.refused("list_scenes", {});
    assert.match(gone.text, /No Pelage server answers at .*Next: Start it/s);
    const nobody = spawnSync(process.execPath, [program, "--server", own.address], {input: "", encoding: "utf8"});
    assert.equal(nobody.status, 1);
    assert.match(nobody.stderr, /No Pelage server answers/);
  } finally {
    await inside.stop();
  }
});

test("options: only some tools, and names that there are not", async () => {
  const few = await Agent.start("--server", `${server.address}/`, "--tools", "look,comb");
  assert.deepEqual([...few.tools.keys()], ["look", "comb"]);
  await few.stop();
  const two = await Agent.start("--server", server.address, "--toolsets", "history, scenes");
  assert.ok(two.tools.has("undo") && two.tools.has("export_scene") && !two.tools.has("look") && !two.tools.has("comb"));
  await two.stop();
  const of_server = ["--server", server.address];
  for (const [words, said] of [[["--server", "nowhere"], /no address/], [[...of_server, "--toolsets", "histry"], /There are .*history/], [[...of_server, "--tools", "cmb"], /There are .*comb/], [["--serve", "x"], /--serve/]]) {
    const {status, stderr} = spawnSync(process.execPath, [program, ...words], {input: "", encoding: "utf8"});
    assert.equal(status, 1);
    assert.match(stderr, said);
  }
});
