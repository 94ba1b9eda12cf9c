// Words to the user: what happened and what to do next.
import {signal} from "@preact/signals";
import {Aborted, Offline, Refusal} from "../api/client";

export interface Message { id: number; kind: "info" | "error"; text: string; next: string }

export const messages = signal<Message[]>([]);
let serial = 0;

export function dismiss(id: number) {
  messages.value = messages.value.filter((message) => message.id !== id);
}

/** What is said already is said once, for a while longer. */
export function say(text: string, next = "", kind: Message["kind"] = "info") {
  const id = ++serial;
  messages.value = [...messages.value.filter((message) => message.text !== text || message.next !== next).slice(-3), {id, kind, text, next}];
  setTimeout(() => dismiss(id), kind === "error" ? 12000 : 5000);
}

/** The words of an error; nothing of one that the outbox mends by itself. */
export function sayError(error: unknown) {
  if (error instanceof Aborted || error instanceof Offline) return;
  if (error instanceof Refusal) {
    const {pointer, limit, nearest} = error.problem;
    const parts = [pointer && `Field ${pointer}`, limit && `allowed: ${limit}`, nearest && `did you mean ${nearest}?`];
    return say(error.message, parts.filter(Boolean).join(", "), "error");
  }
  say(`Something went wrong: ${String((error as Error).message ?? error)}`, "Reload the page; your groom is on the server.", "error");
}
