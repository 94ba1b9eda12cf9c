// Decides which picture to request next: one with a short time budget while the camera moves, drafts of strokes and
// settings, the dial's quality at rest, and traced strands after a longer rest.
// At most two requests are in flight; the newest picture wins.
import {computed, signal} from "@preact/signals";
import {Aborted, Offline, Refusal, drawFrame, type FrameNews, type Picture} from "../api/client";
import {page_id} from "../api/identity";
import type {FrameRequest} from "../api/types";
import {mark} from "../scene/marks";
import {sayError} from "../scene/messages";
import {pinholeOf, type Orbit} from "./camera";
import {note} from "./measured";
import {Pace} from "./pace";
import {dial, rest_quality, shared_request, wants_trace, type Dial} from "./quality";

export type Stage = "turning" | "draft" | "rest" | "traced";
/** A picture on the screen. `state` is the value of `wanted` when it was requested, `orbit` its camera; `asked` and `shown`
 * are times in ms. */
export interface Shown { stage: Stage; state: number; orbit: Orbit; dial: Dial; picture: Picture; width: number; height: number; asked: number; shown: number }
export interface ViewState { scene: string; orbit: Orbit; width: number; height: number; ratio: number; revision: number }

const rest_after = 140;      // ms without movement until the picture at rest is requested
const turning_budget = 35;   // ms budget of a picture while the camera moves
const trace_after = 1200;    // ms after the picture at rest until tracing starts
const max_in_flight = 2;
const retry_delay = 1000;    // ms until a retry after a lost connection or a full server
const trace_wait = 20;       // s that a request waits for a better picture
const news_wait = 1;         // s that a draft waits until a sent part of a stroke arrives at the server

/** The picture on the screen. */
export const shown = signal<Shown | null>(null);
/** Counts the changes of what the picture should show. */
const wanted = signal(0);
/** True if the picture on the screen is out of date. */
export const outdated = computed(() => shown.value?.state !== wanted.value);
/** True if the picture at rest is on the screen; until something changes, the server has time for other pictures. */
export const resting = computed(() => !outdated.value && (shown.value?.stage === "rest" || shown.value?.stage === "traced"));
/** True if a better picture is coming: the current one is outdated or a draft, or its strands are still being traced. */
export const pending = computed(() => {
  const seen = shown.value;
  if (!seen || outdated.value || seen.stage === "turning" || seen.stage === "draft") return true;
  return wants_trace.value && (seen.stage === "rest" || seen.picture.trace?.end === "none");
});

const moving: Partial<FrameRequest> = {format: "jpeg"};
export const tracing = {passes: 64, noise: 0.004} satisfies FrameRequest["progressive"];

/** A request in flight. The server draws only the newest frame of a view, so each request uses a view of its own, by `slot`. */
interface InFlightRequest { number: number; scene: string; state: number; stage: Stage; orbit: Orbit; slot: number; dial: Dial; ratio: number; stop: AbortController }

export class FrameLoop {
  private asked = 0;
  private shown_number = 0;
  private done: Record<Stage, number> = {turning: -1, draft: -1, rest: -1, traced: -1};  // the state for which each stage is done
  private moving_until = 0;
  private turning_until = 0;
  private rested_at = 0;
  private blocked_until = 0;
  private passes = 0;
  private pace = new Pace();
  private news: number | null = null;  // the revision before the oldest part of a stroke that no draft was requested for
  private timer = 0;
  private pump_planned = false;
  private in_flight = new Set<InFlightRequest>();

  /** `view_state` returns what to draw, or null; `present` puts a picture on the screen. */
  constructor(private readonly view_state: () => ViewState | null, private readonly present: (picture: ImageBitmap, stage: Stage) => void) {}

  private get state() { return wanted.peek(); }

  /** Reports a change of what the picture should show. `moving`: more changes follow soon. `turning`: the camera moves.
   * `news`: a part of a stroke is on its way to the server. */
  touch({moving = false, turning = false, news = false} = {}) {
    wanted.value = this.state + 1;
    this.passes = 0;
    if (news) this.news ??= this.view_state()?.revision ?? null;
    if (moving || turning) this.moving_until = performance.now() + rest_after;
    if (turning) this.turning_until = this.moving_until;
    for (const request of this.in_flight) if (request.stage === "rest" || request.stage === "traced") request.stop.abort();
    this.pumpSoon();
  }

  /** Pumps once for all signals that change together, such as a scene and its first camera. */
  private pumpSoon() {
    if (this.pump_planned) return;
    this.pump_planned = true;
    queueMicrotask(() => {
      this.pump_planned = false;
      this.pump();
    });
  }

  /** Drops the picture and all requests, because they show another scene or model. */
  forget() {
    for (const request of this.in_flight) request.stop.abort();
    this.shown_number = this.asked + 1;
    shown.value = null;
  }

  stop() {
    clearTimeout(this.timer);
    for (const request of this.in_flight) request.stop.abort();
  }

  private pump() {
    clearTimeout(this.timer);
    const view_state = this.view_state();
    if (!view_state || document.hidden) return;
    const now = performance.now();
    const stage = now >= this.blocked_until ? this.nextStage(now) : null;
    if (stage) void this.request(stage, view_state);
    const later = Math.min(...[this.moving_until, this.rested_at + trace_after, this.blocked_until].filter((at) => at > now));
    if (Number.isFinite(later)) this.timer = window.setTimeout(() => this.pump(), later - now + 1);
  }

  private nextStage(now: number): Stage | null {
    const requests = [...this.in_flight];
    if (requests.length >= max_in_flight) return null;
    const isRequested = (stage: Stage) => requests.some((request) => request.stage === stage && request.state === this.state);
    if (now < this.turning_until) return this.done.turning === this.state || isRequested("turning") ? null : "turning";
    if (this.done.draft !== this.state) return isRequested("draft") ? null : "draft";
    if (now < this.moving_until) return null;
    if (this.done.rest !== this.state) return isRequested("rest") ? null : "rest";
    if (!wants_trace.value || this.done.traced === this.state || isRequested("traced")) return null;
    return now >= this.rested_at + trace_after ? "traced" : null;
  }

  private freeSlot(): number {
    const taken = [...this.in_flight].map(({slot}) => slot);
    return taken.includes(0) ? 1 : 0;
  }

  private async request(stage: Stage, view_state: ViewState) {
    const ratio = stage === "draft" ? this.pace.ratio : stage === "turning" ? 1 : view_state.ratio;
    const request: InFlightRequest = {number: ++this.asked, scene: view_state.scene, state: this.state, stage, orbit: view_state.orbit, slot: this.freeSlot(), dial: dial.value, ratio, stop: new AbortController()};
    this.in_flight.add(request);
    const asked = performance.now();
    try {
      const picture = await drawFrame(view_state.scene, this.requestOf(request, view_state), this.newsOf(stage, view_state), request.stop.signal);
      await this.receive(request, picture, asked);
    } catch (error) {
      this.fail(request, error);
    } finally {
      this.in_flight.delete(request);
      this.pump();
    }
  }

  private requestOf({stage, slot, ratio}: InFlightRequest, view_state: ViewState): FrameRequest {
    const size = {width: Math.max(1, Math.round(view_state.width * ratio)), height: Math.max(1, Math.round(view_state.height * ratio))};
    const request: FrameRequest = {...shared_request.value, ...size, camera: pinholeOf(view_state.orbit), view: `${page_id}-${stage === "traced" ? "traced" : slot}`};
    if (stage === "draft") return {...request, quality: "draft", ...moving};
    if (stage === "turning") return {...request, budget_ms: turning_budget, ...moving};
    if (stage === "traced") return {...request, ...rest_quality.value, progressive: tracing};
    return {...request, ...rest_quality.value};
  }

  private newsOf(stage: Stage, view_state: ViewState): FrameNews | null {
    if (stage === "traced") return {after: view_state.revision, after_pass: this.passes, wait: trace_wait};
    if (stage !== "draft") return null;
    const after = this.news;
    this.news = null;
    return after === view_state.revision ? {after, wait: news_wait} : null;  // else the part is there already
  }

  private async receive(request: InFlightRequest, picture: Picture | null, asked: number) {
    if (!picture) {
      if (request.stage === "draft") this.done.draft = request.state;
      return;
    }
    if (request.stage === "draft") this.pace.note(request.ratio, picture);
    if (request.number < this.shown_number) return;
    const answered = performance.now();
    const bitmap = await createImageBitmap(picture.bytes);
    if (request.number < this.shown_number || request.stop.signal.aborted) return bitmap.close();  // a newer one was decoded first
    this.shown_number = request.number;
    const {width, height} = bitmap;  // presenting the bitmap consumes it
    this.present(bitmap, request.stage);
    const now = performance.now();
    mark("frame", {scene: request.scene, stage: request.stage, revision: picture.revision, asked, answered, shown: now, timings: picture.timings});
    note(request.stage, request.dial, picture);
    shown.value = {stage: request.stage, state: request.state, orbit: request.orbit, dial: request.dial, picture, width, height, asked, shown: now};
    this.finish(request, picture, now);
  }

  private finish(request: InFlightRequest, picture: Picture, now: number) {
    if (request.stage === "rest") this.rested_at = now;
    if (request.stage !== "traced") { this.done[request.stage] = request.state; return; }
    this.passes = picture.trace?.passes ?? 0;
    if (picture.trace && picture.trace.end !== "none") this.done.traced = request.state;
  }

  /** Shows a refusal once and does not repeat the request until something changes; retries after a lost connection. */
  private fail(request: InFlightRequest, error: unknown) {
    if (error instanceof Aborted) return;
    if (error instanceof Offline || (error instanceof Refusal && [409, 429, 503].includes(error.status))) {
      this.blocked_until = performance.now() + retry_delay;
      return;
    }
    this.done[request.stage] = request.state;
    sayError(error);
  }
}
