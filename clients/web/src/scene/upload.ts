// Pictures for the scene that is open: the skin of its model and the light from all around. Each is one step.
import {call, scenePath} from "../api/client";
import type {CommandAnswer} from "../api/types";
import {fitting} from "../files/texture";
import {say, sayError} from "./messages";
import {accept, refresh, scene, settings} from "./session";

async function put(path: string, file: Blob) {
  const id = scene.value?.id;
  if (!id) return;
  const answer = await call(`${scenePath(id)}/${path}`, {method: "PUT", body: file, headers: {"Content-Type": "application/octet-stream"}});
  if (scene.value?.id !== id) return;
  accept(await answer.json() as CommandAnswer);
  await refresh();
}

async function putSkin(file: File) {
  const {picture, note} = await fitting(file);
  if (!picture) return say(note, "", "error");
  await put("skin_texture", picture);
  say(`${file.name} lies on the model.`, note);
}

/** Its strength and turn stay as they were. */
async function putEnvironment(file: File) {
  const {intensity, turn_degrees} = settings.value?.environment ?? {};
  const kept = Object.entries({intensity, turn_degrees}).flatMap(([name, value]) => (value === undefined ? [] : [`${name}=${value}`]));
  await put(`environment?${kept.join("&")}`, file);
  say(`${file.name} lights the model.`);
}

const light_endings = /\.(hdr|exr)$/i;
const skin_endings = /\.(png|jpe?g|webp|bmp|gif)$/i;

export const isPicture = (path: string) => light_endings.test(path) || skin_endings.test(path);

/** By its ending: HDR and EXR are light, others skin. A refusal is said. */
export const takePicture = (file: File): Promise<void> =>
  (light_endings.test(file.name) ? putEnvironment(file) : putSkin(file)).catch(sayError);
