// Downloads: pictures, maps, the steps of the groom.
import {signal} from "@preact/signals";
import {Aborted, call, drawFrame, readLines, scenePath, type Picture} from "../api/client";
import {page_id} from "../api/identity";
import type {FrameRequest, Scene} from "../api/types";
import {sayError} from "../scene/messages";
import {scene} from "../scene/session";
import {schemas, words} from "../tools/schema";
import type {Values} from "../tools/state";
import {orbit, pinholeOf} from "../view/camera";
import {outdated, shown} from "../view/frames";
import {dial, plain_request, rest_quality, shared_request} from "../view/quality";
import {traceToEnd} from "../view/trace";
import {viewport_size} from "../view/surface";

/** The file being made; `share` is the done fraction, null while progress is unknown. */
export interface Making { says: string; share: number | null; stop: AbortController }
export const making = signal<Making | null>(null);

const picture_passes = 64, picture_noise = 0.004;
const max_side = 8192;
const wide_pixels = 3840;

export function save(bytes: Blob, name: string) {
  const link = document.createElement("a");
  link.href = URL.createObjectURL(bytes);
  link.download = name;
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href), 60000);
}

/** Returns a file name that is valid on every system: letters, digits and a few signs. */
export const fileName = ({name}: {name: string}, ending: string) => `${name.replace(/[^\p{L}\p{N} ._-]+/gu, "_")}.${ending}`;

/** Runs a download unless one is running; shows the text `says` and lets the user stop it. */
export async function make(says: string, work: (open: Scene, stop: AbortController) => Promise<void>) {
  const open = scene.value;
  if (!open || making.value) return;
  const stop = new AbortController();
  making.value = {says, share: null, stop};
  try {
    await work(open, stop);
  } catch (error) {
    if (!(error instanceof Aborted)) sayError(error);
  } finally {
    making.value = null;
  }
}

export type Size = "1x" | "2x" | "4K";
export const sizes: Size[] = ["1x", "2x", "4K"];

/** Returns the size in pixels of a picture with the window's aspect ratio. */
export function pixelsOf(size: Size): {width: number; height: number} {
  const {width, height} = viewport_size.value;
  const factor = size === "4K" ? wide_pixels / width : size === "2x" ? 2 : 1;
  const scale = Math.min(factor, max_side / width, max_side / height);
  return {width: Math.max(1, Math.round(width * scale)), height: Math.max(1, Math.round(height * scale))};
}

function draw(open: Scene, request: FrameRequest, says: string, stop: AbortController): Promise<Picture | null> {
  const chosen = dial.value;
  const traced = chosen.kind === "tier" && chosen.tier === "reference" && (request.overlay ?? "none") === "none";
  if (!traced) return drawFrame(open.id, request, null, stop.signal);
  const seen = ({trace}: Picture) => {
    const passes = trace?.passes ?? 0;
    making.value = {says: passes ? `${says}: pass ${passes} of at most ${picture_passes}` : says, share: passes / picture_passes, stop};
  };
  return traceToEnd(open.id, request, {passes: picture_passes, noise: picture_noise}, seen, stop.signal);
}

/** Returns the picture on the screen if it is up to date, of final quality and of this size; else null. */
function seenPicture({width, height}: {width: number; height: number}): Blob | null {
  const seen = shown.value;
  if (!seen || outdated.value || seen.width !== width || seen.height !== height) return null;
  const {stage, picture} = seen;
  if (dial.value.kind === "tier" && dial.value.tier === "reference") return picture.trace && picture.trace.end !== "none" ? picture.bytes : null;
  return stage === "rest" || stage === "traced" ? picture.bytes : null;
}

const isFinal = () => dial.value.kind === "tier" && dial.value.tier === "reference";

/** Returns the names of the AOVs that an EXR of the dial's quality can hold beside the picture. */
export const aovNames = () => (schemas.value["Aov"]?.enum ?? []).map(String).filter((name) => name !== "beauty" && !(isFinal() && ["strand", "root"].includes(name)));

/** Downloads the picture of the view; an EXR holds `aovs` beside it. */
export const downloadPicture = (format: "png" | "exr", size: Size, {transparent = false, aovs = []}: {transparent?: boolean; aovs?: string[]} = {}) => make("Drawing the picture", async (open, stop) => {
  const seen = format === "png" && !transparent ? seenPicture(pixelsOf(size)) : null;
  if (seen) return save(seen, fileName(open, format));
  const shared = format === "exr" ? plain_request.value : shared_request.value;  // an EXR has no overlay
  const request: FrameRequest = {...shared, ...rest_quality.value, ...pixelsOf(size), camera: pinholeOf(orbit.value), view: `${page_id}-file`, format};
  if (transparent) request.background = "transparent";
  if (aovs.length) request.aovs = ["beauty", ...aovs] as FrameRequest["aovs"];
  const picture = await draw(open, request, "Drawing the picture", stop);
  if (picture) save(picture.bytes, fileName(open, format));
});

/** Downloads a map; `request` has the members of MapRequest. */
export const downloadMap = (request: Values) => make(`Making the map: ${words(String(request["field"]))}`, async (open, stop) => {
  const {field, ...parameters} = request;
  const query = new URLSearchParams(Object.entries(parameters).map(([name, value]) => [name, String(value)]));
  const answer = await call(`${scenePath(open.id)}/maps/${String(field)}?${query}`, {signal: stop.signal});
  save(await answer.blob(), fileName(open, `${String(field)}.${String(parameters["format"] ?? "png16").startsWith("exr") ? "exr" : "png"}`));
});

export const downloadLog = () => make("Reading the steps", async (open) => {
  save(new Blob([await readLines(open.id)], {type: "application/jsonl"}), fileName(open, "jsonl"));
});

/** Downloads the steps as a recipe (docs/recipes.md), which `pelage run` or a drop onto this page runs again. */
export const downloadRecipe = () => make("Reading the steps", async (open) => {
  const steps = (await readLines(open.id)).split("\n").filter((line) => line.trim()).map((line) => JSON.parse(line) as unknown);
  const recipe = {description: `The groom of ${open.name}.`, steps};
  save(new Blob([JSON.stringify(recipe, null, 1) + "\n"], {type: "application/json"}), fileName(open, "recipe.json"));
});
