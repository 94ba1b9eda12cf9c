// Recipes as docs/recipes.md says, filled in for one model: variables, files that are included, positions as shares of its box.
// The command line has all checks; here a mistake is one sentence, and the server checks the commands.
import type {Bounds, Command} from "../api/types";

type Json = null | boolean | number | string | Json[] | {[name: string]: Json};
type Values = Record<string, Json>;
export interface Recipe { description?: string; variables?: Values; include?: string[]; steps?: Values[] }
/** What is sent as one undo step: a command, or several under `commands`. */
export type Step = Command | {commands: Command[]};

const max_depth = 16;
const max_steps = 10000;

const isObject = (value: Json | undefined): value is Values => typeof value === "object" && value !== null && !Array.isArray(value);
const isTriple = (value: Json | undefined): value is number[] => Array.isArray(value) && value.length === 3 && value.every((one) => typeof one === "number");
const nameOf = (path: string) => path.slice(path.lastIndexOf("/") + 1).replace(/\.json$/, "");

/** Fills in one file's variables; `given` wins over its own. */
class Scope {
  private depth = 0;
  constructor(readonly recipe: Recipe, private readonly given: Values, private readonly box: Bounds) {
    const known = recipe.variables ?? {};
    for (const name of Object.keys(given)) if (!(name in known)) throw new Error(`The recipe that is used has no variable "${name}".`);
  }

  fill(value: Json): Json {
    if (typeof value === "string") return this.fillText(value);
    if (Array.isArray(value)) return value.map((one) => this.fill(one));
    if (!isObject(value)) return value;
    const copy = Object.fromEntries(Object.entries(value).map(([name, one]) => [name, this.fill(one)]));
    return this.position(copy) ?? copy;
  }

  private fillText(text: string): Json {
    const whole = /^\$\{([^}]*)\}$/.exec(text);
    if (whole) return this.variable(whole[1]!);
    return text.replace(/\$\{([^}]*)\}/g, (_, name: string) => {
      const value = this.variable(name);
      return typeof value === "string" ? value : JSON.stringify(value);
    });
  }

  private variable(name: string): Json {
    if (name in this.given) return this.given[name]!;
    const own = this.recipe.variables?.[name];
    if (own === undefined) throw new Error(`The recipe has no variable "${name}".`);
    if (++this.depth > max_depth) throw new Error("Variables of the recipe are made of one another in a circle.");
    const value = this.fill(own);
    --this.depth;
    return value;
  }

  /** {"at": [...], "by": [...]}; a colour ramp's `at` is a number. */
  private position(value: Values): Json | null {
    const {at, by, ...rest} = value;
    if (!isTriple(at) || Object.keys(rest).length > 0 || (by !== undefined && !isTriple(by))) return null;
    const {min, max} = this.box;
    return at.map((share, k) => Number(min[k]) + (share + (by?.[k] ?? 0)) * (Number(max[k]) - Number(min[k])));
  }
}

/** All steps for a model in this box. `files` has what is included, by name without folder and ending. */
export function expand(recipe: Recipe, files: Record<string, Recipe>, box: Bounds, given: Values = {}): Step[] {
  const steps: Step[] = [];
  const add = (scope: Scope, depth: number) => {
    if (depth > max_depth) throw new Error("Recipes use one another in a circle.");
    for (const {comment: _, ...step} of scope.recipe.steps ?? []) {
      if (Object.keys(step).length === 0) continue;
      if ("pick" in step || "for" in step) throw new Error("Recipes with picks and loops are for `pelage run`.");
      if (typeof step["use"] !== "string") {
        steps.push(scope.fill(step) as unknown as Step);
        if (steps.length > max_steps) throw new Error(`The recipe has more than ${max_steps} steps.`);
        continue;
      }
      const used = scope.recipe.include?.map(nameOf).includes(step["use"]) ? files[step["use"]] : undefined;
      if (!used) throw new Error(`The recipe uses "${step["use"]}", which is not there. Drop its file together with it.`);
      add(new Scope(used, (scope.fill(step["with"] ?? {}) as Values), box), depth + 1);
    }
  };
  add(new Scope(recipe, given, box), 0);
  return steps;
}

/** Steps of a file: a recipe, one command or batch, an array of commands, or lines as the log writes them. */
export function stepsOf(text: string, files: Record<string, Recipe>, box: Bounds): Step[] {
  let whole: unknown;
  try {
    whole = JSON.parse(text);
  } catch {
    return text.split("\n").filter((line) => line.trim()).map((line) => JSON.parse(line) as Step);
  }
  if (Array.isArray(whole)) return whole as Step[];
  const object = whole as Values;
  if ("op" in object || "commands" in object) return [object as unknown as Step];
  if ("steps" in object) return expand(object as Recipe, files, box);
  throw new Error("It is neither a recipe nor commands.");
}
