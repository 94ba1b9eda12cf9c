// A wipe between an earlier revision and the current one: the earlier picture covers the current one up to a divider.
import {computed, effect, signal, untracked} from "@preact/signals";
import {useEffect, useRef} from "preact/hooks";
import {Aborted, Offline, Refusal, drawFrame} from "../api/client";
import {page_id} from "../api/identity";
import type {FrameRequest} from "../api/types";
import {sayError} from "../scene/messages";
import {scene, shown_model} from "../scene/session";
import {Icon} from "../tools/icons";
import {orbit, pinholeOf} from "./camera";
import {compared} from "./compared";
import {overlay, overlay_from, rest_quality, shared_request} from "./quality";
import {viewport_size} from "./surface";

const rest_after = 160;    // ms without movement until the full picture is requested
const again_after = 1000;  // ms until a retry after a lost connection or a full server
const max_ratio = 2;
const key_step = 2;        // percent
const large_key_step = 10;

/** Position of the divider, in percent from the left. */
const divide = signal(50);

let last_shared: FrameRequest = {};
/** The members of the request that both pictures share. Only the current picture shows the overlay "difference"; toggling it
 * returns the same object, so that the earlier picture is not drawn again. */
const past_shared = computed<FrameRequest>(() => {
  const {overlay_from: _from, ...shared} = shared_request.value;
  const wanted: FrameRequest = {...shared, overlay: shared.overlay === "difference" ? "none" : shared.overlay ?? "none"};
  if (JSON.stringify(wanted) !== JSON.stringify(last_shared)) last_shared = wanted;
  return last_shared;
});

/** Requests pictures of the earlier revision: drafts, one at a time, while the camera moves; the full picture at rest. */
class PastLoop {
  private state = 0;
  private drawn = -1;          // the state that the last full picture shows
  private draft_drawn = -1;
  private moved = 0;
  private timer = 0;
  private stop_ask: AbortController | null = null;
  private asks_rest = false;

  constructor(private readonly present: (bytes: Blob) => Promise<void>) {}

  touch() {
    ++this.state;
    this.moved = performance.now();
    if (this.asks_rest) this.stop_ask?.abort();
    void this.work();
  }

  stop() {
    clearTimeout(this.timer);
    this.state = this.drawn = this.draft_drawn = -1;
    this.stop_ask?.abort();
  }

  private later(milliseconds: number) {
    clearTimeout(this.timer);
    this.timer = window.setTimeout(() => void this.work(), milliseconds);
  }

  private async work() {
    if (this.stop_ask || this.state < 0 || this.drawn === this.state || document.hidden) return;
    const resting = performance.now() - this.moved;
    const rests = resting >= rest_after;
    if (!rests && this.draft_drawn === this.state) return this.later(rest_after - resting + 1);
    const state = this.state;
    this.stop_ask = new AbortController();
    this.asks_rest = rests;
    let pause = 0;
    try {
      await this.draw(rests, this.stop_ask.signal);
      if (rests) this.drawn = state;
      else this.draft_drawn = state;
    } catch (error) {
      pause = this.fail(error, state);
    }
    this.stop_ask = null;
    if (this.state >= 0) this.later(pause);
  }

  private async draw(rests: boolean, signal: AbortSignal) {
    const id = scene.value?.id;
    if (!id || !compared.value) return;
    const {width, height} = viewport_size.value;
    const ratio = rests ? Math.min(devicePixelRatio || 1, max_ratio) : 1;
    const request: FrameRequest = {
      ...past_shared.value, ...(rests ? rest_quality.value : {quality: "draft" as const, format: "jpeg" as const}),
      camera: pinholeOf(orbit.value), view: `${page_id}-past`, revision: compared.value.revision,
      width: Math.max(1, Math.round(width * ratio)), height: Math.max(1, Math.round(height * ratio)),
    };
    const picture = await drawFrame(id, request, null, signal);
    if (picture) await this.present(picture.bytes);
  }

  /** Returns the milliseconds until the next attempt. */
  private fail(error: unknown, state: number): number {
    if (error instanceof Aborted || (error instanceof Refusal && error.status === 409)) return 0;
    if (error instanceof Offline || (error instanceof Refusal && [429, 503].includes(error.status))) return again_after;
    sayError(error);
    this.drawn = this.draft_drawn = state;
    return 0;
  }
}

export function closeCompare() {
  compared.value = null;
  showChanges(false);
}

function showChanges(on: boolean) {
  if (on) {
    overlay_from.value = compared.value!.revision;
    overlay.value = "difference";
  } else if (overlay.value === "difference") {
    overlay.value = "none";
    overlay_from.value = null;
  }
}

function Divider() {
  const bar = useRef<HTMLDivElement>(null);
  const to = (share: number) => { divide.value = Math.max(0, Math.min(100, share)); };
  const move = (event: PointerEvent) => {
    if (!bar.current!.hasPointerCapture(event.pointerId)) return;
    const {left, width} = bar.current!.parentElement!.getBoundingClientRect();
    to(((event.clientX - left) / width) * 100);
  };
  const press = (event: KeyboardEvent) => {
    const step = event.shiftKey ? large_key_step : key_step;
    const target = {ArrowLeft: divide.value - step, ArrowRight: divide.value + step, ArrowDown: divide.value - step, ArrowUp: divide.value + step, Home: 0, End: 100}[event.key];
    if (target === undefined) return;
    event.preventDefault();
    event.stopPropagation();
    to(target);
  };
  const percent = Math.round(divide.value);
  return (
    <div class="compare-divider" ref={bar} role="slider" tabIndex={0} aria-label="Divider between earlier and now" aria-orientation="horizontal"
         aria-valuemin={0} aria-valuemax={100} aria-valuenow={percent} aria-valuetext={`${percent}% earlier`} style={{left: `${divide.value}%`}}
         onPointerDown={(event) => bar.current!.setPointerCapture(event.pointerId)} onPointerMove={move} onKeyDown={press} />
  );
}

function Header() {
  const {revision: from, label} = compared.value!;
  const changes = overlay.value === "difference" && overlay_from.value === from;
  return (
    <div class="compare-bar" role="group" aria-label="Compare">
      <span class="compare-side" title={label}>{label}</span>
      <span aria-hidden="true">|</span>
      <span>now</span>
      <button type="button" aria-pressed={changes} onClick={() => showChanges(!changes)}>Show what changed</button>
      <button type="button" class="quiet" aria-label="Close the comparison" onClick={closeCompare}><Icon sign="close" /></button>
    </div>
  );
}

function Past() {
  const canvas = useRef<HTMLCanvasElement>(null);
  useEffect(() => {
    const picture = canvas.current!.getContext("bitmaprenderer")!;
    const loop = new PastLoop(async (bytes) => {
      const bitmap = await createImageBitmap(bytes);
      canvas.current!.width = bitmap.width;
      canvas.current!.height = bitmap.height;
      picture.transferFromImageBitmap(bitmap);
    });
    const follow = effect(() => { void [compared.value, orbit.value, viewport_size.value, rest_quality.value, past_shared.value]; untracked(() => loop.touch()); });
    const wake = () => loop.touch();
    document.addEventListener("visibilitychange", wake);
    return () => {
      document.removeEventListener("visibilitychange", wake);
      follow();
      loop.stop();
    };
  }, []);
  return <canvas class="compare-past" ref={canvas} aria-hidden="true" style={{clipPath: `inset(0 ${100 - divide.value}% 0 0)`}} />;
}

/** Covers the picture but passes pointer input through to it, except on the divider and the header. */
export function Compare() {
  useEffect(() => closeCompare, [shown_model.value]);  // revisions belong to one scene and model
  if (!compared.value) return null;
  return <div class="compare"><Past /><Divider /><Header /></div>;
}
