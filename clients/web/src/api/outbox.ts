// The queue of changes to send: one at a time and in order, repeated after a lost connection, and stored in this browser
// until they are answered, so that closing the page loses nothing.
import {signal} from "@preact/signals";
import {Offline, Refusal, change} from "./client";
import {page_id} from "./identity";
import type {CommandAnswer} from "./types";

export interface Change {
  scene: string;
  /** URL path relative to the scene's: "commands", "undo", ... */
  path: string;
  body: unknown;
  /** Idempotency key: the same each time the change is sent, so that the server runs it once. */
  key: string;
}
interface QueuedChange extends Change { done: (answer: CommandAnswer) => void; failed: (error: Error) => void }

const store = "pelage.outbox";
const retry_seconds = [0.25, 0.5, 1, 2, 4];

/** Number of changes that are not answered yet. */
export const unsent = signal(0);
/** True if the unanswered changes are stored in this browser; false if its storage is full or forbidden. */
export const storage_works = signal(true);
/** True if the last attempt got no answer from the server. */
export const offline = signal(false);

const queue: QueuedChange[] = [];
let busy = false;
let serial = 0;

function persist() {
  unsent.value = queue.length;
  try {
    const changes = queue.map(({scene, path, body, key}) => ({scene, path, body, key}));
    if (changes.length) localStorage.setItem(`${store}.${page_id}`, JSON.stringify(changes));
    else localStorage.removeItem(`${store}.${page_id}`);
    storage_works.value = true;
  } catch {
    storage_works.value = false;  // the changes are still sent from this page
  }
}

const sleep = (seconds: number) => new Promise((wake) => setTimeout(wake, seconds * 1000));
const isRetryable = (error: unknown) => error instanceof Offline || (error instanceof Refusal && [429, 502, 503, 504].includes(error.status)) ||
  (error instanceof Refusal && error.status === 409 && /still running/.test(error.message));

async function sendUntilAnswered(sent: QueuedChange) {
  for (let tries = 0; ; ++tries) {
    try {
      const answer = await change(sent.scene, sent.path, sent.body, sent.key);
      offline.value = false;
      return answer;
    } catch (error) {
      if (!isRetryable(error)) throw error;
      offline.value = error instanceof Offline;
      await sleep(retry_seconds[Math.min(tries, retry_seconds.length - 1)]!);
    }
  }
}

async function processQueue() {
  if (busy) return;
  busy = true;
  for (let sent = queue[0]; sent; sent = queue[0]) {
    try {
      const answer = await sendUntilAnswered(sent);
      queue.shift();
      persist();
      sent.done(answer);
    } catch (error) {
      queue.shift();
      persist();
      sent.failed(error as Error);
    }
  }
  busy = false;
}

/** Queues a change. Resolves with the server's answer, or is rejected with its Refusal. */
export function send(scene: string, path: string, body: unknown, key = `${page_id}-${++serial}`): Promise<CommandAnswer> {
  return new Promise((done, failed) => {
    queue.push({scene, path, body, key, done, failed});
    persist();
    void processQueue();
  });
}

/** Removes the storage entry `name` of another page, and returns the changes in it. */
function takeStored(name: string): Change[] {
  const text = localStorage.getItem(name) ?? "[]";
  localStorage.removeItem(name);
  try {
    const left = JSON.parse(text) as unknown;
    return Array.isArray(left) ? left as Change[] : [];
  } catch {
    return [];  // the browser was killed while it wrote
  }
}

/** Removes and returns the unanswered changes that other pages stored in this browser. */
function takeOrphaned(): Change[] {
  try {
    return Object.keys(localStorage).filter((name) => name.startsWith(`${store}.`) && name !== `${store}.${page_id}`).flatMap(takeStored);
  } catch {
    return [];  // the storage is forbidden
  }
}

/** Sends the changes of pages that were closed before the answers came. Returns the number of changes. */
export function sendLeftovers(): number {
  const all = takeOrphaned();
  for (const left of all) send(left.scene, left.path, left.body, left.key).catch(() => undefined);  // the scene may be gone
  return all.length;
}
