// Guide curves and keys: drawn, moved and deleted on the model. The step of the log that laid them is amended, so that a guide
// is one thing however often it is moved.
import {signal} from "@preact/signals";
import type {Command, Vector} from "../api/types";
import {change, isOpen, log, log_read, refresh, run, scene} from "../scene/session";
import {norm, subtract} from "../view/vector";
import {commandOf, valuesOf} from "./state";

export type GuideOp = "flow" | "interpolate";
export interface Key { position: Vector; direction: Vector; inclination?: number; length?: number }
export type Guide = Vector[];

/** Guide and point that are dragged or chosen; -1 for none. */
export const chosen = signal<{guide: number; point: number}>({guide: -1, point: -1});
const max_points = 8;  // as many as a hand can take hold of

/** The newest step that laid guides of this kind and is still in effect. */
function stepOf(op: GuideOp): {revision: number; command: Command} | null {
  for (const entry of [...log.value].reverse()) {
    const command = entry.commands as unknown as Command | Command[] | undefined;
    if (entry.in_effect && command && !Array.isArray(command) && command.op === op) return {revision: entry.revision, command};
  }
  return null;
}

/** Guides as curves; a key is a curve of two points. */
export function guidesOf(op: GuideOp): Guide[] {
  const command = stepOf(op)?.command;
  if (!command) return [];
  if (op === "flow") return command["curves"] as Guide[];
  return (command["keys"] as Key[]).map(({position, direction}) => [position, [0, 1, 2].map((k) => position[k]! + (direction?.[k] ?? 0)) as Vector]);
}

/** How far guides that are laid now reach, in the model's unit. */
export function guideReach(op: GuideOp): number {
  const {reach, units} = valuesOf(op), size = scene.value?.size ?? 1;
  return typeof reach === "number" ? reach * (units === "world" ? 1 : size) : size;
}

/** Evenly thinned. */
function thinned(points: Guide): Guide {
  if (points.length <= max_points) return points;
  return Array.from({length: max_points}, (_, k) => points[Math.round((k * (points.length - 1)) / (max_points - 1))]!);
}

function membersFor(op: GuideOp, guides: Guide[]) {
  if (op === "flow") return {curves: guides.map(thinned)};
  return {keys: guides.map((guide): Key => ({position: guide[0]!, direction: subtract(guide[guide.length - 1]!, guide[0]!)}))
    .filter((key) => norm(key.direction) > 0)};
}

let editing: Promise<unknown> = Promise.resolve();

/** Lays other guides in place of those that are there; one edit after the other, each on what the one before left. */
function edit(op: GuideOp, next: (guides: Guide[]) => Guide[]): Promise<unknown> {
  const of = scene.value?.id ?? "";
  editing = editing.then(async () => {
    if (!log_read.value) await refresh();
    if (!isOpen(of)) return;  // guides are of the scene that they were drawn on
    const step = stepOf(op);
    const guides = next(guidesOf(op));
    const commands = guides.length ? [commandOf(op, membersFor(op, guides))] : [];
    if (step) await change("amend", {revision: step.revision, commands});
    else if (commands[0]) await run(commands[0]);
  });
  return editing;
}

/** The guides that are there, with the settings of the form. */
export const layAgain = (op: GuideOp) => edit(op, (guides) => guides);
export const placeGuide = (op: GuideOp, points: Guide) => edit(op, (guides) => [...guides, points]);
export const removeGuide = (op: GuideOp, guide: number) => edit(op, (guides) => guides.filter((_, k) => k !== guide));

export function movePoint(op: GuideOp, guide: number, point: number, to: Vector) {
  return edit(op, (guides) => guides.map((points, k) => (k === guide ? points.map((old, j) => (j === point ? to : old)) : points)));
}
