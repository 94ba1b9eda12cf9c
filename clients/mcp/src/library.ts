// Reads the looks and recipes that come with the program, from folders beside it.
import {readFile, readdir} from "node:fs/promises";
import {fileURLToPath} from "node:url";
import {unknownName} from "./refusal";

export type Kind = "looks" | "recipes";
export const kinds: Kind[] = ["looks", "recipes"];

const folderOf = (kind: Kind) => fileURLToPath(new URL(`./${kind}/`, import.meta.url));

/** Returns the sorted names, without the file extension. */
export async function namesOf(kind: Kind): Promise<string[]> {
  const files = await readdir(folderOf(kind));
  return files.filter((file) => file.endsWith(".json")).map((file) => file.slice(0, -".json".length)).sort();
}

export async function textOf(kind: Kind, name: string): Promise<string> {
  const names = await namesOf(kind);
  if (!names.includes(name)) throw unknownName(`There is no "${name}" among the ${kind}.`, "/name", name, names);
  return readFile(`${folderOf(kind)}${name}.json`, "utf8");
}
