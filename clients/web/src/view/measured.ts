// What pictures of each stop of the dial took in this window, and how far the server estimates them from the truth.
import {signal} from "@preact/signals";
import type {Picture} from "../api/client";
import type {Tier} from "../api/types";
import type {Stage} from "./frames";
import type {Dial} from "./quality";

export type Stop = Tier | "budget" | "error";
/** What artists call them. */
export const stopNames: Record<Stop, string> = {draft: "Sketch", interactive: "Groom", detailed: "Beauty", reference: "Final", budget: "In time", error: "True enough"};
export interface Measure {
  /** Of the newest picture that was drawn whole; null before there is one. */
  milliseconds: number | null;
  /** Mean FLIP where there is fur; null where the calibration does not know these knobs. */
  error: number | null;
  /** Of traced pictures: estimated mean error of a shown channel. */
  noise: number | null;
  samples: number;
}

export const measured = signal<Partial<Record<Stop, Measure>>>({});

export function millisecondsOf({timings}: Picture): number {
  const {draw = 0, upload = 0, read = 0, encode = 0, trace = 0} = timings;
  return draw + upload + read + encode + trace;
}

/** "60 ms", "3.2 s", "4 min" */
export function durationOf(milliseconds: number): string {
  if (milliseconds < 1000) return `${Math.round(milliseconds)} ms`;
  return milliseconds < 60000 ? `${Number((milliseconds / 1000).toPrecision(2))} s` : `${Math.round(milliseconds / 60000)} min`;
}

export const stopOf = (dial: Dial): Stop => (dial.kind === "tier" ? dial.tier : dial.kind);

function stopShown(stage: Exclude<Stage, "turning">, dial: Dial): Stop {
  if (stage === "draft") return "draft";
  const stop = stopOf(dial);
  return stage === "rest" && stop === "reference" ? "detailed" : stop;  // what is seen until the first strands come
}

/** Takes note of a picture that was asked for while the dial stood so. */
export function note(stage: Stage, dial: Dial, picture: Picture) {
  if (stage === "turning") return;  // a stop of its own on no dial
  const {trace, estimate} = picture;
  if (stage === "traced" && trace && trace.passes > 0) {
    const entry = {milliseconds: trace.grow_ms + trace.trace_ms, error: null, noise: trace.noise, samples: trace.samples};
    measured.value = {...measured.value, reference: entry};
    return;
  }
  if (stage === "traced") return;
  const stop = stopShown(stage, dial);
  const before = measured.value[stop]?.milliseconds ?? null;
  const milliseconds = picture.redrawn < 1 ? before : millisecondsOf(picture);  // cached or partly drawn pictures say nothing
  measured.value = {...measured.value, [stop]: {milliseconds, error: estimate?.error ?? null, noise: null, samples: 0}};
}
