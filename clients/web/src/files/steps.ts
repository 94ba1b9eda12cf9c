// Reads files of commands: recipes, which the server turns into steps, and logs, which are steps already.
import {expandRecipe} from "../api/client";
import type {Command, RecipeStep} from "../api/types";

/** One undo step. */
export interface Step { commands: Command[]; asserts?: RecipeStep["asserts"] }
type Documents = Record<string, unknown>;

const isObject = (value: unknown): value is Documents => typeof value === "object" && value !== null && !Array.isArray(value);
const stepOf = (one: unknown): Step => ({commands: isObject(one) && Array.isArray(one["commands"]) ? one["commands"] as Command[] : [one as Command]});

/** Returns the steps of a file: a recipe, one command or batch, an array of commands, or JSON lines as in the log. */
export async function stepsOf(id: string, file: string, text: string, files: Documents): Promise<Step[]> {
  let parsed: unknown;
  try {
    parsed = JSON.parse(text);
  } catch {
    return text.split("\n").filter((line) => line.trim()).map((line) => stepOf(JSON.parse(line)));
  }
  if (Array.isArray(parsed)) return parsed.map(stepOf);
  if (isObject(parsed) && !("op" in parsed) && !("commands" in parsed)) return expandRecipe(id, {file, recipe: parsed, files});
  return [stepOf(parsed)];
}
