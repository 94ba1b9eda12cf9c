// A patch of fur on a flat model: a scene of its own that shows a coat close by, whatever the model is. One on each server.
import * as api from "../api/client";
import {page_id} from "../api/identity";
import type {Scene, Settings, Vector} from "../api/types";

const name = "coat preview";
const max_revision = 400;  // its log is of no use to anybody

let found: Promise<Scene> | null = null;
let serial = 0;

async function findScene(): Promise<Scene> {
  const there = (await api.listScenes()).find((one) => one.name === name && one.model === "plane");
  if (there && there.revision < max_revision) return there;
  if (there) await api.removeScene(there.id);
  return api.createScene({name, model: {builtin: "plane", triangles: 200}, fur: {length: 0.045, inclination: 0.5}});
}

/** At its edge, where hairs are seen from root to tip. */
const camera = {position: [0.98, 0.26, 0.3] as Vector, target: [0.42, 0.035, 0.1] as Vector, up: [0, 1, 0] as Vector, fov_degrees: 30};

/** A picture of a coat; null where somebody else's coat came between. */
export async function drawCoat(coat: Settings["coat"], look: Settings["look"], size: {width: number; height: number}, signal: AbortSignal): Promise<Blob | null> {
  found ??= findScene();
  const patch = await found;
  const commands = [{op: "set_coat", coat}, {op: "set_look", look: {...look, colour_source: "coat"}}];
  const answer = await api.change(patch.id, "commands", {commands}, `${page_id}-patch-${++serial}`);
  const picture = await api.drawFrame(patch.id, {...size, camera, quality: "interactive", background: "studio", format: "jpeg", view: `${page_id}-patch`}, null, signal);
  return picture?.revision === answer.revision ? picture.bytes : null;
}

/** After an error: the scene may be gone. */
export function forgetPatch() { found = null; }
