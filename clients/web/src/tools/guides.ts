// Guide curves and keys, which are drawn, moved and deleted on the model. Edits amend the step that laid them, so that
// moving a guide does not add steps.
import {signal} from "@preact/signals";
import type {Command, Vector} from "../api/types";
import {change, isOpen, log, log_read, refresh, run, scene} from "../scene/session";
import {norm, subtract} from "../view/vector";
import {commandOf, valuesOf} from "./state";

export type GuideOp = "flow" | "interpolate";
export interface Key { position: Vector; direction: Vector; inclination?: number; length?: number }
export type Guide = Vector[];

/** Indices of the guide and the point that are dragged or selected; -1 for none. */
export const chosen = signal<{guide: number; point: number}>({guide: -1, point: -1});
const max_points = 8;  // of a guide; more handles would be hard to grab

/** Returns the newest step in effect that laid guides of this kind. */
function stepOf(op: GuideOp): {revision: number; command: Command} | null {
  for (const entry of [...log.value].reverse()) {
    const command = entry.commands as unknown as Command | Command[] | undefined;
    if (entry.in_effect && command && !Array.isArray(command) && command.op === op) return {revision: entry.revision, command};
  }
  return null;
}

/** Returns the guides as curves; a key is a curve of two points. */
export function guidesOf(op: GuideOp): Guide[] {
  const command = stepOf(op)?.command;
  if (!command) return [];
  if (op === "flow") return command["curves"] as Guide[];
  return (command["keys"] as Key[]).map(({position, direction}) => [position, [0, 1, 2].map((k) => position[k]! + (direction?.[k] ?? 0)) as Vector]);
}

/** Returns the reach of new guides, in the model's unit. */
export function guideReach(op: GuideOp): number {
  const {reach, units} = valuesOf(op), size = scene.value?.size ?? 1;
  return typeof reach === "number" ? reach * (units === "world" ? 1 : size) : size;
}

/** Reduces a guide to `max_points`, evenly spaced by index. */
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

/** Replaces the guides by `next` of them. Edits run one after the other, each on the result of the previous one. */
function edit(op: GuideOp, next: (guides: Guide[]) => Guide[]): Promise<unknown> {
  const of = scene.value?.id ?? "";
  editing = editing.then(async () => {
    if (!log_read.value) await refresh();
    if (!isOpen(of)) return;  // the guides belong to the scene on which they were drawn
    const step = stepOf(op);
    const guides = next(guidesOf(op));
    const commands = guides.length ? [commandOf(op, membersFor(op, guides))] : [];
    if (step) await change("amend", {revision: step.revision, commands});
    else if (commands[0]) await run(commands[0]);
  });
  return editing;
}

/** Lays the existing guides again, with the form's current settings. */
export const layAgain = (op: GuideOp) => edit(op, (guides) => guides);
export const placeGuide = (op: GuideOp, points: Guide) => edit(op, (guides) => [...guides, points]);
export const removeGuide = (op: GuideOp, guide: number) => edit(op, (guides) => guides.filter((_, k) => k !== guide));

export function movePoint(op: GuideOp, guide: number, point: number, to: Vector) {
  return edit(op, (guides) => guides.map((points, k) => (k === guide ? points.map((old, j) => (j === point ? to : old)) : points)));
}
