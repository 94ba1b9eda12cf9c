// What all test files of this program share: a server and a Chromium.
import {test} from "node:test";
import {Server} from "./server.mjs";
import {Studio, browser} from "./studio.mjs";

export let server, chrome;
const servers = [];

/** Another server, started with these arguments. */
export async function serverWith(...arguments_) {
  const started = await Server.start(arguments_);
  servers.push(started);
  return started;
}

const finishes = [];

/** Called once, at the top of a test file. `prepare` runs before its tests, `finish` after them. */
export function start({prepare = async () => {}, finish = async () => {}} = {}) {
  test("made ready", async () => {
    server ??= await serverWith();
    chrome ??= await browser();
    await prepare();
  });
  finishes.push(finish);
}

/** Called once the tests of a file are known. The server takes so many scenes and no more. */
export const endFile = (subject) => {
  const finish = finishes.pop();
  return test(`${subject}: closed`, async () => {
    await finish();
    for (const {id} of (await server.get("/v1/scenes")).scenes) await fetch(`${server.address}/v1/scenes/${id}`, {method: "DELETE"});
  });
};

/** Called after the last file. */
export const endAll = () => test("server and browser: closed", async () => {
  await chrome?.close();
  for (const one of servers) await one.stop();
});

const idle = [];  // windows on the own server; a new one takes two seconds of CPU time

/** A window on the own server, used before by another test; a new one if the test is `alone` or asks for another context. */
export async function openStudio({alone = false, ...options} = {}) {
  if (alone || Object.keys(options.context ?? {}).length) return Studio.open(chrome, server.address, options);
  const studio = idle.pop();
  if (studio) await studio.show(options);
  const shared = studio ?? await Studio.open(chrome, server.address, options);
  shared.close = async () => {
    await shared.leave();
    idle.push(shared);
  };
  return shared;
}
