// Goes to another state of the scene: by undo or redo if they lead there, so that redo keeps working as users expect; else
// by a revert, which is a step that can be undone.
import type {CommandAnswer, LogEntry} from "../api/types";
import {log, redo, revertTo, revision, scene, undo} from "./session";
import {first_revision, present, steps, type Step} from "./steps";

export type Route = {by: "undo" | "redo"; steps: number} | {by: "revert"} | null;
interface HistoryState { entries: LogEntry[]; steps: Step[]; undo_steps: number; redo_steps: number }

/** Returns how many undos lead to revision `to`, which is in effect or the first; 0 if undo does not lead there. */
function undosTo(to: number, history: HistoryState): number {
  const later = history.steps.filter((step) => step.in_effect && step.first > to);
  const oldest = later[0];
  // A revert among them is an undo step of its own, and undoing it leads elsewhere.
  if (!oldest || later.some((step) => step.kind !== "do") || history.steps.some((step) => step.kind === "revert" && step.first > oldest.first)) return 0;
  return later.length <= history.undo_steps ? later.length : 0;
}

/** Returns how many redos lead to revision `to`; 0 if redo does not lead there or the log does not tell. */
function redosTo(to: number, history: HistoryState): number {
  if (history.redo_steps === 0) return 0;
  const moves = (entry: LogEntry | undefined) => entry?.kind === "undo" || entry?.kind === "redo";
  let end = history.entries.length;
  while (moves(history.entries[end - 1])) --end;
  let begin = end;
  while (begin > 0 && !moves(history.entries[begin - 1])) --begin;
  const from = history.entries[begin]?.revision ?? Infinity;
  const until = history.entries[end - 1]?.revision ?? 0;
  // The steps before the latest undos and redos. An amendment and its replayed steps are one undo step.
  const undone = history.steps.filter((step) => step.first >= from && step.last <= until && step.kind !== "replay");
  const newer = undone.filter((step) => step.first > to).length;
  const there = undone.some((step) => step.last === to && history.steps[history.steps.indexOf(step) + 1]?.kind !== "replay");
  return there && newer < history.redo_steps ? history.redo_steps - newer : 0;
}

/** Returns how to go to the state at a revision; null if the scene is there already. */
export function routeTo(to: number, here: number, in_effect: boolean, history: HistoryState): Route {
  if (to === here) return null;
  const undos = in_effect ? undosTo(to, history) : 0;
  if (undos) return {by: "undo", steps: undos};
  const redos = in_effect ? 0 : redosTo(to, history);
  return redos ? {by: "redo", steps: redos} : {by: "revert"};
}

export async function goTo(to: number): Promise<CommandAnswer | null> {
  const open = scene.value;
  if (!open) return null;
  const first = first_revision.value;
  const step = steps.value.find(({last}) => last === to);
  const here = present.value?.last ?? first;
  const route = routeTo(to, here, step?.in_effect ?? to === first, {entries: log.value, steps: steps.value, undo_steps: open.undo_steps, redo_steps: open.redo_steps});
  if (!route || revision.value === to) return null;
  if (route.by === "revert") return revertTo(to);
  return route.by === "undo" ? undo(route.steps) : redo(route.steps);
}
