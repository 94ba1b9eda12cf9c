// Plans an upload: chooses one model among the dropped files and packs it with the files that it references.
import type {ModelFormat} from "../api/types";
import type {Values} from "../tools/state";
import {endingOf, type InputFile} from "./take";

export interface Plan {
  name: string;
  format: ModelFormat;
  bytes: Blob;
  texture: Blob | null;
  /** Options that differ from the contract's defaults. */
  options: Values;
  notes: string[];
  /** Id of the scene whose groom the model gets; "" if it is not a new version of a model. */
  version_of: string;
}
/** An error with a message for the user; `next` says what to do. */
export class PlanError extends Error {
  constructor(message: string, readonly next: string) { super(message); }
}

export const model_endings = ["glb", "gltf", "obj", "ply", "off", "stl", "3ds"] as const;
const max_model_bytes = 256 * 1024 * 1024;
const mebibytes = (bytes: number) => `${Math.ceil(bytes / 1024 / 1024)} MiB`;

const isModel = ({path}: InputFile) => (model_endings as readonly string[]).includes(endingOf(path));

/** Chooses the most likely model: by format, then by size. `others` counts the models that were not chosen. */
export function chooseModel(all: InputFile[]): {model: InputFile | undefined; others: number} {
  const rank = ({path}: InputFile) => (model_endings as readonly string[]).indexOf(endingOf(path));
  const models = all.filter(isModel).sort((a, b) => rank(a) - rank(b) || b.file.size - a.file.size);
  return {model: models[0], others: models.length - 1};
}

/** Guesses the axes by format: STL and 3DS usually have z up; glTF has y up by its standard. */
const axesOf = (format: ModelFormat): Values => (["stl", "3ds"].includes(format) ? {up: "z", front: "-y"} : {up: "y", front: "z"});

async function pack(model: InputFile, all: InputFile[]): Promise<Blob> {
  const {MissingFiles, packGltf} = await import("./pack_gltf");
  try {
    return await packGltf(model, all);
  } catch (error) {
    if (error instanceof MissingFiles) throw new PlanError(`${model.file.name}: ${error.message}`, "Drop the whole folder, or choose it with “Folder”.");
    throw new PlanError(`${model.file.name} cannot be read as glTF.`, "Export it again, preferably as GLB.");
  }
}

export async function planOf(all: InputFile[]): Promise<Plan> {
  const {model, others} = chooseModel(all);
  if (!model) throw new PlanError("There is no model among these files.", `Model files end in ${model_endings.map((one) => `.${one}`).join(", ")}; recipe files end in .json or .jsonl.`);
  const ending = endingOf(model.path) as ModelFormat;
  const notes = others > 0 ? [`${others + 1} models were dropped: ${model.file.name} is used.`] : [];
  const bytes = ending === "gltf" ? await pack(model, all) : model.file;
  if (bytes.size > max_model_bytes) throw new PlanError(`${model.file.name} is too large (${mebibytes(bytes.size)}).`, "The limit is 256 MiB: reduce the mesh, or leave out pictures.");
  if (bytes.size === 0) throw new PlanError(`${model.file.name} is empty.`, "Export it again.");
  const texture = ending === "obj" ? await (await import("./texture")).textureOf(model, all) : {picture: null, notes: []};
  const format = ending === "gltf" ? "glb" : ending;
  return {name: model.file.name.replace(/\.[^.]+$/, ""), format, bytes, texture: texture.picture, options: axesOf(format), notes: [...notes, ...texture.notes], version_of: ""};
}
