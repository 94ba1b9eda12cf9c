// Thumbnails of scenes for the list, and the last picture seen, which the page shows at start until the server has drawn
// one. Both are stored in this browser.
import {signal} from "@preact/signals";
import {drawFrame} from "../api/client";
import {storedSignal, page_id} from "../api/identity";
import {scenes} from "./session";

/** Data URLs by scene id. */
export const thumbnails = storedSignal<Record<string, string>>("thumbnails", {});
/** The last picture seen, large enough to fill a window for a moment. */
export const last_picture = storedSignal<{scene: string; address: string} | null>("last-picture", null);

const small = {width: 128, height: 96}, large_width = 720;
const max_thumbnails = 60;

/** Crops the middle of a picture to the aspect ratio of width and height and scales it; returns a data URL. */
function reduced(picture: HTMLCanvasElement, width: number, height: number): string {
  const canvas = document.createElement("canvas");
  canvas.width = width, canvas.height = height;
  const share = Math.min(picture.width / width, picture.height / height);
  const [w, h] = [width * share, height * share];
  canvas.getContext("2d")!.drawImage(picture, (picture.width - w) / 2, (picture.height - h) / 2, w, h, 0, 0, width, height);
  return canvas.toDataURL("image/jpeg", 0.75);
}

function put(scene: string, address: string) {
  const all = Object.entries({...thumbnails.value, [scene]: address});
  thumbnails.value = Object.fromEntries(all.slice(-max_thumbnails));
}

/** Stores the picture on the screen as its scene's thumbnail and as the last picture. */
export function keepPicture(scene: string, picture: HTMLCanvasElement) {
  if (picture.width < 2) return;
  put(scene, reduced(picture, small.width, small.height));
  const height = Math.round((large_width * picture.height) / picture.width);
  last_picture.value = {scene, address: reduced(picture, large_width, height)};
}

const requested = new Set<string>();
const busy = signal(false);

/** Draws the missing thumbnails on the server, one after the other. */
export async function drawMissing() {
  if (busy.value) return;
  busy.value = true;
  try {
    for (const {id} of scenes.value) {
      if (thumbnails.value[id] || requested.has(id)) continue;
      requested.add(id);
      const picture = await drawFrame(id, {...small, quality: "draft", format: "jpeg", camera: {auto: "three_quarter"}, view: `${page_id}-list`}, null).catch(() => null);
      if (picture) put(id, await addressOf(picture.bytes));
    }
  } finally {
    busy.value = false;
  }
}

const addressOf = (bytes: Blob) => new Promise<string>((done, failed) => {
  const reader = new FileReader();
  reader.onload = () => done(reader.result as string);
  reader.onerror = () => failed(reader.error);
  reader.readAsDataURL(bytes);
});
