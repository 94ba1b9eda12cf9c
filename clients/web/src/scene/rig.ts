// The lights of a scene as a photographer sets them: the first is the key, the second fills its shadows, the third is the rim.
import type {Settings, Vector} from "../api/types";
import {scale, unit} from "../view/vector";

export type Light = Settings["lights"][number];

export const rig_names = ["Key", "Fill", "Rim"] as const;
export const max_intensity = 3;

const three: Light[] = [
  {kind: "directional", direction: [-0.55, -0.75, -0.45], intensity: 1.15, colour: "#fff9f0", cast_shadow: "penumbra"},
  {kind: "directional", direction: [0.8, -0.25, -0.5], intensity: 0.35, colour: "#e7f1ff", cast_shadow: "none"},
  {kind: "directional", direction: [0.25, -0.45, 0.85], intensity: 0.6, cast_shadow: "penumbra"},
];

/** Whether the first three lights can be set as a rig. */
export const isRig = (lights: readonly Light[]) => lights.length >= three.length;
/** Three lights for a scene that has fewer. */
export const withRig = (lights: readonly Light[]): Light[] => three.map((light, k) => lights[k] ?? light);

export const intensityOf = (lights: readonly Light[], k: number) => Number(lights[k]?.intensity ?? 1);
export const withIntensity = (lights: readonly Light[], k: number, intensity: number): Light[] => lights.map((light, j) => (j === k ? {...light, intensity} : light));

const turnedAbout = ([x, y, z]: Vector, angle: number): Vector => [x * Math.cos(angle) + z * Math.sin(angle), y, z * Math.cos(angle) - x * Math.sin(angle)];

/** Where the key comes from, degrees around the model from the front. */
export function turnOf(lights: readonly Light[]): number {
  const [x, , z] = unit(scale((lights[0]?.direction ?? [0, -1, 0]) as Vector, -1));
  return Math.round((180 / Math.PI) * Math.atan2(x, z));
}

/** All lights turned together, so that the key comes from there. Those with a place stay where they are. */
export function withTurn(lights: readonly Light[], degrees: number): Light[] {
  const angle = ((degrees - turnOf(lights)) * Math.PI) / 180;
  return lights.map((light) => ((light.kind ?? "directional") === "directional" ? {...light, direction: turnedAbout((light.direction ?? [0, -1, 0]) as Vector, angle)} : light));
}
