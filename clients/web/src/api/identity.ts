// Who sits here, and the server's token: kept in this browser.
import {effect, signal} from "@preact/signals";

/** A signal whose value is kept in this browser under `name`. */
export function kept<T>(name: string, initial: T) {
  const key = `pelage.${name}`;
  let value = initial;
  try {
    const text = localStorage.getItem(key);
    if (text !== null) value = JSON.parse(text) as T;
  } catch {
    // what cannot be read is as if it were not there
  }
  const held = signal(value);
  effect(() => {
    const text = JSON.stringify(held.value);
    try { localStorage.setItem(key, text); } catch { /* a full or forbidden store: it lasts for this page */ }
  });
  return held;
}

const animals = ["otter", "lynx", "marten", "hare", "badger", "fox", "stoat", "bear", "vole", "wolf", "deer", "yak"];

/** Shown beside edits; others see it. */
export const author = kept("author", `${animals[Math.floor(Math.random() * animals.length)]} ${Math.floor(Math.random() * 90 + 10)}`);
/** Bearer token of a server that needs one; "" for none. */
export const token = kept("token", "");
/** This page among all that are open. */
export const page_id = crypto.getRandomValues(new Uint32Array(2)).join("-");

/** The token that the server refused, while it wants another one; null when it wants none. */
export const refused_token = signal<string | null>(null);

/** Waits until another token than `refused` is given; false where whoever sits here gives none. */
export function otherToken(refused: string): Promise<boolean> {
  if (token.value !== refused) return Promise.resolve(true);
  refused_token.value = refused;
  return new Promise((done) => {
    const stop = refused_token.subscribe((wanted) => {
      if (wanted !== null) return;
      done(token.value !== refused);
      queueMicrotask(() => stop());
    });
  });
}
