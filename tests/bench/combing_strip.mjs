// Shows what a user sees in one second of combing: a row of pictures of the studio, an eighth of a second apart. Uses a real
// Chromium and a real server, both on this machine.
// usage: node combing_strip.mjs STRIP.jpg    from tests/bench, with PELAGE_BIN
import {writeFileSync} from "node:fs";
import {Server} from "../studio/support/server.mjs";
import {Studio, browser} from "../studio/support/studio.mjs";

const file = process.argv[2];
const seconds = 1, pictures = 8, middle = {x: 0.30, y: 0.22, width: 0.40, height: 0.56};  // shares of the drawing surface

/** Moves the pressed brush to and fro for the seconds, as fast as the page takes it. */
async function comb(studio, start) {
  while (Date.now() - start < seconds * 1000) {
    const share = (Date.now() - start) / (seconds * 1000);
    await studio.page.mouse.move(...await studio.at(0.42 + 0.18 * share, 0.5 + 0.06 * Math.sin(12 * share)));
    await studio.page.waitForTimeout(15);
  }
}

/** The frame that was on the screen at a time. */
const shown_at = (frames, time) => frames.findLast(({at}) => at <= time) ?? frames[0];

async function second_of(studio) {
  const devtools = await studio.context.newCDPSession(studio.page), frames = [];
  devtools.on("Page.screencastFrame", ({data, metadata, sessionId}) => {
    frames.push({data, at: metadata.timestamp * 1000});
    devtools.send("Page.screencastFrameAck", {sessionId}).catch(() => {});  // the window may be closed
  });
  await devtools.send("Page.startScreencast", {format: "jpeg", quality: 92, everyNthFrame: 1});
  await studio.page.mouse.move(...await studio.at(0.42, 0.5));
  await studio.page.mouse.down();
  const start = Date.now();
  await comb(studio, start);
  await devtools.send("Page.stopScreencast");
  await studio.page.mouse.up();
  return Array.from({length: pictures}, (_, k) => shown_at(frames, start + (k + 1) * seconds * 1000 / pictures).data);
}

const cell = (box, data) => `<div style="width:${box.width * middle.width}px;height:${box.height * middle.height}px;overflow:hidden">
  <img src="data:image/jpeg;base64,${data}" style="margin:${-box.y - middle.y * box.height}px 0 0 ${-box.x - middle.x * box.width}px"></div>`;

const server = await Server.start();
const chrome = await browser();
try {
  const {id} = await server.creature("strip", 5000);
  const studio = await Studio.open(chrome, server.address, {scene: id, context: {viewport: {width: 1280, height: 800}}});
  await studio.ready();
  await studio.page.waitForTimeout(3000);  // until the picture no longer changes
  const box = await studio.page.locator(".surface").boundingBox(), seen = await second_of(studio);
  const page = await (await chrome.newContext({viewport: {width: 400, height: 400}, deviceScaleFactor: 0.5})).newPage();
  await page.setContent(`<body style="margin:0;width:max-content"><div style="display:flex;gap:4px">${
    seen.map((data) => cell(box, data)).join("")}</div></body>`);
  writeFileSync(file, await page.locator("body").screenshot({type: "jpeg", quality: 88}));
} finally {
  await chrome.close();
  await server.stop();
}
