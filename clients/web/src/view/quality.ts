// The dial's state: the quality of pictures at rest, from fast to accurate, or given by a budget.
import {computed, signal} from "@preact/signals";
import {storedSignal} from "../api/identity";
import type {FrameRequest, Tier} from "../api/types";
import {groomed_coat} from "../scene/session";
import {moment} from "./clock";
import {compared} from "./compared";

export type Dial = {kind: "tier"; tier: Tier} | {kind: "budget"; milliseconds: number} | {kind: "error"; error: number};

export const dial = storedSignal<Dial>("dial", {kind: "tier", tier: "interactive"});
/** True if strands are traced after the picture has rested. */
export const trace_at_rest = storedSignal("trace-at-rest", true);
/** Members of the frame request that apply to every picture. */
export const overlay = storedSignal<NonNullable<FrameRequest["overlay"]>>("overlay", "none");
/** Revision that the overlay "difference" compares with; without it, that overlay is off. Not stored, because it belongs to
 * this scene. */
export const overlay_from = signal<number | null>(null);
export const background = storedSignal<string>("background", "studio");
export const exposure = storedSignal("exposure", 0);
/** True if only what the mask leaves editable is drawn and touched. Not stored. */
export const masked = signal(false);

export const rest_quality = computed<Partial<FrameRequest>>(() => {
  const chosen = dial.value;
  if (chosen.kind === "budget") return {budget_ms: chosen.milliseconds};
  if (chosen.kind === "error") return {max_error: chosen.error};
  return {quality: chosen.tier === "reference" ? "detailed" : chosen.tier};
});

const overlay_request = computed<Partial<FrameRequest>>(() => {
  if (overlay.value !== "difference") return {overlay: overlay.value, ...(overlay.value !== "none" && groomed_coat.value ? {overlay_coat: groomed_coat.value} : {})};
  return overlay_from.value === null ? {overlay: "none"} : {overlay: "difference", overlay_from: overlay_from.value};
});

/** The members that all requests of this window share, without the overlay. */
export const plain_request = computed<Partial<FrameRequest>>(() => ({
  background: background.value as NonNullable<FrameRequest["background"]>, exposure: exposure.value, ...(masked.value ? {masked: true} : {}),
  ...(moment.value === null ? {} : {time: moment.value}),
}));
export const shared_request = computed<Partial<FrameRequest>>(() => ({...plain_request.value, ...overlay_request.value}));

/** True if strands are traced after a rest, which the dial's stop "reference" always does. Off with budgets; with overlays,
 *  which show fields; and beside an earlier revision, which is not traced, so that the two pictures would differ. */
export const wants_trace = computed(() => shared_request.value.overlay === "none" && compared.value === null && dial.value.kind === "tier" &&
  (trace_at_rest.value || dial.value.tier === "reference"));
