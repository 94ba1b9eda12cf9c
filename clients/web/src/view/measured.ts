// The measured time of pictures at each stop of the dial in this window, and their error as the server estimates it.
import {signal} from "@preact/signals";
import type {Picture} from "../api/client";
import type {Tier} from "../api/types";
import type {Stage} from "./frames";
import type {Dial} from "./quality";

export type Stop = Tier | "budget" | "error";
/** Artists' names for the stops. */
export const stopNames: Record<Stop, string> = {draft: "Sketch", interactive: "Groom", detailed: "Beauty", reference: "Final", budget: "Time limit", error: "Error limit"};
export interface Measure {
  /** Time of the newest picture that was drawn completely; null before there is one. */
  milliseconds: number | null;
  /** Mean FLIP over the fur; null if the calibration does not cover these knobs. */
  error: number | null;
  /** Estimated mean error of a displayed channel; null unless traced. */
  noise: number | null;
  samples: number;
}

export const measured = signal<Partial<Record<Stop, Measure>>>({});

export function millisecondsOf({timings}: Picture): number {
  const {draw = 0, upload = 0, read = 0, encode = 0, trace = 0} = timings;
  return draw + upload + read + encode + trace;
}

/** Returns text such as "60 ms", "3.2 s" or "4 min". */
export function durationOf(milliseconds: number): string {
  if (milliseconds < 1000) return `${Math.round(milliseconds)} ms`;
  return milliseconds < 60000 ? `${Number((milliseconds / 1000).toPrecision(2))} s` : `${Math.round(milliseconds / 60000)} min`;
}

export const stopOf = (dial: Dial): Stop => (dial.kind === "tier" ? dial.tier : dial.kind);

function stopShown(stage: Exclude<Stage, "turning">, dial: Dial): Stop {
  if (stage === "draft") return "draft";
  const stop = stopOf(dial);
  return stage === "rest" && stop === "reference" ? "detailed" : stop;  // shown until the first traced picture arrives
}

/** Records the measures of a picture that was requested with this dial. */
export function note(stage: Stage, dial: Dial, picture: Picture) {
  if (stage === "turning") return;  // drawn with a time budget, so no stop of the dial
  const {trace, estimate} = picture;
  if (stage === "traced" && trace && trace.passes > 0) {
    const entry = {milliseconds: trace.grow_ms + trace.trace_ms, error: null, noise: trace.noise, samples: trace.samples};
    measured.value = {...measured.value, reference: entry};
    return;
  }
  if (stage === "traced") return;
  const stop = stopShown(stage, dial);
  const before = measured.value[stop]?.milliseconds ?? null;
  const milliseconds = picture.redrawn < 1 ? before : millisecondsOf(picture);  // the time of a cached or partly drawn picture means little
  measured.value = {...measured.value, [stop]: {milliseconds, error: estimate?.error ?? null, noise: null, samples: 0}};
}
