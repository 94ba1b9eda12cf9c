// Plays a long session in the studio twice, from recorded pointer input: both must end with the same groom and without memory growth. Uses
// a real Chromium and a real server. Run by hand. usage: node long_session.mjs [--minutes M] [--seed S]    from tests/bench, with PELAGE_BIN
import {readFileSync} from "node:fs";
import {Server} from "../studio/support/server.mjs";
import {Studio, browser} from "../studio/support/studio.mjs";

const option = (name, initial) => {
  const at = process.argv.indexOf(`--${name}`);
  return at < 0 ? initial : Number(process.argv[at + 1]);
};
const minutes = option("minutes", 30), report_every = 25;  // report_every: number of actions

/** Returns a generator of numbers in [0, 1) from a seed (mulberry32). */
function numbers(seed) {
  let state = seed >>> 0;
  return () => {
    state = (state + 0x6d2b79f5) >>> 0;
    let mixed = Math.imul(state ^ (state >>> 15), 1 | state);
    mixed = (mixed + Math.imul(mixed ^ (mixed >>> 7), 61 | mixed)) ^ mixed;
    return ((mixed ^ (mixed >>> 14)) >>> 0) / 2 ** 32;
  };
}

const tools = ["comb", "comb", "comb", "smooth", "length", "lift", "paint", "part", "clump", "curl"];

/** Yields the user's actions: tools, strokes over the middle of the picture, views, sometimes an undo. */
function* recorded(seed) {
  const random = numbers(seed);
  for (;;) {
    const chance = random();
    if (chance < 0.1) yield {view: String(1 + Math.floor(5 * random()))};
    else if (chance < 0.17) yield {undo: true};
    else if (chance < 0.3) yield {tool: tools[Math.floor(tools.length * random())]};
    else {
      const from = [0.35 + 0.3 * random(), 0.35 + 0.3 * random()], angle = 2 * Math.PI * random();
      yield {stroke: [0, 0.5, 1].map((share) => [from[0] + 0.12 * share * Math.cos(angle + share), from[1] + 0.12 * share * Math.sin(angle + share)])};
    }
  }
}

/** Waits until the studio is idle, so that the second session meets the same state as the first. */
async function settle(studio, server, id) {
  for (let calm = 0; calm < 2;) {
    await studio.page.waitForTimeout(60);
    const {revision} = await server.get(`/v1/scenes/${id}`);
    const ready = await studio.page.evaluate((newest) => window.marks.proxy.at(-1)?.revision === newest && window.marks.frame.at(-1)?.revision === newest &&
      document.querySelector(".badge .dot-rest") !== null, revision);
    calm = ready ? calm + 1 : 0;
  }
}

async function act(studio, action) {
  if (action.tool) await studio.tool(action.tool);
  if (action.view) await studio.page.keyboard.press(action.view);
  if (action.undo) await studio.page.keyboard.press("Control+z");
  if (action.stroke) await studio.drag(action.stroke, {steps: 10});
  await studio.page.waitForTimeout(400);
}

const megabytesOf = (pid) => Number(/VmRSS:\s+(\d+)/.exec(readFileSync(`/proc/${pid}/status`, "utf8"))[1]) / 1024;

async function session(server, chrome, name, actions, ends) {
  const {id} = await server.creature(name, 5000);
  const studio = await Studio.open(chrome, server.address, {scene: id, context: {viewport: {width: 1280, height: 800}}});
  await studio.ready();
  const devtools = await studio.context.newCDPSession(studio.page);
  const heap = async () => {
    await devtools.send("HeapProfiler.collectGarbage");
    return (await devtools.send("Runtime.getHeapUsage")).usedSize / 1e6;
  };
  const hashes = [], started = Date.now();
  for (const action of actions) {
    if (ends(hashes.length, (Date.now() - started) / 60000)) break;
    await settle(studio, server, id);
    await act(studio, action);
    hashes.push((await server.get(`/v1/scenes/${id}`)).fields_hash);
    await studio.page.evaluate(() => { for (const list of Object.values(window.marks)) list.splice(0, list.length - 1); });
    if (hashes.length % report_every === 0)
      console.log(`${name}: ${hashes.length} actions, ${((Date.now() - started) / 60000).toFixed(1)} min; page ${(await heap()).toFixed(1)} MB, server ${megabytesOf(server.process.pid).toFixed(0)} MB`);
  }
  await settle(studio, server, id);
  hashes.push((await server.get(`/v1/scenes/${id}`)).fields_hash);
  studio.quiet();
  await studio.context.close();
  return hashes;
}

const server = await Server.start();
const chrome = await browser();
try {
  const seed = option("seed", 1);
  const first = await session(server, chrome, "first", recorded(seed), (_, passed) => passed >= minutes);
  const second = await session(server, chrome, "second", recorded(seed), (count) => count >= first.length - 1);
  const differs = first.findIndex((hash, at) => hash !== second[at] && first[at + 1] !== second[at + 1]);
  console.log(first.at(-1) === second.at(-1) ? `the same groom after ${first.length - 1} actions: ${first.at(-1)}` : `another groom from action ${differs + 1} of ${first.length - 1} on`);
  process.exitCode = first.at(-1) === second.at(-1) ? 0 : 1;
} finally {
  await chrome.close();
  await server.stop();
}
