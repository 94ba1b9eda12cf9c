// The picture: drafts while something moves, the whole picture at rest, strands when it rests longer; and the ring meanwhile.
import assert from "node:assert/strict";
import {after, before, test} from "node:test";
import {Server} from "./support/server.mjs";
import {Studio, browser} from "./support/studio.mjs";

let server, chrome, id;

before(async () => {
  server = await Server.start();
  chrome = await browser();
  id = (await server.creature("view", 2000)).id;
});
after(async () => {
  await chrome?.close();
  await server?.stop();
});

test("draft, then the dial's picture, then strands that get better", async () => {
  const context = {viewport: {width: 1024, height: 700}};
  const studio = await Studio.open(chrome, server.address, {scene: id, context, kept: {"trace-at-rest": true}});
  await studio.ready();
  await studio.seen("rest");
  await studio.seen("traced");
  await studio.page.waitForFunction(() => window.marks.frame.filter(({stage}) => stage === "traced").length >= 2, null, {timeout: 120000});
  assert.match(await studio.page.locator(".badge").innerText(), /strands/);
  const stages = await studio.page.evaluate(() => [...new Set(window.marks.frame.map(({stage}) => stage))]);
  assert.deepEqual(stages, ["draft", "rest", "traced"]);
  await studio.drag([[0.5, 0.5], [0.55, 0.5]], {button: "middle"});
  await studio.page.waitForFunction(() => window.marks.frame.some(({stage}) => stage === "turning"));
  await studio.seen("rest");
  studio.quiet();
  await studio.close();
});

test("the picture fits the window, and a dense screen gets its pixels at rest", async () => {
  const studio = await Studio.open(chrome, server.address, {scene: id, context: {viewport: {width: 1024, height: 700}, deviceScaleFactor: 2}});
  await studio.ready();
  await studio.seen("rest");
  const size = () => studio.page.evaluate(() => {
    const canvas = document.querySelector("canvas.picture"), box = canvas.getBoundingClientRect();
    return {pixels: [canvas.width, canvas.height], box: [Math.round(box.width), Math.round(box.height)]};
  });
  const before_resize = await size();
  assert.deepEqual(before_resize.pixels, before_resize.box.map((side) => 2 * side));
  await studio.page.setViewportSize({width: 1280, height: 760});
  await studio.page.waitForFunction((old) => document.querySelector("canvas.picture").width > old, before_resize.pixels[0]);
  await studio.page.waitForFunction(() => {
    const canvas = document.querySelector("canvas.picture"), box = canvas.getBoundingClientRect();
    return Math.abs(canvas.width / canvas.height - box.width / box.height) < 0.01;
  });
  studio.quiet();
  await studio.close();
});

test("never more than two frames are in flight", async () => {
  const studio = await Studio.open(chrome, server.address, {scene: id, before: () => {
    const send = window.fetch;
    let now = 0;
    window.most = 0;
    window.fetch = (path, ...rest) => {
      const is_frame = /\/frames/.test(path);
      if (is_frame) window.most = Math.max(window.most, ++now);
      return send(path, ...rest).finally(() => { if (is_frame) --now; });
    };
  }});
  await studio.ready();
  await studio.drag([[0.05, 0.9], [0.2, 0.85], [0.05, 0.8]], {steps: 40});
  await studio.drag([[0.45, 0.5], [0.55, 0.5]], {steps: 40});
  await studio.seen("rest");
  const most = await studio.page.evaluate(() => window.most);
  assert.ok(most >= 1 && most <= 2, `${most} at once`);
  studio.quiet();
  await studio.close();
});
