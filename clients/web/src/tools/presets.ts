// Presets of settings by tool.
import {storedSignal} from "../api/identity";
import type {Op} from "../api/types";

export interface Preset { name: string; values: Record<string, unknown>; brush?: Record<string, unknown> }

/** The user's own presets by tool. */
export const saved = storedSignal<Partial<Record<Op, Preset[]>>>("presets", {});

export const presets: Partial<Record<Op, Preset[]>> = {
  comb: [
    {name: "Lay down", values: {lean: 0.85}, brush: {strength: 0.8}},
    {name: "Brush up", values: {lean: 0.35}, brush: {strength: 0.6}},
    {name: "Turn only", values: {keep_inclination: true}, brush: {strength: 0.8}},
  ],
  blow: [{name: "Breeze", values: {}, brush: {strength: 0.3}}, {name: "Dryer", values: {lean: 0.8}, brush: {radius: 0.12, strength: 0.8}}],
  length: [
    {name: "Short", values: {mode: "set", value: 0.015}}, {name: "Long", values: {mode: "set", value: 0.12}}, {name: "Flowing", values: {mode: "set", value: 0.22}},
    {name: "Grow", values: {mode: "scale", value: 1.15}}, {name: "Even out", values: {mode: "average"}},
  ],
  smooth: [{name: "Directions", values: {}}, {name: "Lengths too", values: {fields: ["direction", "length"]}}],
  noise: [{name: "A little life", values: {amount: 0.15, fields: ["direction"]}}, {name: "Tousled", values: {amount: 0.5, fields: ["direction", "length"]}}],
  paint: [
    {name: "Colour", values: {field: "tip_colour", colour: "#f2e6d8"}}, {name: "Root colour", values: {field: "root_colour", colour: "#4a2d1c"}},
    {name: "Thin out", values: {field: "density", value: 0}}, {name: "Wet", values: {field: "wetness", value: 1}}, {name: "Mask", values: {field: "mask", value: 0}},
  ],
  curl: [{name: "Wave", values: {amount: 0.3}}, {name: "Lamb", values: {amount: 1}}],
  unify: [{name: "Direction", values: {mean: ["direction"]}}, {name: "Length too", values: {mean: ["direction", "length"]}}],
};
