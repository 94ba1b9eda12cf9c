// What the hand holds: the tool, its settings and the brush. Kept in this browser.
import {computed, signal} from "@preact/signals";
import {kept} from "../api/identity";
import type {Command, Op} from "../api/types";
import {edit_layer, scene} from "../scene/session";
import {brush_members, ownStrength, schemaOf, toolOf} from "./catalogue";
import {forbidden, type Member} from "./schema";

export type Values = Record<string, unknown>;

export const current = kept<Op>("tool", "comb");
/** What was set by hand, by tool; the rest is as the contract's defaults say. */
export const set_values = kept<Partial<Record<Op, Values>>>("tool-values", {});
export const set_brush = kept<Values>("brush", {radius: 0.08});
/** Held keys: Ctrl inverts, Shift smooths. */
export const inverting = signal(false);
export const smoothing = signal(false);

/** The tool that a dab would use now. */
export const in_hand = computed<Op>(() => (smoothing.value ? "smooth" : current.value));

/** Settings to begin with whose first stroke is plainly seen, where the contract's are gentle. */
const starts: Partial<Record<Op, Values>> = {
  trim: {height: 0.012}, paint: {field: "tip_colour", colour: "#fff1d6"}, length: {mode: "scale", value: 2}, smooth: {passes: 12},
  noise: {amount: 0.6, fields: ["direction", "length"]}, unify: {mean: ["direction", "length"]}, clump: {amount: 0.9}, comb: {lean: 0.8},
};
const valueOf = (member: Member, set: Values) => set[member.name] ?? member.fallback;

/** Values of all members that have one. */
export function valuesOf(op: Op): Values {
  const set = {...starts[op], ...set_values.value[op]};
  return Object.fromEntries((toolOf(op)?.members ?? []).map((member) => [member.name, valueOf(member, set)]).filter(([, value]) => value !== undefined));
}

export const brush = computed<Values>(() =>
  Object.fromEntries(brush_members.value.map((member) => [member.name, valueOf(member, set_brush.value)])));

export function setValue(op: Op, name: string, value: unknown) {
  const others = toolOf(op)?.alternatives ?? [];
  const values: Values = {...starts[op], ...set_values.value[op]};
  if (others.includes(name)) for (const other of others) delete values[other];
  set_values.value = {...set_values.value, [op]: {...values, [name]: value}};
}

export function setBrush(name: string, value: unknown) {
  set_brush.value = {...set_brush.value, [name]: value};
}

/** Same text, same value: for settings that are plain JSON. */
const same = (a: unknown, b: unknown) => JSON.stringify(a) === JSON.stringify(b);

/** A command of the tool without its place: what differs from the defaults and what the contract's rules allow. */
export function commandOf(op: Op, by_hand: Values = {}): Command {
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
  const whole: Values = {op, ...command, ...by_hand};
  for (const name of forbidden(schemaOf(op), whole)) delete whole[name];
  if (edit_layer.value) whole["edit_layer"] = edit_layer.value;
  return whole as Command;
}

/** The brush as it is sent with a tool, with what differs from the defaults. */
export function brushOf(op: Op, invert: boolean): Values {
  const sent: Values = {};
  for (const member of brush_members.value) {
    const value = brush.value[member.name];
    if (!same(value, member.fallback)) sent[member.name] = value;
  }
  if (ownStrength(toolOf(op))) sent["strength"] = 1;
  if (invert) sent["invert"] = true;
  return sent;
}

/** The brush's radius in the model's unit at a point where one pixel covers `units_per_pixel`. */
export function worldRadius(units_per_pixel: number): number {
  const radius = Number(brush.value["radius"]);
  const units = brush.value["units"];
  if (units === "world") return radius;
  return units === "pixels" ? radius * units_per_pixel : radius * (scene.value?.size ?? 1);
}
