// Tools for the history: undo, redo, revert, the log.
import type {Caller} from "../service";
import {commandsMember} from "./changes";
import {arrayIn, changes, findScene, integerIn, pathOf, queryOf, reads, result, scene_member, scenePath, textIn, without, type Answers, type Context, type Input, type Tool} from "./tool";
import {changeInWords, entryInWords, fieldInWords, opsOf} from "./words";

export function historyTools(context: Context): Tool[] {
  const {schemas} = context;
  const steps = schemas.named("Steps").properties ?? {};
  return [
    move(context, "undo", "Undoes the newest steps. `redo` brings them back.", schemas.input({scene: scene_member, ...steps}, ["scene"])),
    move(context, "redo", "Redoes what `undo` took back.", schemas.input({scene: scene_member, ...steps}, ["scene"])),
    move(context, "revert", "Goes back to an earlier revision of the scene, as a step that can be undone. `log` shows revisions.",
      schemas.input({scene: scene_member, ...schemas.named("RevisionBody").properties}, ["scene", "revision"])),
    log(context), amendStep(context), compareRevisions(context),
  ];
}

function move({service}: Context, name: string, description: string, inputSchema: Tool["inputSchema"]): Tool {
  const run = async (input: Input, caller: Caller) => {
    const path = await scenePath(service, textIn(input, "scene"), caller);
    const answer = await service.post<Answers["CommandAnswer"]>(`${path}/${name}`, without(input, "scene"), caller);
    const {undo_steps, redo_steps} = await service.get<Answers["Scene"]>(path, caller);
    const text = `Done: the scene is at revision ${answer.revision}, with ${undo_steps} steps to undo and ${redo_steps} to redo. \`look\` or \`views\` shows it.`;
    return result(text, {...answer, undo_steps, redo_steps});
  };
  return {name, annotations: changes, description, inputSchema, run};
}

function log({service, schemas}: Context): Tool {
  const last = {type: "integer", minimum: 1, maximum: 1000, default: 20, description: "How many of the newest entries."};
  const commands = {type: "boolean", default: false, description: "Include the full commands; strokes can be long."};
  return {
    name: "log", annotations: reads,
    description: "The undo log: revision, kind, commands, vertices touched, author. * marks the steps in effect.",
    inputSchema: schemas.input({scene: scene_member, last, commands}, ["scene"]),
    run: async (input, caller) => {
      const count = integerIn(input, "last", 20, 1, 1000);
      const all = await service.get<Answers["Log"]>(`${await scenePath(service, textIn(input, "scene"), caller)}/log`, caller);
      const entries = all.entries.slice(-count);
      const words = entries.map((entry) => entryInWords(entry) + (input["commands"] === true ? ` ${JSON.stringify(entry.commands)}` : ""));
      const data = entries.map(({commands: sent, ...entry}) => ({...entry, ops: opsOf(sent), ...(input["commands"] === true ? {commands: sent} : {})}));
      return result(words.length > 0 ? words.join("\n") : "The log is empty: nothing has been changed yet.", {entries: data, in_all: all.entries.length});
    },
  };
}

function amendStep({service, schemas}: Context): Tool {
  const {revision} = schemas.named("AmendRequest").properties ?? {};
  return {
    name: "amend_step", annotations: changes,
    description: "Replaces the commands of an earlier step, [] removes it, and replays the steps after it. `log` with `commands` shows what they were.",
    inputSchema: schemas.input({scene: scene_member, revision: revision!, commands: {...commandsMember(), minItems: 0}}, ["scene", "revision", "commands"]),
    run: async (input, caller) => {
      const scene = await findScene(service, textIn(input, "scene"), caller);
      const body = {revision: input["revision"], commands: arrayIn(input, "commands")};
      const answer = await service.post<Answers["CommandAnswer"]>(`${pathOf(scene)}/amend`, body, caller);
      return result(changeInWords(answer, scene.revision), answer);
    },
  };
}

function compareRevisions({service, schemas}: Context): Tool {
  return {
    name: "compare_revisions", annotations: reads,
    description: "Says in which fields two revisions differ. `views` with the overlay `difference` shows where.",
    inputSchema: schemas.input({scene: scene_member, ...schemas.named("Revisions").properties}, ["scene", "from", "to"]),
    run: async (input, caller) => {
      const path = await scenePath(service, textIn(input, "scene"), caller);
      const found = await service.get<Answers["Comparison"]>(`${path}/compare?${queryOf(without(input, "scene"))}`, caller);
      const words = found.fields.map(fieldInWords).join("; ");
      return result(`Revisions ${found.from} and ${found.to} differ at ${found.touched} vertices${words ? `: ${words}` : ""}.`, found);
    },
  };
}
