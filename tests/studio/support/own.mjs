// What all test files of this program share: a server and a Chromium, closed at its end. They are there before the first test.
import {after, before} from "node:test";
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

let started;
const start_once = () => started ??= (async () => {
  server = await serverWith();
  chrome = await browser();
})();

let files = 0;

/** Called once, at the top of a test file. `prepare` runs when server and browser are there, `finish` before they go. */
export function start({prepare = async () => {}, finish = async () => {}} = {}) {
  ++files;
  before(async () => {
    await start_once();
    await prepare();
  });
  after(async () => {
    await finish();
    if (--files > 0) return;
    await chrome?.close();
    for (const one of servers) await one.stop();
  });
}

/** A window on the own server. */
export const openStudio = (options = {}) => Studio.open(chrome, server.address, options);
