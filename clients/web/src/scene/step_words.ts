// Describes steps in a few words.
import type {Command} from "../api/types";
import {toolNames} from "../tools/artist_words";
import {words} from "../tools/schema";
import {scene} from "./session";
import {commandsIn, type Step} from "./steps";

const named: Partial<Record<Command["op"], (command: Command) => string>> = {
  paint: (command) => `Paint ${String(command["field"] ?? "density").replaceAll("_", " ")}`,
  map: (command) => `Map of ${String(command["field"] ?? "").replaceAll("_", " ")}`,
  mask: (command) => (command["action"] === undefined || command["action"] === "select" ? maskWords(command) : `Mask: ${String(command["action"])}`),
  checkpoint: (command) => `Checkpoint “${String(command["name"])}”`,
  edit_layer: (command) => layerWords(command),
  blow: (command) => (command["blower"] ? `Blow with ${String(command["blower"])}` : "Blow"),
  attract: (command) => (command["attractor"] ? `Pull to ${String(command["attractor"])}` : "Pull"),
};

const shapes = ["vertices", "box", "sphere", "part", "picture"];
const maskWords = (command: Command) => (shapes.some((shape) => command[shape]) ? "Mask: choose" : "Mask: clear");

function layerWords(command: Command): string {
  const name = `“${String(command["name"])}”`;
  if (command["action"] === "set") {
    if (command["rename"]) return `Layer ${name}: now “${String(command["rename"])}”`;
    if (command["muted"] !== undefined) return `Layer ${name}: ${command["muted"] ? "mute" : "unmute"}`;
    return `Layer ${name}: weight ${Number(command["weight"])}`;
  }
  return `Layer ${name}: ${String(command["action"] ?? "add").replaceAll("_", " ")}`;
}

export function commandWords(command: Command): string {
  const name = named[command.op]?.(command) ?? toolNames[command.op] ?? words(command.op.replace(/^set_/, ""));
  const inverted = (command["brush"] as {invert?: boolean} | undefined)?.invert ? ", inverted" : "";
  return name + (command["flood"] ? " everywhere" : "") + inverted;
}

/** Describes a step: its first command and the number of others. */
export function stepWords(step: Step): string {
  if (step.kind === "revert") return "Went back to an earlier step";
  const commands = commandsIn(step.entries[0]!);
  const first = commands[0];
  if (!first) return "Nothing";
  const more = commands.length - 1;
  return commandWords(first) + (more > 0 ? ` and ${more} more` : "");
}

export const layerOf = (step: Step) => String(commandsIn(step.entries[0]!)[0]?.["edit_layer"] ?? "");
/** Describes how much of the fur a step changed; the step's details have the exact count. */
export function shareOfFur(count: number, exact: boolean): string {
  const share = count / Math.max(1, scene.value?.vertices ?? 1);
  if (share > 0.99) return "all of the fur";
  const percent = share < 0.01 ? "less than 1%" : `${Math.round(100 * share)}%`;
  return `${exact ? "" : share < 0.01 ? "" : "at least "}${percent} of the fur`;
}
/** Formats a count; "+" marks one that is only a lower bound. */
export const amount = (count: number, exact = true) => `${count.toLocaleString("en")}${exact ? "" : "+"}`;
export const vertices = (count: number, exact = true) => `${amount(count, exact)} ${count === 1 ? "vertex" : "vertices"}`;
