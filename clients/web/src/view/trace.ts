// Traces a picture to its end, for files and comparisons; the viewport does not use it.
import {drawFrame, type Picture} from "../api/client";
import type {FrameRequest, Tracing} from "../api/types";

const wait_seconds = 20;

/** Traces until the limits in `tracing` are reached. Calls `onPicture` for each better picture, first for the rasterized one. */
export async function traceToEnd(id: string, request: FrameRequest, tracing: Partial<Tracing>, onPicture: (picture: Picture) => void, stop: AbortSignal): Promise<Picture> {
  const progressive = tracing as NonNullable<FrameRequest["progressive"]>;
  let news: {after: number; after_pass: number; wait: number} | null = null;
  for (;;) {
    const picture: Picture | null = await drawFrame(id, {...request, progressive}, news, stop);
    if (!picture) continue;
    onPicture(picture);
    if (picture.trace && picture.trace.end !== "none") return picture;
    news = {after: picture.revision, after_pass: picture.trace?.passes ?? 0, wait: wait_seconds};
  }
}
