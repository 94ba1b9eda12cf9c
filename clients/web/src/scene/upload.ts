// Uploads pictures for the open scene: skin textures and environments. Each upload is one step.
import {call, scenePath} from "../api/client";
import type {CommandAnswer} from "../api/types";
import {skin_endings} from "../files/take";
import {say, sayError} from "./messages";
import {accept, isOpen, refresh, scene, settings} from "./session";

async function put(id: string, path: string, file: Blob) {
  const answer = await call(`${scenePath(id)}/${path}`, {method: "PUT", body: file, headers: {"Content-Type": "application/octet-stream"}});
  if (!isOpen(id)) return;
  accept(await answer.json() as CommandAnswer);
  await refresh();
}

async function putSkin(id: string, file: File) {
  const {fitting} = await import("../files/texture");
  const {picture, note} = await fitting(file);
  if (!picture) return say(note, "", "error");
  await put(id, "skin_texture", picture);
  say(`${file.name} is now the model's texture.`, note);
}

/** Uploads an environment; its intensity and turn stay as they were. */
async function putEnvironment(id: string, file: File) {
  const {intensity, turn_degrees} = settings.value?.environment ?? {};
  const parameters = Object.entries({intensity, turn_degrees}).flatMap(([name, value]) => (value === undefined ? [] : [`${name}=${value}`]));
  await put(id, `environment?${parameters.join("&")}`, file);
  say(`${file.name} now lights the model.`);
}

const light_endings = /\.(hdr|exr)$/i;

export const isPicture = (path: string) => light_endings.test(path) || skin_endings.test(path);

/** Uploads a picture to the open scene: HDR and EXR as environment, others as skin texture. Shows an error if it fails. */
export async function takePicture(file: File): Promise<void> {
  const id = scene.value?.id;
  if (!id) return say("Open a scene first.", "A picture becomes the texture of the open model, or lights it.", "error");
  await (light_endings.test(file.name) ? putEnvironment(id, file) : putSkin(id, file)).catch(sayError);
}
