// Measures how fast the studio responds, with a real Chromium and a real server, both on this machine. Run by hand; prints a table.
// usage: node studio.mjs [--delay MS] [--strokes N]    from tests/bench, with PELAGE_BIN; MS each way on the line between them
import {Server} from "../studio/support/server.mjs";
import {SlowLine} from "../studio/support/slow_line.mjs";
import {Studio, browser} from "../studio/support/studio.mjs";

const option = (name, initial) => {
  const at = process.argv.indexOf(`--${name}`);
  return at < 0 ? initial : Number(process.argv[at + 1]);
};
const delay = option("delay", 0), strokes = option("strokes", 0);

const sorted = (numbers) => [...numbers].sort((a, b) => a - b);
const quantile = (numbers, share) => sorted(numbers)[Math.min(numbers.length - 1, Math.floor(share * numbers.length))] ?? NaN;
const row = (name, numbers, unit = "ms") =>
  console.log(`${name.padEnd(46)} median ${quantile(numbers, 0.5).toFixed(1).padStart(7)}  95% ${quantile(numbers, 0.95).toFixed(1).padStart(7)}  worst ${Math.max(...numbers).toFixed(1).padStart(7)} ${unit}  (${numbers.length})`);

/** The time that the server reports for a picture, in milliseconds. */
const serverTime = ({timings}) => ["queue", "upload", "draw", "read", "encode"].reduce((sum, name) => sum + (timings[name] ?? 0), 0);

async function comb(studio) {
  const points = [];
  for (let k = 0; k < 180; ++k) points.push(await studio.at(0.5 + 0.12 * Math.cos(k / 14), 0.5 + 0.1 * Math.sin(k / 14)));
  await studio.page.evaluate(() => { for (const list of Object.values(window.marks)) list.length = 0; });
  await studio.page.mouse.move(...points[0]);
  await studio.page.mouse.down();
  for (const point of points) {
    await studio.page.mouse.move(...point);
    await studio.page.waitForTimeout(15);
  }
  await studio.page.mouse.up();
  await studio.page.waitForTimeout(1500);
  const {frame, part, ring} = await studio.page.evaluate(() => window.marks);
  const drafts = frame.filter(({stage}) => stage === "draft");
  const latencies = part.map(({newest, revision}) => (frame.find((one) => one.revision >= revision)?.shown ?? NaN) - newest).filter(Number.isFinite);
  row("combing: pointer move to its picture", latencies);
  row("  of it the part's way to the server and back", part.map(({start, end}) => end - start));
  row("  of it the server's time for the picture", drafts.map(serverTime));
  row("  of it the client's: bytes to screen", drafts.map(({answered, shown}) => shown - answered));
  row("brush ring: to draw it", ring.map(({start, end}) => end - start));
}

async function turn(studio) {
  await studio.page.evaluate(() => { for (const list of Object.values(window.marks)) list.length = 0; });
  const [x, y] = await studio.at(0.5, 0.5);
  await studio.page.mouse.move(x, y);
  await studio.page.mouse.down({button: "middle"});
  const seconds = 4, start = Date.now();
  for (let k = 0; Date.now() - start < seconds * 1000; ++k) {
    await studio.page.mouse.move(x + 120 * Math.sin(k / 20), y + 30 * Math.cos(k / 20));
    await studio.page.waitForTimeout(15);
  }
  await studio.page.mouse.up({button: "middle"});
  const frames = (await studio.page.evaluate(() => window.marks.frame)).filter(({stage}) => stage === "turning");
  console.log(`orbit: ${(frames.length / seconds).toFixed(1)} pictures a second`);
  row("  the server's time for a picture", frames.map(serverTime));
  row("  asked to shown", frames.map(({asked, shown}) => shown - asked));
}

/** Bytes of the page, and how soon it is usable: tools can be chosen, and the brush's ring finds the model. */
async function page(studio) {
  const facts = await studio.page.evaluate(() => {
    const own = [...performance.getEntriesByType("navigation"), ...performance.getEntriesByType("resource")].filter(({name}) => !name.includes("/v1/"));
    return {bytes: own.reduce((sum, {encodedBodySize}) => sum + encodedBodySize, 0), first: performance.getEntriesByType("navigation")[0].responseStart,
            palette: window.marks.palette[0].at, ring: window.marks.proxy[0].at, picture: window.marks.frame[0].shown};
  });
  const after = (at) => `${Math.round(at - facts.first)} ms`;
  console.log(`page: ${(facts.bytes / 1000).toFixed(1)} kB as sent. After its first byte: tools ${after(facts.palette)}, brush ring ${after(facts.ring)}, first picture ${after(facts.picture)}`);
}

async function memory(studio) {
  const devtools = await studio.context.newCDPSession(studio.page);
  const heap = async () => {
    await devtools.send("HeapProfiler.collectGarbage");
    return (await devtools.send("Runtime.getHeapUsage")).usedSize / 1e6;
  };
  console.log(`memory of the page: ${(await heap()).toFixed(1)} MB`);
  for (let k = 0; k < strokes; ++k) {
    const at = [0.4 + 0.2 * ((k * 0.37) % 1), 0.4 + 0.2 * ((k * 0.61) % 1)];
    await studio.drag([at, [at[0] + 0.03, at[1]]], {steps: 4});
    await studio.page.evaluate(() => { for (const list of Object.values(window.marks)) list.length = 0; });
    if ((k + 1) % 250 === 0) console.log(`  after ${k + 1} strokes: ${(await heap()).toFixed(1)} MB`);
  }
}

const server = await Server.start();
const line = delay ? await SlowLine.open(server.port, delay) : null;
const chrome = await browser();
try {
  const {id} = await server.creature("bench", 5000);
  const studio = await Studio.open(chrome, line?.address ?? server.address, {scene: id, context: {viewport: {width: 1280, height: 800}}});
  await studio.ready();
  await page(studio);
  await comb(studio);
  await turn(studio);
  if (strokes) await memory(studio);
} finally {
  await chrome.close();
  line?.close();
  await server.stop();
}
