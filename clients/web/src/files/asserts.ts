// What recipes assert of their steps. The agents' tools check it too.
import type {CommandAnswer, RecipeStep} from "../api/types";

/** What a step touched against its recipe's word, in words; "" where that holds. */
export function brokenAssert({asserts}: {asserts?: RecipeStep["asserts"]}, {results}: Pick<CommandAnswer, "results">): string {
  for (const {command, min_vertices = 0, max_vertices = Infinity} of asserts ?? []) {
    const result = results[command];
    if (result && (result.touched < min_vertices || result.touched > max_vertices)) return `${result.op} touched ${result.touched} vertices.`;
  }
  return "";
}
