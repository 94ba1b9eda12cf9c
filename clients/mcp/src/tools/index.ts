// All tools, grouped in toolsets and by name.
import {applyLook, commandTools, describeCommands, runCommands, runRecipe} from "./changes";
import {exportScene} from "./files";
import {historyTools} from "./history";
import {nameCamera, pictureTools} from "./pictures";
import {previewChange} from "./preview";
import {branchScene, sceneTools} from "./scenes";
import type {Context, Tool} from "./tool";

/** The default toolsets; together they take less than 30 kB of an agent's context. */
const usual = ["scenes", "pictures", "changes", "history"];

/** Returns the tools of the sets, or those named by `only` from all sets. Throws an Error for unknown names. */
export async function toolsOf(context: Context, sets: string[] = usual, only?: string[]): Promise<Map<string, Tool>> {
  const all = await toolsets(context);
  const wanted = only || sets.includes("all") ? Object.keys(all) : sets;
  const no_set = wanted.find((name) => !(name in all));
  if (no_set !== undefined) throw new Error(`There is no toolset "${no_set}". There are ${[...Object.keys(all), "all"].join(", ")}.`);
  const tools = new Map(wanted.flatMap((name) => all[name]!).map((tool) => [tool.name, withCameras(context, tool)]));
  const no_tool = only?.find((name) => !tools.has(name));
  if (no_tool !== undefined) throw new Error(`There is no tool "${no_tool}". There are ${[...tools.keys()].join(", ")}.`);
  return only ? new Map([...tools].filter(([name]) => only.includes(name))) : tools;
}

async function toolsets(context: Context): Promise<Record<string, Tool[]>> {
  return {
    scenes: [...sceneTools(context), branchScene(context), exportScene(context)],
    pictures: [...pictureTools(context), nameCamera(context), previewChange(context)],
    changes: [describeCommands(context), runCommands(context), await applyLook(context), await runRecipe(context)],
    history: historyTools(context),
    commands: commandTools(context),
  };
}

const withCameras = ({cameras}: Context, tool: Tool): Tool =>
  ({...tool, run: async (input, caller) => tool.run(cameras.within(input) as typeof input, caller)});
