// Checks the asserts of recipe steps. clients/mcp uses it, too.
import type {CommandAnswer, RecipeStep} from "../api/types";

/** Describes the first command that touched more or fewer vertices than its assert allows; "" if all asserts hold. */
export function brokenAssert({asserts}: {asserts?: RecipeStep["asserts"]}, {results}: Pick<CommandAnswer, "results">): string {
  for (const {command, min_vertices = 0, max_vertices = Infinity} of asserts ?? []) {
    const result = results[command];
    if (result && (result.touched < min_vertices || result.touched > max_vertices)) return `${result.op} touched ${result.touched} vertices.`;
  }
  return "";
}
