// Named blowers, attractors and placed lights as handles in the picture.
import {useSignal} from "@preact/signals";
import type {Command, Settings, Vector} from "../api/types";
import {run, scene, settings} from "../scene/session";
import {current} from "../tools/state";
import {signal} from "@preact/signals";
import {add, scale, subtract, unit} from "./vector";
import {Handle, projectionNow} from "./handle";

/** Whether the panel of lights is open, which shows their handles. */
export const shows_lights = signal(false);

interface Gizmo {
  name: string;
  shape: "dot" | "arrow" | "light" | "star";
  at: Vector;
  /** The other end of its line. */
  to?: Vector;
  /** The command that puts it there. */
  moved: (to: Vector) => Command;
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

/** A directional light is dragged on a ball about the model; the others have a place. */
function lights(all: Settings): Gizmo[] {
  if (!scene.value) return [];
  const {min, max} = scene.value.bounds as {min: Vector; max: Vector};
  const middle = scale(add(min, max), 0.5);
  return all.lights.map((light, k) => {
    const directional = (light.kind ?? "directional") === "directional";
    const from = add(middle, scale(unit((light.direction ?? [0, -1, 0]) as Vector), -0.62 * scene.value!.size));
    const command = (to: Vector): Command => {
      const turned = {direction: subtract(middle, to)};
      return {op: "set_lights", lights: replaced(all.lights, k, directional ? turned : {position: to, ...(light.kind === "point" ? {} : turned)})};
    };
    return {name: `Light ${k + 1}`, shape: "light" as const, at: directional ? from : ((light.position ?? [0, 0, 0]) as Vector), to: middle, moved: command};
  });
}

export function Gizmos() {
  const dragged = useSignal<{name: string; to: Vector} | null>(null);
  const all = settings.value;
  if (!all) return null;
  const placed = current.value === "blow" || current.value === "attract" ? [...blowers(all), ...attractors(all)] : [];
  const shown = [...placed, ...(shows_lights.value ? lights(all) : [])];
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
                moved={(to, done) => {
                  dragged.value = {name: gizmo.name, to};
                  if (done) void run(gizmo.moved(to)).then(() => { dragged.value = null; });
                }} />
      ))}
    </div>
  );
}
