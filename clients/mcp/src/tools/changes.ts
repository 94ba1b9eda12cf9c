// One tool for each command of the contract, and tools that run several commands: batches, looks and recipes.
import {brokenAssert} from "../../../web/src/files/asserts";
import {rulesOf, type Schema} from "../contract";
import {namesOf, textOf} from "../library";
import {Refusal, unknownName} from "../refusal";
import type {Caller, Service} from "../service";
import {arrayIn, changes, dry_run_member, reads, result, scene_member, findScene, pathOf, textIn, without, type Answers, type Context, type Input, type Tool} from "./tool";
import {changeInWords, previewInWords} from "./words";

type Answer = Answers["CommandAnswer"];
type Step = Answers["RecipeStep"];

/** Members of commands that have another name in the tools, because there `scene` is the scene to change. */
const renamed = new Map([["scene", "source_scene"]]);
const nameInTool = (member: string) => renamed.get(member) ?? member;
const nameInCommand = (member: string) => [...renamed].find(([, name]) => name === member)?.[0] ?? member;

export const commandTools = (context: Context): Tool[] =>
  [...context.schemas.commands()].map(([op, schema]) => commandTool(context, op, schema));

function commandTool({service, schemas}: Context, op: string, schema: Schema): Tool {
  const members = Object.entries(schema.properties ?? {}).filter(([member]) => member !== "op");
  const properties = Object.fromEntries(members.map(([member, one]) => [nameInTool(member), one]));
  const required = (schema.required ?? []).filter((member) => member !== "op").map(nameInTool);
  return {
    name: op, annotations: changes,
    description: [schema.description ?? `Sets the scene's ${op.replace(/^set_/, "")}.`, op.startsWith("set_") ? replaces : "", rulesOf(schema)].filter(Boolean).join(" "),
    inputSchema: schemas.input({scene: scene_member, ...properties, dry_run: dry_run_member}, ["scene", ...required]),
    run: async (input, caller) => {
      const command = Object.fromEntries(Object.entries(without(input, "scene", "dry_run")).map(([member, value]) => [nameInCommand(member), value]));
      if (op === "retarget") command["scene"] = (await findScene(service, textIn(input, "source_scene"), caller, "/source_scene")).id;
      return change(service, input, {op, ...command}, caller);
    },
  };
}
const replaces = "It replaces all that was set: read it with `read_settings`, change it and send it back whole.";

/** Runs a command or a batch as one undo step; a dry run says what it would do. */
async function change(service: Service, input: Input, body: object, caller: Caller) {
  const scene = await findScene(service, textIn(input, "scene"), caller);
  if (dryRunIn(input)) return preview(service, pathOf(scene), body, caller);
  const answer = await service.post<Answer>(`${pathOf(scene)}/commands`, body, caller);
  return result(changeInWords(answer, scene.revision), answer);
}

export async function preview(service: Service, path: string, body: object, caller: Caller) {
  const answer = await service.post<Answer>(`${path}/commands?dry_run=1`, body, caller);
  return result(previewInWords(answer), {dry_run: true, ...answer});
}

function dryRunIn({dry_run = false}: Input): boolean {
  if (typeof dry_run === "boolean") return dry_run;
  throw new Refusal({detail: '"dry_run" is neither true nor false.', pointer: "/dry_run", limit: "true | false"});
}

/** Returns the schema of a list of commands without their members, which would fill an agent's context. */
export function commandsMember(): Schema {
  const command = {type: "object", properties: {op: {type: "string"}}, required: ["op"], description: "`op` and the members that `describe_commands` lists."};
  return {type: "array", items: command, minItems: 1, maxItems: 1000};
}

export function describeCommands({schemas}: Context): Tool {
  const commands = schemas.commands(), known = [...commands.keys()];
  return {
    name: "describe_commands", annotations: reads,
    description: "Lists the commands that `run_commands` takes; with `ops`, gives their members, ranges and defaults as JSON Schema. Read it before you use a command.",
    inputSchema: schemas.input({ops: {type: "array", items: {enum: known}, description: "Commands to describe in full."}}, []),
    run: async (input) => {
      if (input["ops"] === undefined) return result(known.map((op) => `${op}: ${firstSentence(commands.get(op)!)}`).join("\n"), {ops: known});
      const ops = arrayIn(input, "ops").map(String), wrong = ops.findIndex((op) => !commands.has(op));
      if (wrong >= 0) throw unknownName(`There is no command "${ops[wrong]}".`, `/ops/${wrong}`, ops[wrong]!, known);
      const {properties, $defs} = schemas.input(Object.fromEntries(ops.map((op) => [op, commands.get(op)!])), []);
      return result(JSON.stringify({...properties, $defs}), {...properties, $defs});
    },
  };
}

const firstSentence = ({description = ""}: Schema) => /^.*?\.(?= |$)/s.exec(description)?.[0] ?? description;

export function runCommands({service, schemas}: Context): Tool {
  return {
    name: "run_commands", annotations: changes,
    description: "Runs one or several commands as one undo step, all or none.",
    inputSchema: schemas.input({scene: scene_member, commands: commandsMember(), dry_run: dry_run_member}, ["scene", "commands"]),
    run: (input, caller) => change(service, input, {commands: arrayIn(input, "commands")}, caller),
  };
}

export async function applyLook({service, schemas}: Context): Promise<Tool> {
  const name = {enum: await namesOf("looks"), description: "A look; the resource pelage://looks/NAME holds its commands."};
  return {
    name: "apply_look", annotations: changes,
    description: "Applies a look that comes with Pelage: coat, colours and shading, as one undo step. The groom stays.",
    inputSchema: schemas.input({scene: scene_member, name, dry_run: dry_run_member}, ["scene", "name"]),
    run: async (input, caller) => change(service, input, JSON.parse(await textOf("looks", textIn(input, "name"))) as object, caller),
  };
}

export async function runRecipe({service, schemas}: Context): Promise<Tool> {
  const name = {enum: await namesOf("recipes"), description: "A recipe; the resource pelage://recipes/NAME holds its steps and variables."};
  const variables = {type: "object", default: {}, description: "Values for the recipe's variables."};
  return {
    name: "run_recipe", annotations: changes,
    description: "Runs a groom that comes with Pelage, one undo step for each of its steps. Most recipes fit one model: read them first.",
    inputSchema: schemas.input({scene: scene_member, name, variables, dry_run: dry_run_member}, ["scene", "name"]),
    run: async (input, caller) => {
      const scene = await findScene(service, textIn(input, "scene"), caller), path = pathOf(scene);
      const steps = await stepsOf(service, path, textIn(input, "name"), input["variables"] ?? {}, caller);
      if (dryRunIn(input)) return preview(service, path, {commands: steps.flatMap(({commands}) => commands)}, caller);
      const answer = await runSteps(service, path, steps, caller);
      return result(`${steps.length} steps are done.\n${changeInWords(answer, scene.revision)}`, {steps: steps.length, ...answer});
    },
  };
}

async function stepsOf(service: Service, path: string, name: string, variables: unknown, caller: Caller): Promise<Step[]> {
  const names = await namesOf("recipes");
  if (!names.includes(name)) throw unknownName(`There is no recipe "${name}".`, "/name", name, names);
  const documents = await Promise.all(names.map(async (one) => [`${one}.json`, JSON.parse(await textOf("recipes", one)) as unknown] as const));
  const files = Object.fromEntries(documents), file = `${name}.json`;
  return (await service.post<Answers["RecipeAnswer"]>(`${path}/recipe`, {file, recipe: files[file], files, variables}, caller)).steps;
}

/** Sends the steps one after the other. Returns the last answer with the results of all steps. */
async function runSteps(service: Service, path: string, steps: Step[], caller: Caller): Promise<Answer> {
  const answers: Answer[] = [];
  for (const step of steps) {
    try {
      answers.push(await service.post<Answer>(`${path}/commands`, {commands: step.commands}, caller));
      await caller.progress(answers.length, steps.length);
    } catch (error) {
      if (!(error instanceof Refusal)) throw error;
      const detail = `Step ${answers.length + 1} of ${steps.length} is refused: ${error.problem.detail}`;
      throw new Refusal({...error.problem, detail}, `${answers.length} steps are done; \`undo\` reverts them.`);
    }
    const broken = brokenAssert(step, answers.at(-1)!);
    if (broken) throw new Refusal({detail: `Step ${answers.length} of ${steps.length} breaks its recipe's assert: ${broken}`, pointer: "/name"}, "`undo` takes the steps back.");
  }
  const last = answers.at(-1);
  if (!last) throw new Refusal({detail: "The recipe has no steps.", pointer: "/name"});
  return {...last, results: answers.flatMap(({results}) => results)};
}
