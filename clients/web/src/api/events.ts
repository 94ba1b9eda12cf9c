// News of a scene as they happen: server-sent events, read with fetch so that the token can be sent, resumed where they broke.
import {signal} from "@preact/signals";
import {Aborted, Refusal, call, scenePath} from "./client";
import {offline} from "./outbox";

export interface ServerEvent { id: string; name: string; data: string }
export type Hear = (event: ServerEvent) => void;

/** Whether the stream of news stands. */
export const connected = signal(false);

const retry_ms = [250, 500, 1000, 2000, 4000];
const silent_ms = 40000;  // the server says something every 15 s

/** One event from its lines; null of a comment. */
export function parseEvent(block: string): ServerEvent | null {
  const event: ServerEvent = {id: "", name: "message", data: ""};
  for (const line of block.split("\n")) {
    const colon = line.indexOf(":");
    if (colon <= 0) continue;
    const value = line.slice(colon + 1).replace(/^ /, "");
    const field = line.slice(0, colon);
    if (field === "id") event.id = value;
    else if (field === "event") event.name = value;
    else if (field === "data") event.data += (event.data ? "\n" : "") + value;
  }
  return event.data ? event : null;
}

/** Calls `hear` until `stop` aborts or the stream ends. Gives the last id. */
async function readStream(body: ReadableStream<Uint8Array>, last: string, hear: Hear, heard: () => void): Promise<string> {
  const reader = body.pipeThrough(new TextDecoderStream() as unknown as ReadableWritablePair<string, Uint8Array>).getReader();
  let text = "";
  for (;;) {
    const {value, done} = await reader.read();
    if (done) return last;
    heard();
    text += value.replaceAll("\r\n", "\n");
    for (let end = text.indexOf("\n\n"); end >= 0; end = text.indexOf("\n\n")) {
      const event = parseEvent(text.slice(0, end));
      text = text.slice(end + 2);
      if (!event) continue;
      if (event.id) last = event.id;
      hear(event);
    }
  }
}

/** Hears of one scene until the signal aborts. */
export async function hearEvents(id: string, hear: Hear, stop: AbortSignal) {
  let last = "";
  for (let tries = 0; !stop.aborted; ++tries) {
    const attempt = new AbortController();
    const give_up = () => attempt.abort();
    stop.addEventListener("abort", give_up);
    let timer = 0;
    const heard = () => {
      clearTimeout(timer);
      timer = window.setTimeout(give_up, silent_ms);
    };
    try {
      heard();
      const answer = await call(`${scenePath(id)}/events`, {headers: {Accept: "text/event-stream", ...(last ? {"Last-Event-ID": last} : {})}, signal: attempt.signal});
      connected.value = true;
      offline.value = false;
      tries = 0;
      last = await readStream(answer.body!, last, (event) => { last = event.id || last; hear(event); }, heard);
    } catch (error) {
      if (error instanceof Refusal && error.status === 404) { hear({id: "", name: "removed", data: "{}"}); return; }
      if (!(error instanceof Refusal) && !(error instanceof Aborted)) offline.value = true;
    } finally {
      clearTimeout(timer);
      stop.removeEventListener("abort", give_up);
      connected.value = false;
    }
    if (!stop.aborted) await new Promise((wake) => setTimeout(wake, retry_ms[Math.min(tries, retry_ms.length - 1)]));
  }
}
