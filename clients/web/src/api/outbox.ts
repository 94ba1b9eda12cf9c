// Changes on their way to the server: sent in order, one at a time, again after a lost connection, and kept in this browser
// until they are answered, so that closing the page loses nothing.
import {signal} from "@preact/signals";
import {Offline, Refusal, change} from "./client";
import {page_id} from "./identity";
import type {CommandAnswer} from "./types";

export interface Change {
  scene: string;
  /** Below the scene's address: "commands", "undo", ... */
  path: string;
  body: unknown;
  /** The same each time that it is sent, so that it is done once. */
  key: string;
}
interface Waiting extends Change { done: (answer: CommandAnswer) => void; failed: (error: Error) => void }

const store = "pelage.outbox";
const retry_seconds = [0.25, 0.5, 1, 2, 4];

/** How many changes are not answered yet. */
export const unsent = signal(0);
/** Whether the changes that are not answered yet are kept in this browser: not where its store is full or forbidden. */
export const keeps = signal(true);
/** Whether the last try found no server. */
export const offline = signal(false);

const queue: Waiting[] = [];
let busy = false;
let serial = 0;

function remember() {
  unsent.value = queue.length;
  try {
    const kept = queue.map(({scene, path, body, key}) => ({scene, path, body, key}));
    if (kept.length) localStorage.setItem(`${store}.${page_id}`, JSON.stringify(kept));
    else localStorage.removeItem(`${store}.${page_id}`);
    keeps.value = true;
  } catch {
    keeps.value = false;  // the changes are still sent from this page
  }
}

const sleep = (seconds: number) => new Promise((wake) => setTimeout(wake, seconds * 1000));
const try_again = (error: unknown) => error instanceof Offline || (error instanceof Refusal && [429, 502, 503, 504].includes(error.status)) ||
  (error instanceof Refusal && error.status === 409 && /still running/.test(error.message));

async function sendUntilAnswered(sent: Waiting) {
  for (let tries = 0; ; ++tries) {
    try {
      const answer = await change(sent.scene, sent.path, sent.body, sent.key);
      offline.value = false;
      return answer;
    } catch (error) {
      if (!try_again(error)) throw error;
      offline.value = error instanceof Offline;
      await sleep(retry_seconds[Math.min(tries, retry_seconds.length - 1)]!);
    }
  }
}

async function work() {
  if (busy) return;
  busy = true;
  for (let sent = queue[0]; sent; sent = queue[0]) {
    try {
      const answer = await sendUntilAnswered(sent);
      queue.shift();
      remember();
      sent.done(answer);
    } catch (error) {
      queue.shift();
      remember();
      sent.failed(error as Error);
    }
  }
  busy = false;
}

/** Resolves with the server's answer, or is rejected with its Refusal. */
export function send(scene: string, path: string, body: unknown, key = `${page_id}-${++serial}`): Promise<CommandAnswer> {
  return new Promise((done, failed) => {
    queue.push({scene, path, body, key, done, failed});
    remember();
    void work();
  });
}

/** What another page left under `name`, which is taken away. */
function takeLeft(name: string): Change[] {
  const text = localStorage.getItem(name) ?? "[]";
  localStorage.removeItem(name);
  try {
    const left = JSON.parse(text) as unknown;
    return Array.isArray(left) ? left as Change[] : [];
  } catch {
    return [];  // the browser was killed while it wrote
  }
}

/** What pages left in this browser; nothing where it keeps nothing. */
function leftovers(): Change[] {
  try {
    return Object.keys(localStorage).filter((name) => name.startsWith(`${store}.`) && name !== `${store}.${page_id}`).flatMap(takeLeft);
  } catch {
    return [];  // the store is forbidden
  }
}

/** Sends what a page left that was closed before its answers came; gives how many changes that were. */
export function sendLeftovers(): number {
  const all = leftovers();
  for (const left of all) send(left.scene, left.path, left.body, left.key).catch(() => undefined);  // its scene may be gone
  return all.length;
}
