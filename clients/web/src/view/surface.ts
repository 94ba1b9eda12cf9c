// Finds what lies under the pointer in the picture on the screen: the skin, and the fur that a brush there would touch.
import {computed, effect, signal, untracked} from "@preact/signals";
import type {Vector} from "../api/types";
import {mark} from "../scene/marks";
import {sayError} from "../scene/messages";
import {isOpen, model_id, revision, scene, shown_model} from "../scene/session";
import {worldRadius} from "../tools/state";
import {backward, orbit, Projection, type Orbit} from "./camera";
import {shown} from "./frames";
import {masked} from "./quality";
import type {Hit, Proxy} from "./proxy";
import {add, scale} from "./vector";

/** Size of the picture in CSS pixels. */
export const viewport_size = signal({width: 1, height: 1});
/** The copy of the model for ray casting; null until it is loaded. */
export const proxy = signal<Proxy | null>(null);
/** The point that the brush would touch; null beside the model. */
export const hover = signal<Hit | null>(null);
/** Set while a panel waits for the next press on the model, to get a position. */
export const pending_pick = signal<{says: string; take: (hit: Hit, pixel: [number, number]) => void} | null>(null);

/** The camera of the picture on the screen; overlays use it, so that they stay aligned with the picture. */
export const seen_orbit = computed<Orbit>(() => shown.value?.orbit ?? orbit.value);
export const projectionNow = () => new Projection(seen_orbit.value, viewport_size.value.width, viewport_size.value.height);

/** Returns the point of the skin under a pixel. */
export function skinAt(x: number, y: number): Hit | null {
  const {origin, direction} = projectionNow().ray(x, y);
  return proxy.value?.cast(origin, direction) ?? null;
}

const directions = 12;
const radius_fractions = [0.4, 0.75, 1];  // fractions of the brush's radius at which furAt() looks

/** Returns the point that the brush touches at a pixel: on the fur there; else, if the brush reaches fur beside the pixel,
 * the point of the pixel's ray at that fur's distance. */
export function furAt(x: number, y: number): Hit | null {
  const projection = projectionNow(), model = proxy.value;
  if (!model) return null;
  const cast = (dx: number, dy: number) => {
    const {origin, direction} = projection.ray(x + dx, y + dy);
    return model.touch(origin, direction);
  };
  const hit = cast(0, 0);
  if (hit) return hit;
  const pixel = projection.unitsPerPixel(seen_orbit.value.target);
  const radius = worldRadius(pixel) / pixel;
  for (const fraction of radius_fractions) {
    for (let k = 0; k < directions; ++k) {
      const angle = (2 * Math.PI * k) / directions;
      const beside = cast(fraction * radius * Math.cos(angle), fraction * radius * Math.sin(angle));
      if (beside) return hitInAir(projection.ray(x, y), beside);
    }
  }
  return null;
}

function hitInAir({origin, direction}: {origin: Vector; direction: Vector}, beside: Hit): Hit {
  return {point: add(origin, scale(direction, beside.distance)), normal: backward(seen_orbit.value), distance: beside.distance};
}

let wanted_model = "";  // the scene and model to load into `proxy`

async function load(id: string): Promise<void> {
  const of = wanted_model;
  try {
    const {Proxy} = await import("./proxy");
    const loaded = await Proxy.load(id, masked.peek());
    if (of !== wanted_model) return;
    if (loaded.masked !== masked.peek()) return void load(id);
    proxy.value = loaded;
    mark("proxy", {at: performance.now(), revision: loaded.revision});
  } catch (error) {
    if (of === wanted_model && isOpen(id)) sayError(error);
  }
}

const reload_delay = 250;  // ms without a new revision before the fur is read again

/** Reloads the proxy when the model changes and after each change of the groom. */
export function followModel(): () => void {
  let timer = 0, last_model = "";
  const stop = effect(() => {
    const [now, model, id, newest, only_masked] = [shown_model.value, model_id.value, scene.value?.id, revision.value, masked.value];
    untracked(() => {
      clearTimeout(timer);
      if (model !== last_model) {
        proxy.value = null;  // the old model must not be found under the pointer
        masked.value = false;
      }
      last_model = model;
      if (!id) return;
      if (now !== wanted_model) {
        wanted_model = now;
        void load(id);
      } else if (proxy.value && only_masked !== proxy.value.masked) {
        void load(id);
      } else if (newest !== proxy.value?.revision) {
        timer = window.setTimeout(() => void load(id), reload_delay);
      }
    });
  });
  return () => { clearTimeout(timer); stop(); };
}
