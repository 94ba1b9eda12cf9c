// Finds the picture that an OBJ's materials reference and converts it to what the server takes: one PNG or JPEG of at most
// 4096 x 4096 pixels.
import {baseOf, findNamed, skin_endings, type InputFile} from "./take";

export interface Texture { picture: Blob | null; notes: string[] }

const max_side = 4096;
const head_bytes = 1 << 20;  // an OBJ's material files are looked for within its first MiB

/** Returns the file names in `map_Kd` lines, without their options. */
export function diffuseMaps(mtl: string): string[] {
  const names: string[] = [];
  for (const line of mtl.split(/\r?\n/)) {
    const match = /^\s*map_Kd\s+(.*\S)/i.exec(line);
    if (!match) continue;
    const name = match[1]!.replace(/^(?:-(?:s|o|t)(?:\s+-?[\d.]+){1,3}\s+|-mm(?:\s+-?[\d.]+){2}\s+|-(?:blendu|blendv|cc|clamp|texres|boost|bm|imfchan|type)\s+\S+\s+)*/i, "");
    if (!names.includes(name)) names.push(name);
  }
  return names;
}

/** Shrinks a picture or converts it to PNG if the server would refuse it; null if the browser cannot read it. */
export async function fitting(file: File): Promise<{picture: Blob | null; note: string}> {
  const bitmap = await createImageBitmap(file).catch(() => null);
  if (!bitmap) return {picture: null, note: `This browser cannot read ${file.name}: save it as PNG and drop it again.`};
  const {width, height} = bitmap;
  const scale = Math.min(1, max_side / Math.max(width, height));
  if (scale === 1 && ["image/png", "image/jpeg"].includes(file.type)) return {picture: file, note: ""};
  const canvas = new OffscreenCanvas(Math.round(width * scale), Math.round(height * scale));
  canvas.getContext("2d")!.drawImage(bitmap, 0, 0, canvas.width, canvas.height);
  const note = scale < 1 ? `${file.name} was scaled down, from ${width} x ${height} to ${canvas.width} x ${canvas.height} pixels.` : "";
  return {picture: await canvas.convertToBlob({type: "image/png"}), note};
}

async function namesOf(model: InputFile, all: InputFile[], notes: string[]): Promise<[string, InputFile][]> {
  const head = await model.file.slice(0, head_bytes).text();
  const libraries = [...head.matchAll(/^\s*mtllib\s+(.*\S)/gim)].map((match) => match[1]!);
  const found: [string, InputFile][] = [];
  for (const library of libraries) {
    const mtl = findNamed(all, model.path, library);
    if (!mtl) { notes.push(`${baseOf(library)} is missing: to get the model's colours, drop the whole folder.`); continue; }
    for (const name of diffuseMaps(await mtl.file.text())) found.push([name, mtl]);
  }
  return found;
}

/** Returns the only dropped picture, for a model whose materials reference none or were not dropped. */
async function onlyPicture(all: InputFile[], notes: string[]): Promise<Texture> {
  const pictures = all.filter(({path}) => skin_endings.test(path));
  if (pictures.length > 1) notes.push(`You added ${pictures.length} pictures, but no material names one: after the upload, drop the right one on the model.`);
  if (pictures.length !== 1) return {picture: null, notes};
  const {picture, note} = await fitting(pictures[0]!.file);
  return {picture, notes: [...notes, note || `${pictures[0]!.file.name} was dropped with the model and becomes its texture.`]};
}

/** Returns the first referenced picture that is there; the server takes one picture for each model. */
export async function textureOf(model: InputFile, all: InputFile[]): Promise<Texture> {
  const notes: string[] = [];
  const names = await namesOf(model, all, notes);
  if (names.length === 0) return onlyPicture(all, notes);
  const files = names.map(([name, mtl]) => findNamed(all, mtl.path, name));
  const missing = names.filter((_, k) => !files[k]).map(([name]) => baseOf(name));
  if (missing.length) notes.push(`Missing: ${missing.join(", ")}.`);
  const first = files.find((file) => file !== undefined);
  if (!first) return {picture: null, notes};
  if (names.length > 1) notes.push(`Its materials use ${names.length} pictures, but a model has one texture: ${first.file.name} is used.`);
  const {picture, note} = await fitting(first.file);
  if (note) notes.push(note);
  return {picture, notes};
}
