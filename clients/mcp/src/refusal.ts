// An error as a problem document (RFC 9457), whether it comes from the Pelage server or from this program.
import type {components} from "contract";
import {nearestOf} from "./nearest";

export type Problem = Partial<components["schemas"]["Problem"]> & {detail: string};

export class Refusal extends Error {
  constructor(readonly problem: Problem, private readonly next = next_steps.get(problem.status ?? 422) ?? "Correct the input and call again.") {
    super(problem.detail);
  }

  /** Returns the same refusal with its JSON pointer renamed, for fields that have another name in the agent's tools. */
  at(rename: (pointer: string) => string): Refusal {
    const {pointer} = this.problem;
    return pointer === undefined ? this : new Refusal({...this.problem, pointer: rename(pointer)}, this.next);
  }

  text(): string {
    const {detail, pointer, limit, nearest} = this.problem;
    return [
      detail,
      pointer ? `Field: ${pointer}` : "", limit ? `Limit: ${limit}` : "", nearest ? `Nearest known name: ${nearest}` : "",
      `Next: ${this.next}`,
    ].filter(Boolean).join("\n");
  }
}

/** Returns the refusal of a name that is not among the known ones; it suggests the nearest one. */
export function unknownName(detail: string, pointer: string, wrong: string, known: readonly string[]): Refusal {
  const nearest = nearestOf(wrong, known);
  return new Refusal({detail, pointer, limit: known.join(" | "), ...(nearest === undefined ? {} : {nearest})});
}

/** Advice by HTTP status; 0 stands for no answer. */
const next_steps = new Map([
  [0, "Start it with `pelaged --listen 127.0.0.1:8080`, or give pelage-mcp its address with --server."],
  [401, "Start pelage-mcp with the server's token as --token."],
  [404, "`list_scenes` shows what there is."],
  [409, "Read the scene with `describe_scene`, then decide whether to call again."],
  [413, "Ask for less in one call."],
  [429, "Wait a few seconds and call again."],
  [503, "Wait a few seconds and call again."],
]);
