// The current tool, its settings and the brush; stored in this browser.
import {computed, signal} from "@preact/signals";
import {storedSignal} from "../api/identity";
import type {Command, Op, Symmetry} from "../api/types";
import {edit_layer, groomed_coat, scene, settings} from "../scene/session";
import {brush_members, ownStrength, schemaOf, toolOf} from "./catalogue";
import {forbidden, type Member} from "./schema";

export type Values = Record<string, unknown>;

export const current = storedSignal<Op>("tool", "comb");
/** The user's settings by tool; everything else has the contract's default. */
export const set_values = storedSignal<Partial<Record<Op, Values>>>("tool-values", {});
export const set_brush = storedSignal<Values>("brush", {radius: 0.08});
/** The brush alpha; `picture` is an id within the scene `scene`. */
export const alpha = signal<{label: string; scene: string; picture: string} | null>(null);
/** True if strokes are mirrored. This is a setting of the user interface, not of the scene. */
export const mirror = storedSignal("mirror", false);
/** How much strokes are steadied, [0, 1]. */
export const steadiness = storedSignal("steady", 0);
/** Set by held keys, or by buttons on touch screens: Ctrl inverts, Shift smooths. */
export const inverting = signal(false);
export const smoothing = signal(false);

const hasImages = ({planes, count = 1}: Symmetry) => planes.length > 0 || count > 1;
const scene_symmetry = computed<Symmetry>(() => settings.value?.symmetry ?? {planes: []});

/** The vertical plane through the model's middle that separates left and right. */
export const middle_plane = computed(() => {
  const {min, max} = scene.value?.bounds ?? {min: [0, 0, 0], max: [0, 0, 0]};
  return {point: [(Number(min[0]) + Number(max[0])) / 2, 0, 0], normal: [1, 0, 0]};
});

/** The symmetry of strokes: the scene's own, else the plane through the model's middle; none if `mirror` is off. */
export const hand_symmetry = computed<Symmetry>(() => {
  if (!mirror.value || !scene.value) return {planes: []};
  if (hasImages(scene_symmetry.value)) return scene_symmetry.value;
  return {planes: [middle_plane.value]};
});
/** The member `symmetry` that is sent with each command; empty if the command needs none. */
const symmetry_member = computed(() => (mirror.value || hasImages(scene_symmetry.value) ? {symmetry: hand_symmetry.value} : {}));

/** The tool that a stroke would use now. */
export const in_hand = computed<Op>(() => (smoothing.value ? "smooth" : current.value));

/** Initial settings that are stronger than the contract's defaults, so that a first stroke is clearly visible. */
const initial_values: Partial<Record<Op, Values>> = {
  trim: {height: 0.012}, paint: {field: "tip_colour", colour: "#fff1d6"}, length: {mode: "scale", value: 2}, smooth: {passes: 12},
  noise: {amount: 0.6, fields: ["direction", "length"]}, unify: {mean: ["direction", "length"]}, clump: {amount: 0.9}, comb: {lean: 0.8}, flow: {sigma: 0.08, reach: 0.15}, interpolate: {sigma: 0.08, reach: 0.15},
};
const valueOf = (member: Member, set: Values) => set[member.name] ?? member.fallback;

/** Returns the values of all members that have one. */
export function valuesOf(op: Op): Values {
  const set = {...initial_values[op], ...set_values.value[op]};
  return Object.fromEntries((toolOf(op)?.members ?? []).map((member) => [member.name, valueOf(member, set)]).filter(([, value]) => value !== undefined));
}

export const brush = computed<Values>(() =>
  Object.fromEntries(brush_members.value.map((member) => [member.name, valueOf(member, set_brush.value)])));

export function setValue(op: Op, name: string, value: unknown) {
  const others = toolOf(op)?.alternatives ?? [];
  const values: Values = {...initial_values[op], ...set_values.value[op]};
  if (others.includes(name)) for (const other of others) delete values[other];
  set_values.value = {...set_values.value, [op]: {...values, [name]: value}};
}

export function setBrush(name: string, value: unknown) {
  set_brush.value = {...set_brush.value, [name]: value};
}

/** Compares plain JSON values by their text. */
const same = (a: unknown, b: unknown) => JSON.stringify(a) === JSON.stringify(b);

/** Returns a command of the tool without a stroke. It has the members that differ from the defaults and that the contract's
 * rules allow. */
export function commandOf(op: Op, overrides: Values = {}): Command {
  const tool = toolOf(op);
  const command: Values = {};
  const values = valuesOf(op);
  for (const member of tool?.members ?? []) {
    const value = values[member.name];
    if (value !== undefined && value !== "" && (member.required || !same(value, member.fallback))) command[member.name] = value;
  }
  if (ownStrength(tool)) command["strength"] = brush.value["strength"];
  const chosen = tool?.alternatives.filter((name) => command[name] !== undefined) ?? [];
  for (const extra of chosen.slice(1)) delete command[extra];
  const full_command: Values = {op, ...command, ...overrides};
  for (const name of forbidden(schemaOf(op), full_command)) delete full_command[name];
  if (edit_layer.value) full_command["edit_layer"] = edit_layer.value;
  if (groomed_coat.value) full_command["coats"] = [groomed_coat.value];
  if (!full_command["brush"] && "symmetry" in symmetry_member.value) full_command["brush"] = symmetry_member.value;
  return full_command as Command;
}

/** Returns the brush to send with a tool: the members that differ from the defaults. */
export function brushOf(op: Op, invert: boolean): Values {
  const sent: Values = {...symmetry_member.value};
  for (const member of brush_members.value) {
    const value = brush.value[member.name];
    if (!same(value, member.fallback)) sent[member.name] = value;
  }
  if (alpha.value && alpha.value.scene === scene.value?.id) sent["alpha"] = alpha.value.picture;
  if (ownStrength(toolOf(op))) sent["strength"] = 1;
  if (invert) sent["invert"] = true;
  return sent;
}

/** Returns the number of pixels for a brush radius of 1, where a pixel covers `units_per_pixel` model units. */
export function brushScale(units_per_pixel: number): number {
  const units = brush.value["units"];
  if (units === "pixels") return 1;
  return (units === "world" ? 1 : scene.value?.size ?? 1) / units_per_pixel;
}

/** Returns the brush's radius in model units at a point where a pixel covers `units_per_pixel`. */
export function worldRadius(units_per_pixel: number): number {
  const radius = Number(brush.value["radius"]), units = brush.value["units"];
  if (units === "world") return radius;
  return radius * (units === "pixels" ? units_per_pixel : scene.value?.size ?? 1);
}
