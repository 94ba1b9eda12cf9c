// Moves the camera to a view: smoothly, unless the user's system asks for reduced motion.
import type {AutoView} from "../api/types";
import {scene} from "../scene/session";
import {between, framed, orbit, type Orbit} from "./camera";
import {hover, viewport_size} from "./surface";
import {view} from "./viewport";

const glide_ms = 260;
let gliding = 0;

export function glide(to: Orbit, at_once: boolean) {
  cancelAnimationFrame(gliding);
  if (at_once || matchMedia("(prefers-reduced-motion: reduce)").matches) {
    orbit.value = to;
    view.value?.frames.touch();
    return;
  }
  const from = orbit.value, start = performance.now();
  const step = (now: number) => {
    const t = Math.min(1, Math.max(0, (now - start) / glide_ms));
    orbit.value = between(from, to, t * t * (3 - 2 * t));
    view.value?.frames.touch({turning: true});
    if (t < 1) gliding = requestAnimationFrame(step);
  };
  gliding = requestAnimationFrame(step);
}

export function moveTo(named: AutoView, at_once = false) {
  if (!scene.value) return;
  const {width, height} = viewport_size.value;
  glide(framed(scene.value, named, width / Math.max(height, 1)), at_once);
}

/** Makes the point under the pointer the target and moves closer by a factor of 1.6; without one, shows the whole model. */
export function focus() {
  const hit = hover.value;
  if (!hit) return moveTo("three_quarter");
  glide({...orbit.value, target: hit.point, distance: orbit.value.distance / 1.6}, false);
}
