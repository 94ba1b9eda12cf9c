// A file for the scene that is open, as one step of it.
import {call, scenePath} from "../api/client";
import type {CommandAnswer} from "../api/types";
import {sayError} from "./messages";
import {accept, refresh, scene} from "./session";

/** `path` is below the scene's; false where it was refused, which was then said. */
export async function upload(path: string, file: Blob): Promise<boolean> {
  const id = scene.value?.id;
  if (!id) return false;
  try {
    const answer = await call(`${scenePath(id)}/${path}`, {method: "PUT", body: file, headers: {"Content-Type": "application/octet-stream"}});
    if (scene.value?.id !== id) return true;
    accept(await answer.json() as CommandAnswer);
    await refresh();
    return true;
  } catch (error) {
    sayError(error);
    return false;
  }
}
