// Compares polling for frames as the studio does (two requests in flight, `after` the known revision) with frames pushed over one
// connection, on a line with latency. The pusher is a program beside the server that polls it without latency and forwards the frames.
// usage: node push_or_ask.mjs [--delay MS] [--seconds S]    with PELAGE_BIN; MS each way
import net from "node:net";
import {setTimeout as sleep} from "node:timers/promises";
import {Server} from "../studio/support/server.mjs";
import {SlowLine} from "../studio/support/slow_line.mjs";

const option = (name, initial) => {
  const at = process.argv.indexOf(`--${name}`);
  return at < 0 ? initial : Number(process.argv[at + 1]);
};
const delay = option("delay", 25), seconds = option("seconds", 6);
const request = {width: 900, height: 700, quality: "draft", format: "jpeg", lossy_quality: 85};

const post = (address, path, body) => fetch(address + path, {method: "POST", body: JSON.stringify(body), headers: {"Content-Type": "application/json"}});

/** Combs in parts, each sent once the previous one is answered. Returns when the newest sample of each revision was sent. */
async function comb(address, id, on_send) {
  const sent = [], start = performance.now();
  for (let part = 0; performance.now() - start < seconds * 1000; ++part) {
    const samples = [0, 1].map((k) => ({screen: [250 + 60 * Math.cos((2 * part + k) / 15), 260 + 50 * Math.sin((2 * part + k) / 15)], time: (2 * part + k) / 60}));
    const at = performance.now();
    on_send();
    const answer = await (await post(address, `/v1/scenes/${id}/commands`, {op: "comb", stroke: {id: "bench", part, last: false, view: {}, samples}})).json();
    sent.push({at, revision: answer.revision});
    await sleep(Math.max(0, 33 - (performance.now() - at)));
  }
  return sent;
}

async function asking(address, id) {
  const seen = [];
  let known = 0, in_flight = 0, wanted = false;
  const ask = async () => {
    if (in_flight >= 2) { wanted = true; return; }
    wanted = false;
    ++in_flight;
    const answer = await post(address, `/v1/scenes/${id}/frames?after=${known}&wait=1`, {...request, view: `ask-${in_flight}`});
    if (answer.status === 200) {
      await answer.arrayBuffer();
      const revision = Number(answer.headers.get("Pelage-Revision"));
      known = Math.max(known, revision);
      seen.push({at: performance.now(), revision});
    }
    --in_flight;
    if (wanted) void ask();
  };
  const sent = await comb(address, id, () => void ask());
  await sleep(1500);
  return {sent, seen};
}

/** Starts a push server beside pelaged, which sends frames as [length, revision, bytes] over one connection. */
function pusher(address, id) {
  return new Promise((ready) => {
    const server = net.createServer(async (client) => {
      client.setNoDelay(true);
      client.on("error", () => {});
      for (let known = 0; !client.destroyed;) {
        const answer = await post(address, `/v1/scenes/${id}/frames?after=${known}&wait=1`, {...request, view: "push"}).catch(() => null);
        if (!answer || answer.status !== 200) continue;
        const bytes = Buffer.from(await answer.arrayBuffer());
        known = Number(answer.headers.get("Pelage-Revision"));
        const head = Buffer.alloc(8);
        head.writeUInt32LE(bytes.length, 0);
        head.writeUInt32LE(known, 4);
        client.write(Buffer.concat([head, bytes]));
      }
    });
    server.listen(0, "127.0.0.1", () => ready(server));
  });
}

async function pushed(address, id, push_port) {
  const seen = [];
  const connection = net.connect(push_port, "127.0.0.1");
  let bytes = Buffer.alloc(0);
  connection.on("data", (more) => {
    bytes = Buffer.concat([bytes, more]);
    while (bytes.length >= 8 && bytes.length >= 8 + bytes.readUInt32LE(0)) {
      seen.push({at: performance.now(), revision: bytes.readUInt32LE(4)});
      bytes = bytes.subarray(8 + bytes.readUInt32LE(0));
    }
  });
  await sleep(300);
  const sent = await comb(address, id, () => {});
  await sleep(1500);
  connection.destroy();
  return {sent, seen};
}

function report(name, {sent, seen}) {
  const waits = sent.map(({at, revision}) => (seen.find((frame) => frame.revision >= revision && frame.at >= at)?.at ?? NaN) - at).filter(Number.isFinite).sort((a, b) => a - b);
  const of = (share) => waits[Math.min(waits.length - 1, Math.floor(share * waits.length))].toFixed(0);
  console.log(`${name.padEnd(8)} median ${of(0.5)} ms, 95% ${of(0.95)} ms; ${(seen.length / seconds).toFixed(1)} pictures/s, ${(sent.length / seconds).toFixed(1)} parts/s`);
}

const server = await Server.start();
const line = await SlowLine.open(server.port, delay);
console.log(`${2 * delay} ms there and back`);
try {
  for (let round = 0; round < 3; ++round) {
    const one = await server.creature(`ask ${round}`, 5000);
    await (await post(server.address, `/v1/scenes/${one.id}/frames`, request)).arrayBuffer();
    report("asked", await asking(line.address, one.id));
    const other = await server.creature(`push ${round}`, 5000);
    await (await post(server.address, `/v1/scenes/${other.id}/frames`, request)).arrayBuffer();
    const push = await pusher(server.address, other.id);
    const push_line = await SlowLine.open(push.address().port, delay);
    report("pushed", await pushed(line.address, other.id, new URL(push_line.address).port));
    push_line.close();
    push.close();
  }
} finally {
  line.close();
  await server.stop();
}
process.exit(0);
