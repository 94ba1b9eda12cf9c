// Treats a scene's first three lights as a photographer's rig: key light, fill light, rim light.
import type {Settings, Vector} from "../api/types";
import {scale, unit} from "../view/vector";

export type Light = Settings["lights"][number];

export const rig_names = ["Key", "Fill", "Rim"] as const;
export const max_intensity = 3;

const default_rig: Light[] = [
  {kind: "directional", direction: [-0.55, -0.75, -0.45], intensity: 1.15, colour: "#fff9f0", cast_shadow: "penumbra"},
  {kind: "directional", direction: [0.8, -0.25, -0.5], intensity: 0.35, colour: "#e7f1ff", cast_shadow: "none"},
  {kind: "directional", direction: [0.25, -0.45, 0.85], intensity: 0.6, cast_shadow: "penumbra"},
];

/** Returns true if there are at least three lights, so that the first three are the rig. */
export const isRig = (lights: readonly Light[]) => lights.length >= default_rig.length;
/** Returns the three lights of the rig: the first ones given, and default lights in place of missing ones. */
export const withRig = (lights: readonly Light[]): Light[] => default_rig.map((light, k) => lights[k] ?? light);

export const intensityOf = (lights: readonly Light[], k: number) => Number(lights[k]?.intensity ?? 1);
export const withIntensity = (lights: readonly Light[], k: number, intensity: number): Light[] => lights.map((light, j) => (j === k ? {...light, intensity} : light));

const rotatedAboutY = ([x, y, z]: Vector, angle: number): Vector => [x * Math.cos(angle) + z * Math.sin(angle), y, z * Math.cos(angle) - x * Math.sin(angle)];

/** Returns the azimuth from which the key light comes, in degrees around the model, 0 at its front. */
export function turnOf(lights: readonly Light[]): number {
  const [x, , z] = unit(scale((lights[0]?.direction ?? [0, -1, 0]) as Vector, -1));
  return Math.round((180 / Math.PI) * Math.atan2(x, z));
}

/** Turns all directional lights together, so that the key light comes from the azimuth `degrees`. */
export function withTurn(lights: readonly Light[], degrees: number): Light[] {
  const angle = ((degrees - turnOf(lights)) * Math.PI) / 180;
  return lights.map((light) => ((light.kind ?? "directional") === "directional" ? {...light, direction: rotatedAboutY((light.direction ?? [0, -1, 0]) as Vector, angle)} : light));
}
