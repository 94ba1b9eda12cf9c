// Several numbered views in one picture.
import assert from "node:assert/strict";
import {test} from "node:test";
import {setTimeout as sleep} from "node:timers/promises";
import {agent, pixelsOf, server, start, thinScene} from "./support/agent.mjs";

const scene = "fox";
const side = 96;
start(() => thinScene(scene, "torus", 500));

const pixel = ({data, width, channels}, x, y) => [...data.slice((y * width + x) * channels, (y * width + x) * channels + 3)];

/** The box with the number at a view's corner, as rows of light and dark; undefined where there is none. */
function numberAt(picture, {left, top}) {
  const rows = Array.from({length: 7}, (_, y) => Array.from({length: 5}, (_, x) => pixel(picture, left + x, top + y)));
  const all = rows.flat();
  return all.every((colour) => colour.every((value) => value === 0) || colour.every((value) => value === 255))
    ? rows.map((row) => row.map(([red]) => red ? "#" : ".").join("")).join("\n") : undefined;
}

test("all sides, each with another number and the picture that look draws", async () => {
  const {image, text, data: {views}} = await agent.call("views", {scene, width: side, height: side});
  const picture = pixelsOf(image);
  assert.deepEqual([picture.width, picture.height], [3 * side + 8, 2 * side + 4]);
  assert.deepEqual(views.map(({number}) => number), [1, 2, 3, 4, 5, 6]);
  const numbers = views.map((view) => numberAt(picture, view));
  assert.ok(numbers.every((number) => number !== undefined), "a view without a number");
  assert.equal(new Set(numbers).size, 6, "two views have one number");
  assert.equal(numbers[0], [".....", "..#..", ".##..", "..#..", "..#..", ".###.", "....."].join("\n"));
  for (const {camera, number, left, top} of views) {
    assert.ok(text.includes(`${number}: ${camera.auto}`));
    const alone = pixelsOf((await agent.call("look", {scene, camera, width: side, height: side})).image);
    for (const [x, y] of [[side / 2, side / 2], [side / 3, side / 2], [side - 1, side - 1]].map((at) => at.map(Math.floor))) {
      assert.deepEqual(pixel(picture, left + x, top + y), pixel(alone, x, y), `view ${number} at ${x}, ${y}`);
    }
  }
});

test("views of one's own: a camera, an overlay, before and after; as many as asked for", async () => {
  await agent.call("length", {scene, flood: true, value: 0.06, brush: {strength: 1}});
  const camera = {position: [0, 0, 4], target: [0, 0, 0]};
  const wanted = [{camera, revision: 1}, {camera}, {camera, overlay: "difference", overlay_from: 1}, {camera: {auto: "top"}}];
  const {image, data: {views}} = await agent.call("views", {scene, width: side, height: side, quality: "draft", views: wanted});
  assert.deepEqual(views.map(({revision}) => revision), [1, 2, 2, 2]);
  const picture = pixelsOf(image);
  assert.deepEqual([picture.width, picture.height], [2 * side + 4, 2 * side + 4]);
  const inside = views.map(({left, top}) => Array.from({length: 40}, (_, k) => pixel(picture, left + 28 + k, top + 48)).join());
  assert.equal(new Set(inside).size, 4, "two views show the same");
  const ten = await agent.call("views", {scene, width: 32, height: 32, quality: "draft", views: Array(10).fill({camera})});
  assert.equal(ten.data.views.length, 10);
  assert.deepEqual([pixelsOf(ten.image).width, pixelsOf(ten.image).height], [4 * 32 + 12, 3 * 32 + 8]);
});

test("a client that listens hears how many views are done", async () => {
  // Read from the transport: the SDK's onprogress drops a notification that arrives together with the result.
  const heard = [];
  const {transport} = agent.client;
  const {onmessage} = transport;
  transport.onmessage = (message, ...rest) => {
    if (message.method === "notifications/progress") heard.push([message.params.progress, message.params.total]);
    onmessage(message, ...rest);
  };
  const views = Array(3).fill({camera: {auto: "back"}});
  await agent.client.callTool({name: "views", arguments: {scene, width: 32, height: 32, views}}, undefined, {onprogress: () => {}});
  transport.onmessage = onmessage;
  assert.deepEqual(heard, [[1, 3], [2, 3], [3, 3]]);
});

test("a call that is given up ends on the server too", async () => {
  const {data: {id}} = await agent.call("describe_scene", {scene});
  const drawn = async () => (await server.get(`/v1/scenes/${id}/frames`)).frames.length;
  const until = async (count) => {
    for (let tries = 0; tries < 1200 && await drawn() !== count; ++tries) await sleep(50);
    assert.equal(await drawn(), count);
  };
  const leave = new AbortController();
  const call = agent.client.callTool({name: "look", arguments: {scene, quality: {raster: {strands: 1000, light_of: 1}}, width: 8192, height: 8192, max_seconds: 86400}}, undefined, {signal: leave.signal});
  const given_up = assert.rejects(call);
  await until(1);
  leave.abort();
  await given_up;
  await until(0);  // long before it would be drawn
});

test("a picture as JPEG", async () => {
  const {image} = await agent.call("look", {scene, width: side, height: side, format: "jpeg"});
  assert.equal(image.mimeType, "image/jpeg");
  assert.deepEqual([...Buffer.from(image.data, "base64").subarray(0, 2)], [0xff, 0xd8]);
});
