// Describes answers of the server in short texts for agents, with the next step.
import type {Answers} from "./tool";

type Answer = Answers["CommandAnswer"];
type Result = Answers["CommandResult"];

const short = (value: number) => String(Number(value.toPrecision(3)));

export const fieldInWords = ({field, changed, mean_change, max_change}: Answers["FieldChange"]) =>
  `${field} of ${changed}, mean change ${short(mean_change)}, largest ${short(max_change)}`;

function resultInWords({op, touched, fields, clamped, warnings}: Result, dry_run: boolean): string {
  const changes = fields.map(fieldInWords);
  const did = dry_run ? "would touch" : "touched";
  return [
    `${op} ${did} ${touched} vertices${changes.length > 0 ? `: ${changes.join("; ")}` : ""}.`,
    clamped > 0 ? `${clamped} were clamped to a limit.` : "",
    ...warnings.map((warning) => `Warning: ${warning}`),
  ].filter(Boolean).join(" ");
}

/** Returns true if a command touched nothing: its stroke missed, or the mask protects what it hit. */
const missed = (results: Result[]) => results.some(({op, touched}) => touched === 0 && !setsSomething(op));
/** Returns true for commands that set properties of the scene; they touch no vertex. */
const setsSomething = (op: string) => /^(set_|checkpoint$|edit_layer$|mask$)/.test(op);

const miss_hint = "Touched 0: the stroke lies farther from the surface than the brush's radius, does not move, the fur already is so, "
  + "or the mask protects it. `pick` gives positions on the surface.";

const max_lines = 20;

/** Describes only the first `max_lines` results of a batch; the structured data have all. */
function resultsInWords(results: Result[], dry_run: boolean): string[] {
  const lines = results.slice(0, max_lines).map((one) => resultInWords(one, dry_run));
  return results.length > max_lines ? [...lines, `And ${results.length - max_lines} more commands.`] : lines;
}

export function changeInWords({revision, results}: Answer, before: number): string {
  const next = revision === before ? `Nothing changed; the scene is still at revision ${revision}.`
    : `The scene is at revision ${revision}. \`look\` or \`views\` shows it, \`undo\` takes it back.`;
  return [...resultsInWords(results, false), next, missed(results) ? miss_hint : ""].filter(Boolean).join("\n");
}

export function previewInWords({revision, results}: Answer): string {
  const next = `Dry run: nothing has changed, the scene is still at revision ${revision}. To do it, call without dry_run, or run_commands.`;
  return [...resultsInWords(results, true), next, missed(results) ? miss_hint : ""].filter(Boolean).join("\n");
}

const corner = (values: readonly number[]) => `[${values.map((value) => short(value)).join(", ")}]`;

export function sceneInWords({id, name, revision, model, vertices, triangles, size, bounds, undo_steps, redo_steps, coats, edit_layers}: Answers["Scene"]): string {
  const named = coats.length > 1 ? ` Coats: ${coats.map((coat) => coat.name + (coat.muted ? " (muted)" : "")).join(", ")}.` : "";
  const layers = edit_layers.length > 0 ? ` Edit layers: ${edit_layers.map((layer) => layer.name).join(", ")}.` : "";
  const box = `box ${corner(bounds.min)} to ${corner(bounds.max)} (x to the model's left, y up, z forward)`;
  return `Scene "${name}" (id ${id}): model ${model}, ${vertices} vertices, ${triangles} triangles, size ${short(size)}, ${box}. `
    + `Revision ${revision}, ${undo_steps} steps to undo, ${redo_steps} to redo.${named}${layers}`;
}

export function entryInWords({revision, kind, touched, in_effect, author, commands}: Answers["LogEntry"]): string {
  const what = [`${kind} ${opsOf(commands).join(" ")}`.trim(), touched > 0 ? `${touched} vertices` : "", author ? `by ${author}` : ""];
  return `${in_effect ? "*" : " "} ${revision} ${what.filter(Boolean).join(", ")}`;
}

/** Returns the ops in a log entry, which has one command or a list of them. */
export function opsOf(commands: unknown): string[] {
  const list = Array.isArray(commands) ? commands : [commands];
  return list.flatMap((command: {op?: string; commands?: unknown} | undefined) => command?.op ?? (command?.commands ? opsOf(command.commands) : []));
}
