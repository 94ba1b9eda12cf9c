// The wind: a breeze is one step, playing asks for later and later moments, and leaves the scene alone.
import assert from "node:assert/strict";
import {test} from "node:test";
import {openStudio, server, start} from "./support/own.mjs";

start();

const timeOf = (request) => JSON.parse(request.postData() ?? "{}").time;

test("a breeze is started, played, paused and stored", async () => {
  const id = (await server.creature("wind")).id;
  const studio = await openStudio({scene: id, kept: {panel: "wind"}}), {page} = studio;
  await studio.ready();
  const scene = () => server.get(`/v1/scenes/${id}`), settings = () => server.get(`/v1/scenes/${id}/settings`);
  const stepsAre = async (count) => {
    for (let tries = 0; tries < 400 && (await scene()).undo_steps < count; ++tries) await page.waitForTimeout(50);
    assert.equal((await scene()).undo_steps, count);
  };
  await page.getByRole("button", {name: "Start a breeze"}).click();
  await stepsAre(1);
  assert.equal((await settings()).wind.speed, 0.5);

  const times = [];
  page.on("request", (request) => { if (/\/frames(\?|$)/.test(request.url()) && timeOf(request) !== undefined) times.push(timeOf(request)); });
  await page.getByRole("button", {name: "Play"}).click();
  for (let tries = 0; tries < 200 && new Set(times).size < 5; ++tries) await page.waitForTimeout(50);
  await page.getByRole("button", {name: "Pause"}).click();
  assert.ok(new Set(times).size >= 5, `moments asked for: ${times}`);
  assert.ok(times.every((time, k) => k === 0 || time >= times[k - 1]), `moments rise: ${times}`);
  await stepsAre(1);

  const shown = Number.parseFloat(await page.getByLabel("Time shown").textContent());
  assert.ok(shown > 0);
  await page.getByRole("button", {name: "Keep this time"}).click();
  await stepsAre(2);
  assert.ok(Math.abs((await settings()).wind.time - shown) < 0.01);
  await studio.finish();
});

test("the wind turns about the animal, and keeps how far it blows up", async () => {
  const {id} = await server.creature("heading");
  await server.post(`/v1/scenes/${id}/commands`, {op: "set_wind", wind: {speed: 0.5, direction: [1, 0.5, 0]}});
  const studio = await openStudio({scene: id});
  await studio.ready();
  await studio.panel("Wind");
  const heading = studio.page.getByLabel("Wind blows towards the animal's");
  assert.equal(await heading.inputValue(), "90");
  await heading.fill("180");
  await studio.settled(server, id, 2);
  const {direction} = (await server.get(`/v1/scenes/${id}/settings`)).wind;
  [0, 0.5, -1].forEach((wanted, k) => assert.ok(Math.abs(direction[k] - wanted) < 1e-6, direction.join(" ")));
  await studio.page.locator("output", {hasText: /^back$/}).waitFor();
  await studio.finish();
});
