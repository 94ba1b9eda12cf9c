// A separate scene with fur on a flat patch, which shows a coat close up, whatever the model is. There is one on each
// server, shared by all pages.
import * as api from "../api/client";
import {page_id} from "../api/identity";
import type {Coat, FrameRequest, Scene, Settings, Vector} from "../api/types";
import {preview_name} from "./scratch";

const max_revision = 400;  // older scenes are replaced, because nobody needs their long log

let patch_scene: Promise<Scene> | null = null;
let serial = 0;

async function findScene(): Promise<Scene> {
  const existing = (await api.listScenes()).find((one) => one.name === preview_name && one.model === "plane");
  if (existing && existing.revision < max_revision) return existing;
  if (existing) await api.removeScene(existing.id);
  return api.createScene({name: preview_name, model: {builtin: "plane", triangles: 200}, fur: {length: 0.045, inclination: 0.5}});
}

const camera = {position: [0.2, 0.3, 0.2] as Vector, target: [0, 0.02, 0] as Vector, up: [0, 1, 0] as Vector, fov_degrees: 30};
/** Quality of the final picture; hairs are thinner than its pixels. */
const final_quality: NonNullable<FrameRequest["quality"]> = {raster: {strands: 1000, light_of: 1}, scale: 1.5};

export interface Patch { scene: string; revision: number }

/** Gives the patch a coat. */
export async function dressPatch(coat: Coat, look: Settings["look"]): Promise<Patch> {
  patch_scene ??= findScene();
  const {id} = await patch_scene;
  const commands = [{op: "set_coat", coat}, {op: "set_look", look: {...look, colour_source: "coat"}}];
  return {scene: id, revision: (await api.change(id, "commands", {commands}, `${page_id}-patch-${++serial}`)).revision};
}

/** Draws the patch; null if another page changed its coat meanwhile. */
export async function drawPatch(patch: Patch, at_rest: boolean, size: {width: number; height: number}, signal: AbortSignal): Promise<Blob | null> {
  const quality = at_rest ? final_quality : "interactive";
  const picture = await api.drawFrame(patch.scene, {...size, camera, quality, format: "jpeg", view: `${page_id}-patch`}, null, signal);
  return picture?.revision === patch.revision ? picture.bytes : null;
}

/** Forgets the patch's scene after an error, because the scene may be gone. */
export function forgetPatch() { patch_scene = null; }
