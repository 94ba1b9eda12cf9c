// Small pictures of the open scene in each quality, for the dial's card.
import {signal} from "@preact/signals";
import {Aborted, drawFrame} from "../api/client";
import {page_id} from "../api/identity";
import type {FrameRequest, Tier} from "../api/types";
import {sayError} from "../scene/messages";
import {scene} from "../scene/session";
import {pinholeOf, zoomed} from "../view/camera";
import {plain_request} from "../view/quality";
import {seen_orbit} from "../view/surface";
import {traceToEnd} from "../view/trace";

/** Object URLs of the pictures. */
export const dial_pictures = signal<Partial<Record<Tier, string>>>({});

const size = {width: 152, height: 112};
const closeness = 0.28;  // factor for the camera's distance, so that single hairs are visible
const passes = 24;

function take(tier: Tier, bytes: Blob) {
  const old = dial_pictures.value[tier];
  dial_pictures.value = {...dial_pictures.value, [tier]: URL.createObjectURL(bytes)};
  if (old) URL.revokeObjectURL(old);
}

/** Draws the pictures of all qualities, from fast to slow. */
export async function drawDialPictures(stop: AbortSignal) {
  if (!scene.value) return;
  const {id, size: model} = scene.value;
  const camera = pinholeOf(zoomed(seen_orbit.value, closeness, model));
  const request: FrameRequest = {...plain_request.value, ...size, camera, format: "jpeg"};
  try {
    for (const quality of ["draft", "interactive", "detailed"] as const) {
      const picture = await drawFrame(id, {...request, quality, view: `${page_id}-dial`}, null, stop);
      if (picture) take(quality, picture.bytes);
    }
    await traceToEnd(id, {...request, quality: "interactive", view: `${page_id}-dial-traced`}, {passes, noise: 0}, (picture) => { if (picture.trace?.passes) take("reference", picture.bytes); }, stop);
  } catch (error) {
    if (!(error instanceof Aborted)) sayError(error);
  }
}
