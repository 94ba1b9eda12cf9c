// Messages to the user: what happened and what to do next.
import {signal} from "@preact/signals";
import {Aborted, Offline, Refusal} from "../api/client";
import {words} from "../tools/schema";

export interface Message { id: number; kind: "info" | "error"; text: string; next: string }

export const messages = signal<Message[]>([]);
let serial = 0;

export function dismiss(id: number) {
  messages.value = messages.value.filter((message) => message.id !== id);
}

/** Shows a message for a while. A message that is shown already is not repeated but stays longer. */
export function say(text: string, next = "", kind: Message["kind"] = "info") {
  const id = ++serial;
  messages.value = [...messages.value.filter((message) => message.text !== text || message.next !== next).slice(-3), {id, kind, text, next}];
  setTimeout(() => dismiss(id), kind === "error" ? 12000 : 5000);
}

/** Returns the name of the setting that a JSON pointer leads to. */
const settingOf = (pointer: string) => words(pointer.split("/").filter((part) => part && !/^\d+$/.test(part)).pop() ?? pointer);

/** Shows an error's message; nothing for an aborted request or a lost connection, which is retried. */
export function sayError(error: unknown) {
  if (error instanceof Aborted || error instanceof Offline) return;
  if (error instanceof Refusal) {
    const {pointer, limit, nearest} = error.problem;
    const parts = [pointer && `Setting: ${settingOf(pointer)}`, limit && `allowed: ${limit}`, nearest && `did you mean ${nearest}?`];
    return say(error.message, parts.filter(Boolean).join(", "), "error");
  }
  say(`Something went wrong: ${String((error as Error).message ?? error)}`, "Reload the page. Your groom is safe on the server.", "error");
}
