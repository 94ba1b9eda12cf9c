// Groups the log's entries into steps: the parts of a stroke are joined, and an amendment has the steps that it replayed.
import {computed} from "@preact/signals";
import type {Command, LogEntry} from "../api/types";
import {log, revision, settings} from "./session";

export interface Step {
  kind: "do" | "replay" | "revert";
  /** Revisions: `first` and `last` of its entries; `before` is the state that it started from. */
  before: number;
  first: number;
  last: number;
  entries: LogEntry[];
  in_effect: boolean;
  author: string;
}

/** Returns the commands of an entry, one or a batch; none for undo, redo and revert. */
export function commandsIn(entry: LogEntry): Command[] {
  if (entry.commands === undefined) return [];
  const logged = entry.commands as unknown as Command | {commands: Command[]};
  return "commands" in logged ? (logged.commands as Command[]) : [logged];
}

function startStep(entry: LogEntry, kind: Step["kind"]): Step {
  const {revision: first, in_effect, author} = entry;
  return {kind, before: first - 1, first, last: first, entries: [entry], in_effect, author};
}

/** Returns the steps, oldest first. Undo and redo are no steps; they only change which steps are in effect. */
export function stepsOf(entries: LogEntry[]): Step[] {
  const steps: Step[] = [];
  for (const entry of entries) {
    const {kind} = entry;
    const newest = steps[steps.length - 1];
    if (kind === "join" && newest) {
      newest.entries.push(entry);
      newest.last = entry.revision;
    } else if (kind === "do" || kind === "replay" || kind === "revert") {
      steps.push(startStep(entry, kind));
    }
  }
  return steps;
}

export const steps = computed(() => stepsOf(log.value));
/** The revision before the first entry: the model without edits. */
export const first_revision = computed(() => (log.value[0] ? log.value[0].revision - 1 : revision.value));
/** The newest step in effect, which is the scene's current state; null if there is none. */
export const present = computed(() => steps.value.filter((step) => step.in_effect).pop() ?? null);

const is_stroke = (value: unknown): value is {samples: unknown[]} => typeof value === "object" && value !== null && "samples" in value;

/** Returns a command without the members that identify a part of a stroke. */
function withoutPartIds(command: Command): Command {
  const stroke = command["stroke"];
  if (!is_stroke(stroke)) return command;
  const {id: _id, part: _part, last: _last, ...rest} = stroke as unknown as Record<string, unknown>;
  return {...command, stroke: rest};
}

/** Returns a step's commands with the parts of a stroke joined: the parts have the same settings, so that concatenating
 * their samples gives the whole stroke. */
export function fullCommands(step: Step): Command[] {
  const [first, ...joined] = step.entries.map(commandsIn);
  const commands = (first ?? []).map(withoutPartIds);
  const stroke = commands[0]?.["stroke"];
  if (joined.length === 0 || !is_stroke(stroke)) return commands;
  const samples = [...stroke.samples];
  for (const part of joined) {
    const more = part[0]?.["stroke"];
    if (is_stroke(more)) samples.push(...more.samples);
  }
  return [{...commands[0]!, stroke: {...stroke, samples}}];
}

/** Returns the number of vertices that a step changed. The parts of a stroke overlap, so for several parts only a lower
 * bound is known. */
export function touchedBy(step: Step): {count: number; exact: boolean} {
  return {count: Math.max(...step.entries.map(({touched}) => touched)), exact: step.entries.length === 1};
}

/** Checkpoint names by revision, including revisions no longer in effect, which are still in the log. */
export const checkpoints = computed(() => {
  const named = new Map<string, number>();
  for (const entry of log.value) {
    for (const command of commandsIn(entry)) {
      if (command.op === "checkpoint") named.set(String(command["name"]), Number(command["revision"] ?? entry.revision));
    }
  }
  for (const {name, revision: at} of settings.value?.checkpoints ?? []) named.set(name, at);
  return [...named].map(([name, at]) => ({name, revision: at})).sort((a, b) => b.revision - a.revision);
});
