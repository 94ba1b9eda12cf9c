// The user's name and the server's token, stored in this browser.
import {effect, signal} from "@preact/signals";

/** Returns a signal whose value is stored in this browser under `name`. */
export function storedSignal<T>(name: string, initial: T) {
  const key = `pelage.${name}`;
  let value = initial;
  try {
    const text = localStorage.getItem(key);
    if (text !== null) value = JSON.parse(text) as T;
  } catch {
    // an unreadable value counts as absent
  }
  const stored = signal(value);
  effect(() => {
    const text = JSON.stringify(stored.value);
    try { localStorage.setItem(key, text); } catch { /* the storage is full or forbidden: the value lasts until the page is closed */ }
  });
  return stored;
}

const animals = ["otter", "lynx", "marten", "hare", "badger", "fox", "stoat", "bear", "vole", "wolf", "deer", "yak"];

/** The user's name, recorded with each edit and shown to others. */
export const author = storedSignal("author", `${animals[Math.floor(Math.random() * animals.length)]} ${Math.floor(Math.random() * 90 + 10)}`);
/** Bearer token for a server that needs one; "" for none. */
export const token = storedSignal("token", "");
/** A random id of this page, different from those of all other open pages. */
export const page_id = crypto.getRandomValues(new Uint32Array(2)).join("-");

/** The refused token while the server asks for another one; else null. */
export const refused_token = signal<string | null>(null);

/** Waits until the user gives another token than `refused`; resolves with false if the user gives none. */
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
