// All tools, by name.
import {applyLook, commandTools, runCommands, runRecipe} from "./changes";
import {historyTools} from "./history";
import {pictureTools} from "./pictures";
import {previewChange} from "./preview";
import {sceneTools} from "./scenes";
import type {Context, Tool} from "./tool";

/** Throws an Error where `only` names a tool that there is not. */
export async function allTools(context: Context, only: string[] | undefined): Promise<Map<string, Tool>> {
  const tools = [
    ...sceneTools(context), ...pictureTools(context), previewChange(context), ...historyTools(context),
    runCommands(context), await applyLook(context), await runRecipe(context), ...commandTools(context),
  ];
  const known = new Map(tools.map((tool) => [tool.name, tool]));
  const unknown = only?.find((name) => !known.has(name));
  if (unknown !== undefined) throw new Error(`There is no tool "${unknown}". There are ${[...known.keys()].join(", ")}.`);
  return only ? new Map([...known].filter(([name]) => only.includes(name))) : known;
}
