// The time that pictures show in place of the scene's own, to watch fur in the wind.
import {effect, signal, untracked} from "@preact/signals";
import {shown_model} from "../scene/session";

const tick = 40;  // ms between requested times; a slower server skips some

/** Seconds; null for the scene's own time. */
export const moment = signal<number | null>(null);
export const playing = signal(false);

let timer = 0;

/** Plays from a time on, in real time. */
export function play(from: number) {
  const began = performance.now() - 1e3 * from;
  clearInterval(timer);
  playing.value = true;
  moment.value = from;
  timer = window.setInterval(() => { if (!document.hidden) moment.value = (performance.now() - began) / 1e3; }, tick);
}

/** Stops the clock and keeps its time. */
export function pause() {
  clearInterval(timer);
  playing.value = false;
}

/** Returns to the scene's own time. */
export function rewind() {
  pause();
  moment.value = null;
}

effect(() => { void shown_model.value; untracked(rewind); });
