// The picture: drafts while something moves, the whole picture at rest, strands when it rests longer; and the ring meanwhile.
import assert from "node:assert/strict";
import {test} from "node:test";
import {openStudio, server, start} from "./support/own.mjs";

let id;
start({prepare: async () => { id = (await server.creature("view")).id; }});

test("draft, then the dial's picture, then strands that get better", async () => {
  const studio = await openStudio({scene: id, kept: {"trace-at-rest": true}});
  await studio.page.setViewportSize({width: 1024, height: 400});  // fewer pixels to trace
  await studio.ready();
  await studio.seen("rest");
  await studio.seen("traced");
  await studio.page.waitForFunction(() => window.marks.frame.filter(({stage}) => stage === "traced").length >= 2, null, {timeout: 120000});
  const badge = studio.page.locator(".badge");
  assert.match(await badge.innerText(), /^Final\s+\d+ of 64, drawing…$/);
  assert.match(await badge.locator(".badge-stage").getAttribute("title"), /samples per pixel.*revision 0/);
  const stages = await studio.page.evaluate(() => [...new Set(window.marks.frame.map(({stage}) => stage))]);
  assert.deepEqual(stages, ["draft", "rest", "traced"]);
  await studio.drag([[0.5, 0.5], [0.55, 0.5]], {button: "middle"});
  await studio.page.waitForFunction(() => window.marks.frame.some(({stage}) => stage === "turning"));
  await studio.seen("rest");
  await studio.finish();
});

test("the picture fits the window, and a dense screen gets its pixels at rest", async () => {
  const studio = await openStudio({scene: id, context: {viewport: {width: 1024, height: 700}, deviceScaleFactor: 2}});
  await studio.ready();
  await studio.seen("rest");
  const size = () => studio.page.evaluate(() => {
    const canvas = document.querySelector("canvas.picture[data-front]"), box = canvas.getBoundingClientRect();
    return {pixels: [canvas.width, canvas.height], box: [Math.round(box.width), Math.round(box.height)]};
  });
  const before_resize = await size();
  assert.deepEqual(before_resize.pixels, before_resize.box.map((side) => 2 * side));
  await studio.page.setViewportSize({width: 1280, height: 760});
  await studio.page.waitForFunction((old) => document.querySelector("canvas.picture[data-front]").width > old, before_resize.pixels[0]);
  await studio.page.waitForFunction(() => {
    const canvas = document.querySelector("canvas.picture[data-front]"), box = canvas.getBoundingClientRect();
    return Math.abs(canvas.width / canvas.height - box.width / box.height) < 0.01;
  });
  await studio.finish();
});

test("drafts are smaller while the server is slow, and as large as the canvas while it is fast", async () => {
  const studio = await openStudio({scene: id, before: () => {
    const send = window.fetch;
    window.said = 0;  // ms of the server for a draft
    window.widths = [];
    window.fetch = async (path, options) => {
      const answer = await send(path, options);
      const asked = /\/frames/.test(path) && options?.body ? JSON.parse(options.body) : null;
      if (asked?.quality !== "draft") return answer;
      window.widths.push(asked.width);
      const headers = new Headers(answer.headers);
      headers.set("Server-Timing", `draw;dur=${window.said}`);
      return new Response(await answer.blob(), {status: answer.status, headers});
    };
  }});
  await studio.ready();
  await studio.seen("rest");
  const reaches = async (milliseconds, share) => {
    await studio.page.evaluate((said) => { window.said = said; }, milliseconds);
    let off = 0;
    for (let stroke = 0; stroke < 20; ++stroke) {
      await studio.drag([[0.45, 0.5], [0.55, 0.5], [0.45, 0.55]], {steps: 15});
      off = await studio.page.evaluate((share) => window.widths.at(-1) - share * document.querySelector("canvas.picture[data-front]").getBoundingClientRect().width, share);
      if (Math.abs(off) <= 1) return;
    }
    assert.fail(`${off} pixels off at ${milliseconds} ms`);
  };
  await reaches(200, 0.5);
  await reaches(1, 1);
  await reaches(100, 0.5);
  await studio.seen("rest");
  await studio.finish();
});

test("an opened scene is drawn from where its view stays", async () => {
  const studio = await openStudio({scene: id, before: () => {
    const send = window.fetch;
    window.drawn = [];
    window.fetch = (path, ...rest) => {
      const {view = "", camera} = /\/frames/.test(path) ? JSON.parse(rest[0].body) : {};
      if (view && !view.endsWith("-tool")) window.drawn.push(JSON.stringify(camera));
      return send(path, ...rest);
    };
  }});
  await studio.seen("rest");
  const drawn = await studio.page.evaluate(() => window.drawn);
  assert.ok(drawn.length > 1);
  assert.equal(new Set(drawn).size, 1, drawn.join("\n"));
  await studio.finish();
});

test("never more than two frames are in flight", async () => {
  const studio = await openStudio({scene: id, before: () => {
    const send = window.fetch;
    let now = 0;
    window.max_in_flight = 0;
    window.fetch = (path, ...rest) => {
      const is_frame = /\/frames/.test(path) && !JSON.parse(rest[0].body).view.endsWith("-tool");  // the picture in the panel is another
      if (is_frame) window.max_in_flight = Math.max(window.max_in_flight, ++now);
      return send(path, ...rest).finally(() => { if (is_frame) --now; });
    };
  }});
  await studio.ready();
  await studio.drag([[0.05, 0.9], [0.2, 0.85], [0.05, 0.8]], {steps: 20});
  await studio.drag([[0.45, 0.5], [0.55, 0.5]], {steps: 20});
  await studio.seen("rest");
  const max_in_flight = await studio.page.evaluate(() => window.max_in_flight);
  assert.ok(max_in_flight >= 1 && max_in_flight <= 2, `${max_in_flight} at once`);
  await studio.finish();
});

test("the mirrored ring is seen, but not through the body", async () => {
  const studio = await openStudio({scene: id, context: {reducedMotion: "no-preference"}});  // so that the view glides
  studio.expected.push(/willReadFrequently/);  // the test reads what the page only draws
  await studio.ready();
  const drawn = () => studio.page.evaluate(async () => {
    await new Promise((later) => requestAnimationFrame(() => requestAnimationFrame(later)));
    const sketch = document.querySelector("canvas.sketch"), {width, height} = sketch;
    // About the middle alone: the frame of the mirror plane is drawn farther out.
    const {data} = sketch.getContext("2d").getImageData(width * 0.35, height * 0.35, width * 0.3, height * 0.3);
    return data.reduce((sum, value, k) => sum + (k % 4 === 3 && value > 0 ? 1 : 0), 0);
  });
  const mirroring = async (on) => {
    await studio.page.keyboard.press("x");
    await studio.page.waitForFunction((wanted) => document.querySelector('[aria-label="Mirror"]').ariaPressed === String(wanted), on);
    await studio.page.waitForTimeout(150);  // the ring is drawn at the screen's next frame
  };
  const counts = {};
  for (const [view, key, at] of [["side", "4", [0.5, 0.5]], ["front", "1", [0.54, 0.5]]]) {
    await studio.page.keyboard.press(key);
    await studio.page.waitForTimeout(600);
    await studio.page.mouse.move(...await studio.at(...at));
    const alone = await drawn();
    await mirroring(true);
    counts[view] = {alone, mirrored: await drawn()};
    await mirroring(false);
  }
  assert.ok(counts.side.alone > 200, `${counts.side.alone} pixels of a ring`);
  assert.ok(counts.side.mirrored < counts.side.alone + 100, `${counts.side.mirrored} pixels, more than the ${counts.side.alone} of the ring before the body`);
  assert.ok(counts.front.mirrored > counts.front.alone + 300, `${counts.front.mirrored} pixels, not more than the ${counts.front.alone} of one ring`);
  await studio.finish();
});

test("a picture that is given up while its bytes come says nothing", async () => {
  const studio = await openStudio({scene: id, before: () => {
    const blob = Response.prototype.blob;
    Response.prototype.blob = async function () {
      if (window.slow_bytes && this.headers.get("Content-Type") === "image/png") {  // of a picture at rest
        window.coming = true;
        await new Promise((go) => setTimeout(go, 1000));
      }
      return blob.call(this).catch((error) => { window.given_up = (window.given_up ?? 0) + 1; throw error; });
    };
  }});
  await studio.ready();
  await studio.seen("rest");
  const {page} = studio;
  await page.evaluate(() => { window.slow_bytes = true; });
  await page.keyboard.press("1");
  await page.waitForFunction(() => window.coming);
  await page.keyboard.press("2");
  await page.waitForFunction(() => window.given_up > 0);
  assert.equal(await page.locator(".message-error").count(), 0);
  await studio.finish();
});
