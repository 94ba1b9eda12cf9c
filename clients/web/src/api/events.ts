// Receives a scene's changes as server-sent events. Uses fetch, because EventSource cannot send the token, and resumes
// after the last event when the connection breaks.
import {signal} from "@preact/signals";
import {Aborted, Refusal, call, scenePath} from "./client";
import {offline} from "./outbox";

export interface ServerEvent { id: string; name: string; data: string }
export type EventHandler = (event: ServerEvent) => void;

/** True while the event stream is connected. */
export const connected = signal(false);

const retry_ms = [250, 500, 1000, 2000, 4000];
const idle_timeout_ms = 40000;  // ms without data until a reconnect; the server sends a comment every 15 s

/** Parses the lines of one event; null for a comment. */
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

/** Calls `onEvent` for each event and `onData` for any data, until the stream ends. Returns the last event's id. */
async function readStream(body: ReadableStream<Uint8Array>, last: string, onEvent: EventHandler, onData: () => void): Promise<string> {
  const reader = body.pipeThrough(new TextDecoderStream() as unknown as ReadableWritablePair<string, Uint8Array>).getReader();
  let text = "";
  for (;;) {
    const {value, done} = await reader.read();
    if (done) return last;
    onData();
    text += value.replaceAll("\r\n", "\n");
    for (let end = text.indexOf("\n\n"); end >= 0; end = text.indexOf("\n\n")) {
      const event = parseEvent(text.slice(0, end));
      text = text.slice(end + 2);
      if (!event) continue;
      if (event.id) last = event.id;
      onEvent(event);
    }
  }
}

/** Calls `onEvent` for each event of a scene and reconnects as needed, until `stop` aborts or the scene is removed. */
export async function followEvents(id: string, onEvent: EventHandler, stop: AbortSignal) {
  let last = "";
  for (let tries = 0; !stop.aborted; ++tries) {
    const attempt = new AbortController();
    const abortAttempt = () => attempt.abort();
    stop.addEventListener("abort", abortAttempt);
    let timer = 0;
    const onData = () => {
      clearTimeout(timer);
      timer = window.setTimeout(abortAttempt, idle_timeout_ms);
    };
    try {
      onData();
      const answer = await call(`${scenePath(id)}/events`, {headers: {Accept: "text/event-stream", ...(last ? {"Last-Event-ID": last} : {})}, signal: attempt.signal});
      connected.value = true;
      offline.value = false;
      tries = 0;
      last = await readStream(answer.body!, last, (event) => { last = event.id || last; onEvent(event); }, onData);
    } catch (error) {
      if (error instanceof Refusal && error.status === 404) { onEvent({id: "", name: "removed", data: "{}"}); return; }
      if (!(error instanceof Refusal) && !(error instanceof Aborted)) offline.value = true;
    } finally {
      clearTimeout(timer);
      stop.removeEventListener("abort", abortAttempt);
      connected.value = false;
    }
    if (!stop.aborted) await new Promise((wake) => setTimeout(wake, retry_ms[Math.min(tries, retry_ms.length - 1)]));
  }
}
