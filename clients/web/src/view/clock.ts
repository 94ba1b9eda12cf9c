// The moment that pictures show, where it is not the scene's own: for watching fur in the wind.
import {effect, signal, untracked} from "@preact/signals";
import {shown_model} from "../scene/session";

const tick = 40;  // ms between moments that are asked for; a server that draws slower skips some

/** Seconds; null for the scene's own time. */
export const moment = signal<number | null>(null);
export const playing = signal(false);

let timer = 0;

/** From a moment on, as fast as time passes. */
export function play(from: number) {
  const began = performance.now() - 1e3 * from;
  clearInterval(timer);
  playing.value = true;
  moment.value = from;
  timer = window.setInterval(() => { if (!document.hidden) moment.value = (performance.now() - began) / 1e3; }, tick);
}

/** The moment stays. */
export function pause() {
  clearInterval(timer);
  playing.value = false;
}

/** Back to the scene's own time. */
export function rewind() {
  pause();
  moment.value = null;
}

effect(() => { void shown_model.value; untracked(rewind); });
