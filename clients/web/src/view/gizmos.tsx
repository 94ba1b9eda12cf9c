// Handles in the picture for named blowers, attractors, lights and eyes.
import {signal, useSignal} from "@preact/signals";
import type {Command, Settings, Vector} from "../api/types";
import {eyes as live_eyes, lights as live_lights} from "../scene/live_setting";
import {movedEye, sunk_share} from "../scene/eyes";
import {run, scene, settings} from "../scene/session";
import {current} from "../tools/state";
import {add, dot, norm, scale, subtract, unit} from "./vector";
import {axes} from "./camera";
import {Handle} from "./handle";
import {projectionNow, seen_orbit, skinAt} from "./surface";

/** True while the light panel is open, which shows the handles of lights. */
export const shows_lights = signal(false);
/** Index of the light that the panel shows. */
export const chosen_light = signal(0);

interface Gizmo {
  name: string;
  shape: "dot" | "arrow" | "light" | "star";
  at: Vector;
  /** The other end of the line that is drawn from it. */
  to?: Vector;
  /** Returns the command that moves it; it runs once the drag ends. */
  moved?: (to: Vector) => Command;
  /** Moves it during the drag, too; replaces `moved`. */
  live?: (to: Vector, done: boolean) => void;
  positionAt?: (x: number, y: number) => Vector;
  chosen?: boolean;
  text?: string;
  pressed?: () => void;
}

const replaced = <T,>(list: readonly T[], index: number, change: Partial<T>): T[] => list.map((one, k) => (k === index ? {...one, ...change} : one));

function blowers(all: Settings): Gizmo[] {
  const reach = (scene.value?.size ?? 1) * 0.25;
  return all.blowers.flatMap((blower, k) => {
    const source = (blower.source ?? [0, 0, 0]) as Vector;
    const aim = add(source, scale(unit((blower.direction ?? [0, -1, 0]) as Vector), reach));
    const command = (change: Partial<typeof blower>): Command => ({op: "set_blowers", blowers: replaced(all.blowers, k, change)});
    return [
      {name: `Blower ${blower.name}`, shape: "arrow" as const, at: source, to: aim, moved: (to: Vector) => command({source: to})},
      {name: `Where ${blower.name} blows`, shape: "dot" as const, at: aim, moved: (to: Vector) => command({direction: subtract(to, source)})},
    ];
  });
}

function attractors(all: Settings): Gizmo[] {
  return all.attractors.map((attractor, k) => ({
    name: `Attractor ${attractor.name}`, shape: "star" as const, at: (attractor.point ?? [0, 0, 0]) as Vector,
    moved: (to: Vector): Command => ({op: "set_attractors", attractors: replaced(all.attractors, k, {point: to})}),
  }));
}

/** Returns the sphere around the model on which the handles of directional lights lie. */
export function lightBall(): {middle: Vector; radius: number} | null {
  if (!scene.value) return null;
  const {min, max} = scene.value.bounds as {min: Vector; max: Vector};
  return {middle: scale(add(min, max), 0.5), radius: 0.4 * scene.value.size};
}

/** Intersects a pixel's ray with the sphere, on the side of the handle at `at`; if the ray misses, returns the nearest point
 * of the silhouette. */
function onBall(x: number, y: number, at: Vector, {middle, radius}: {middle: Vector; radius: number}): Vector {
  const {origin, direction} = projectionNow().ray(x, y);
  const along = dot(subtract(middle, origin), direction);
  const beside = subtract(add(origin, scale(direction, along)), middle);
  const inside = radius * radius - dot(beside, beside);
  if (inside <= 0) return add(middle, scale(unit(beside), radius));
  const behind = norm(subtract(at, origin)) > norm(subtract(middle, origin));
  return add(origin, scale(direction, along + (behind ? 1 : -1) * Math.sqrt(inside)));
}

/** Returns the handles of lights. A directional light moves on a sphere around the model, the others move freely. A dragged
 * light is aimed at the model's middle. */
function lights(): Gizmo[] {
  const ball = lightBall(), list = live_lights.value.value;
  if (!ball || !list) return [];
  return list.map((light, k) => {
    const directional = (light.kind ?? "directional") === "directional";
    const from = add(ball.middle, scale(unit((light.direction ?? [0, -1, 0]) as Vector), -ball.radius));
    const at = directional ? from : ((light.position ?? [0, 0, 0]) as Vector);
    const live = (to: Vector, done: boolean) => {
      const turned = {direction: unit(subtract(ball.middle, to))};
      const next = replaced(list, k, directional ? turned : {position: to, ...(light.kind === "point" ? {} : turned)});
      live_lights.set(next, false);
      if (done) live_lights.set(next, true);
    };
    return {name: `Light ${k + 1}`, shape: "light" as const, text: String(k + 1), at, to: ball.middle, live, chosen: k === chosen_light.value, pressed: () => { chosen_light.value = k; },
            ...(directional ? {positionAt: (x: number, y: number) => onBall(x, y, at, ball)} : {})};
  });
}

/** True while the eyes panel is open, which shows the handles of eyes; and the index of the eye that it shows. */
export const shows_eyes = signal(false);
export const chosen_eye = signal(0);

/** Returns three handles for each eye: at its centre to move it over the skin, above it for its size, and in front of it
 * for its gaze. */
function eyes(): Gizmo[] {
  const list = live_eyes.value.value, size = scene.value?.size ?? 1;
  if (!list) return [];
  const above = axes(seen_orbit.value).up, projection = projectionNow();
  return list.flatMap((eye, k) => {
    const at = eye.position as Vector, radius = (eye.radius ?? 0.02) * size, name = `Eye ${k + 1}`;
    const gaze = unit((eye.look_at ? subtract(eye.look_at as Vector, at) : eye.gaze ?? [0, 0, 1]) as Vector);
    const apart = 20 * projection.unitsPerPixel(at);  // keeps the handles of a small eye apart
    const pressed = () => { chosen_eye.value = k; };
    const put = (change: Partial<typeof eye>, done: boolean) => live_eyes.set(movedEye(list, k, change), done);
    const moved = (to: Vector, done: boolean) => put({position: to}, done);
    const onSkin = (x: number, y: number) => { const hit = skinAt(x, y); return hit ? subtract(hit.point, scale(hit.normal, sunk_share * radius)) : at; };
    const turned = (to: Vector, done: boolean) => put({gaze: unit(subtract(to, at))}, done);
    const sized = (to: Vector, done: boolean) => put({radius: Math.min(0.2, Math.max(0.002, (norm(subtract(to, at)) - apart) / size))}, done);
    const chosen = k === chosen_eye.value;
    return [
      {name, shape: "dot" as const, at, live: moved, positionAt: onSkin, pressed, chosen},
      {name: `Size of eye ${k + 1}`, shape: "star" as const, at: add(at, scale(above, radius + apart)), live: sized, pressed},
      ...(eye.look_at ? [] : [{name: `Where eye ${k + 1} looks`, shape: "arrow" as const, at: add(at, scale(gaze, 3 * radius + 2 * apart)), to: at, live: turned, pressed}]),
    ];
  });
}

export function Gizmos() {
  const dragged = useSignal<{name: string; to: Vector} | null>(null);
  const all = settings.value;
  if (!all) return null;
  const placed = current.value === "blow" || current.value === "attract" ? [...blowers(all), ...attractors(all)] : [];
  const shown = [...placed, ...(shows_lights.value ? lights() : []), ...(shows_eyes.value ? eyes() : [])];
  if (shown.length === 0) return null;
  const projection = projectionNow();
  return (
    <div class="handles">
      <svg class="gizmo-lines" aria-hidden="true">
        {shown.map(({name, at, to}) => {
          const [a, b] = [projection.project(dragged.value?.name === name ? dragged.value.to : at), to ? projection.project(to) : null];
          return a && b ? <line key={name} x1={a[0]} y1={a[1]} x2={b[0]} y2={b[1]} /> : null;
        })}
      </svg>
      {shown.map((gizmo) => (
        <Handle key={gizmo.name} at={dragged.value?.name === gizmo.name ? dragged.value.to : gizmo.at} shape={gizmo.shape} label={gizmo.name}
                chosen={gizmo.chosen ?? false} {...(gizmo.text ? {text: gizmo.text} : {})} {...(gizmo.positionAt ? {positionAt: gizmo.positionAt} : {})} {...(gizmo.pressed ? {pressed: gizmo.pressed} : {})}
                moved={(to, done) => {
                  if (gizmo.live) return gizmo.live(to, done);
                  dragged.value = {name: gizmo.name, to};
                  if (done) void run(gizmo.moved!(to)).then(() => { dragged.value = null; });
                }} />
      ))}
    </div>
  );
}
