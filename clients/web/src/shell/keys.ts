// Keyboard shortcuts, as usual in sculpting programs. The sheet that ? opens is made from this table.
import type {Op} from "../api/types";
import {redo, undo} from "../scene/session";
import {toolNames} from "../tools/artist_words";
import {brush, current, inverting, mirror, setBrush, smoothing} from "../tools/state";
import {invertMask, toggleMask, toggleMasked} from "../panels/mask";
import {tools} from "../tools/catalogue";
import {adjusting} from "../view/adjust";
import {closePie, openPie} from "../view/pie_menu";
import {pending_pick} from "../view/surface";
import {focus, moveTo} from "../view/views";
import {dialog, panel} from "./ui_state";

interface Shortcut { keys: string; says: string; group: "Brush" | "Tools" | "View" | "Groom"; run: () => void }

const step = (name: string, factor: number, max: number) => {
  const value = Number(brush.value[name] ?? 0) * factor;
  setBrush(name, Math.min(max, Math.max(0.001, Number(value.toPrecision(3)))));
};
const hold = (op: Op) => () => { if (tools.value.some((tool) => tool.op === op)) current.value = op; };

export const toggleMirror = () => { mirror.value = !mirror.value; };

const tool_keys: [string, Op][] = [["C", "comb"], ["B", "blow"], ["P", "attract"], ["S", "smooth"], ["L", "length"], ["U", "lift"],
  ["T", "trim"], ["E", "erase"], ["N", "noise"], ["K", "clump"], ["W", "whorl"], ["D", "paint"], ["G", "flow"], ["I", "interpolate"]];
export const shortcutOf = (op: Op) => tool_keys.find(([, other]) => other === op)?.[0] ?? "";

export const shortcuts: Shortcut[] = [
  {keys: "[", says: "smaller brush", group: "Brush", run: () => step("radius", 1 / 1.15, 1)},
  {keys: "]", says: "larger brush", group: "Brush", run: () => step("radius", 1.15, 1)},
  {keys: "Shift+[", says: "weaker brush", group: "Brush", run: () => step("strength", 1 / 1.15, 1)},
  {keys: "Shift+]", says: "stronger brush", group: "Brush", run: () => step("strength", 1.15, 1)},
  {keys: "X", says: "mirror on or off", group: "Brush", run: toggleMirror},
  {keys: ".", says: "zoom to the point under the pointer", group: "View", run: focus},
  {keys: "Home", says: "show the whole model", group: "View", run: () => moveTo("three_quarter")},
  {keys: "1", says: "from the front", group: "View", run: () => moveTo("front")},
  {keys: "2", says: "from the right", group: "View", run: () => moveTo("right")},
  {keys: "3", says: "from behind", group: "View", run: () => moveTo("back")},
  {keys: "4", says: "from the left", group: "View", run: () => moveTo("left")},
  {keys: "5", says: "from above", group: "View", run: () => moveTo("top")},
  {keys: "Ctrl+Z", says: "undo", group: "Groom", run: () => void undo()},
  {keys: "Ctrl+Shift+Z", says: "redo", group: "Groom", run: () => void redo()},
  {keys: "M", says: "show or hide the mask", group: "Groom", run: toggleMask},
  {keys: "Shift+M", says: "hide or show what the mask protects", group: "Groom", run: toggleMasked},
  {keys: "Ctrl+I", says: "invert the mask", group: "Groom", run: invertMask},
  {keys: "H", says: "show the history", group: "Groom", run: () => { panel.value = "history"; }},
  {keys: "?", says: "show these shortcuts", group: "Groom", run: () => { dialog.value = dialog.value === "keys" ? null : "keys"; }},
  ...tool_keys.map(([keys, op]): Shortcut => ({keys, says: (toolNames[op] ?? op).toLowerCase(), group: "Tools", run: hold(op)})),
];

/** Returns the name of a pressed key as in the table. */
export function keysOf(event: KeyboardEvent): string {
  const braces: Record<string, string> = {"{": "[", "}": "]"};
  const key = event.key.length === 1 ? (braces[event.key] ?? event.key.toUpperCase()) : event.key;
  const shift = event.shiftKey && key !== "?" ? "Shift+" : "";
  return `${event.ctrlKey || event.metaKey ? "Ctrl+" : ""}${shift}${key}`;
}

const typing = (target: EventTarget | null) =>
  target instanceof HTMLElement && (target.isContentEditable || /^(INPUT|TEXTAREA|SELECT)$/.test(target.tagName) &&
    !["range", "checkbox", "button"].includes((target as HTMLInputElement).type));

/** Returns true for sliders, where Home goes to the slider's start. */
const ofSlider = (target: EventTarget | null) => target instanceof HTMLInputElement && target.type === "range";

/** Keys that act while they are held. */
const held_keys: Record<string, {down: () => void; up: () => void}> = {
  F: {down: () => { adjusting.value ??= smoothing.value ? "strength" : "radius"; }, up: () => { adjusting.value = null; }},
  " ": {down: openPie, up: closePie},
};
const heldOf = (event: KeyboardEvent) => (event.ctrlKey || event.metaKey || event.altKey ? undefined : held_keys[event.key.length === 1 ? event.key.toUpperCase() : event.key]);
const presses = (target: EventTarget | null) => target instanceof HTMLElement && target.closest("button, summary, [role=button], input") !== null;

function down(event: KeyboardEvent) {
  if (event.key === "Control" || event.key === "Meta") inverting.value = true;
  if (event.key === "Shift") smoothing.value = true;
  if (event.key === "Escape") { dialog.value = null; pending_pick.value = null; }
  if (typing(event.target)) return;
  const holds = presses(event.target) && event.key === " " ? undefined : heldOf(event);
  if (holds) { event.preventDefault(); return holds.down(); }
  const found = shortcuts.find((shortcut) => shortcut.keys === keysOf(event));
  if (!found || (event.key === "Home" && ofSlider(event.target))) return;
  event.preventDefault();
  found.run();
}

function up(event: KeyboardEvent) {
  if (event.key === "Control" || event.key === "Meta") inverting.value = false;
  if (event.key === "Shift") smoothing.value = false;
  held_keys[event.key.length === 1 ? event.key.toUpperCase() : event.key]?.up();
}

export function listenToKeys(): () => void {
  const stops = new AbortController();
  const released = () => {
    inverting.value = smoothing.value = false;
    for (const {up: leave} of Object.values(held_keys)) leave();
  };
  addEventListener("keydown", down, {signal: stops.signal});
  addEventListener("keyup", up, {signal: stops.signal});
  addEventListener("blur", released, {signal: stops.signal});
  return () => stops.abort();
}
