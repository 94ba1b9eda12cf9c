// A scene setting that the user edits live: the displayed value changes at once, a copy of the scene previews it, and each
// finished change is one command. Commands are sent one at a time; of the changes made meanwhile only the last is sent.
import {computed, signal, type ReadonlySignal} from "@preact/signals";
import type {Command, Settings} from "../api/types";
import {coats, groomed_coat, scene, settings} from "./session";
import {commit, endTrial, tryOut} from "./trial";

const max_key_press_ms = 12;  // ms; a slider that moves and is released within this time was moved by a key
const key_settle_ms = 400;    // ms after the last key press until the command is sent

const same = (a: unknown, b: unknown) => JSON.stringify(a) === JSON.stringify(b);

export interface LiveSetting<T> {
  /** The displayed value; null before the scene is read. */
  value: ReadonlySignal<T | null>;
  /** `done` is false while it is dragged. */
  set: (next: T, done: boolean) => void;
}

export function liveSetting<T>(read: (all: Settings) => T, command: (value: T) => Command): LiveSetting<T> {
  const draft = signal<{scene: string; value: T} | null>(null);
  let drag_start = 0, timer = 0, sending = false, again = false;

  const stored = () => (settings.value ? read(settings.value) : null);
  const value = computed(() => (draft.value && draft.value.scene === scene.value?.id ? draft.value.value : stored()));

  async function send() {
    again = sending;
    if (sending) return;
    sending = true;
    do {
      again = false;
      const sent = draft.value;
      if (!sent || sent.scene !== scene.value?.id || same(sent.value, stored())) endTrial();
      else await commit(command(sent.value));
      if (draft.value === sent) draft.value = null;
    } while (again);
    sending = false;
  }

  function set(next: T, done: boolean) {
    if (!scene.value) return;
    draft.value = {scene: scene.value.id, value: next};
    clearTimeout(timer);
    if (!done) {
      drag_start ||= performance.now();
      return tryOut(command(next));
    }
    const by_key = drag_start > 0 && performance.now() - drag_start < max_key_press_ms;
    drag_start = 0;
    if (by_key) timer = window.setTimeout(() => void send(), key_settle_ms);
    else void send();
  }
  return {value, set};
}

/** Returns the coat that the tools work on, else the first. */
export const chosenCoat = () => coats().find(({name}) => name === groomed_coat.value) ?? coats()[0];
const named = () => (groomed_coat.value ? {name: groomed_coat.value} : {});

export const coat = liveSetting((all) => (chosenCoat() ?? all.coats[0]!).coat, (value) => ({op: "set_coat", coat: value, ...named()}));
export const look = liveSetting((all) => all.look, (value) => ({op: "set_look", look: value}));
export const lights = liveSetting((all) => all.lights, (value) => ({op: "set_lights", lights: value}));
export const environment = liveSetting((all) => all.environment, (value) => ({op: "set_environment", environment: value}));
export const ground = liveSetting((all) => all.ground, (value) => ({op: "set_ground", ground: value}));
export const wind = liveSetting((all) => all.wind, (value) => ({op: "set_wind", wind: value}));
export const eyes = liveSetting((all) => all.eyes, (value) => ({op: "set_eyes", eyes: value}));
