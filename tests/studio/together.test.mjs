// Two people on one scene, and a server that dies under the hand: no stroke is lost, none is done twice.
import assert from "node:assert/strict";
import {test} from "node:test";
import {openStudio, server, start} from "./support/own.mjs";

start();

const strokesOf = (entries) => entries.flatMap(({commands}) => (commands === undefined ? [] : [commands].flat())).flatMap(({stroke}) => stroke ?? []);

test("both see what the other does, and nothing is lost", async () => {
  const {id} = await server.creature("shared");
  const studios = await Promise.all([0, 1].map(() => openStudio({scene: id})));
  for (const studio of studios) {
    studio.expected.push(/status of 422/);  // an edit of the other one ends a stroke, which goes on as a new one
    await studio.ready();
  }
  await Promise.all([
    studios[0].drag([[0.42, 0.48], [0.5, 0.46], [0.58, 0.5]], {steps: 25}),
    studios[1].drag([[0.46, 0.58], [0.54, 0.56], [0.6, 0.6]], {steps: 25}),
  ]);
  for (const studio of studios) await studio.page.waitForFunction(() => Object.keys(localStorage).every((name) => !name.startsWith("pelage.outbox")));
  const {entries} = await server.get(`/v1/scenes/${id}/log`);
  const authors = new Set(entries.map(({author}) => author));
  assert.equal(authors.size, 2, [...authors].join());
  const {revision} = await server.get(`/v1/scenes/${id}`);
  for (const studio of studios) {
    await studio.page.waitForFunction((wanted) => window.marks.frame.some((frame) => frame.revision >= wanted), revision, {timeout: 60000});
    await studio.finish();
  }
});

test("the server is killed in the middle of a stroke and comes back", async () => {
  const {id} = await server.creature("killed");
  const studio = await openStudio({scene: id});
  studio.expected.push(/Failed to load resource/, /ERR_CONNECTION_REFUSED|ERR_EMPTY_RESPONSE|ERR_CONNECTION_RESET|ERR_INCOMPLETE_CHUNKED_ENCODING/);
  await studio.ready();
  const path = Array.from({length: 40}, (_, k) => [0.42 + 0.004 * k, 0.5 - 0.001 * k]);
  const points = [];
  for (const position of path) points.push(await studio.at(...position));
  await studio.page.mouse.move(...points[0]);
  await studio.page.mouse.down();
  for (const point of points.slice(1, 15)) await studio.page.mouse.move(...point);
  await studio.settled(server, id, 1);
  await server.kill();
  for (const point of points.slice(15)) await studio.page.mouse.move(...point);
  await studio.page.mouse.up();
  await studio.page.getByText(/no connection|connection/i).first().waitFor();
  await server.run();
  await studio.page.waitForFunction(() => Object.keys(localStorage).every((name) => !name.startsWith("pelage.outbox")), null, {timeout: 60000});
  const {entries} = await server.get(`/v1/scenes/${id}/log`);
  const strokes = strokesOf(entries);
  const times = strokes.flatMap(({samples}) => samples.map(({time = 0}) => time));
  const parts = new Set(strokes.map(({id: stroke}) => stroke)).size;
  assert.ok(times.length >= 30, `${times.length} samples of 40 came`);
  assert.equal(new Set(times).size, times.length - (parts - 1), "no part is done twice");  // what goes on begins with the sample before it
  await studio.finish();
});

test("what a page could not send before it was closed is sent by the next one", async () => {
  const {id} = await server.creature("closed");
  const studio = await openStudio({scene: id, alone: true});
  studio.expected.push(/Failed to load resource/, /ERR_/);
  await studio.ready();
  await server.kill();
  await studio.drag([[0.45, 0.5], [0.55, 0.5]]);
  await studio.page.waitForFunction(() => Object.keys(localStorage).some((name) => name.startsWith("pelage.outbox")));
  const next = await studio.context.newPage();
  await studio.page.close();
  await server.run();
  await next.goto(`${server.address}/?scene=${id}`);
  await next.waitForFunction(() => Object.keys(localStorage).every((name) => !name.startsWith("pelage.outbox")), null, {timeout: 60000});
  assert.equal((await server.get(`/v1/scenes/${id}`)).undo_steps, 1);
  await studio.close();
});
