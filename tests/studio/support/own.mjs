// What a test file has of its own: a server and a Chromium, closed at its end. The names below are set before the first test.
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

/** Called once, at the top of a test file. `prepare` runs when server and browser are there, `finish` before they go. */
export function start({prepare = async () => {}, finish = async () => {}} = {}) {
  before(async () => {
    server = await serverWith();
    chrome = await browser();
    await prepare();
  });
  after(async () => {
    await finish();
    await chrome?.close();
    for (const one of servers) await one.stop();
  });
}

/** A window on the own server. */
export const openStudio = (options = {}) => Studio.open(chrome, server.address, options);
