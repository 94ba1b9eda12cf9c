// What is seen, said quietly: stage, how far it has come, time and revision.
import {offline, unsent} from "../api/outbox";
import {pending, shown, type Shown} from "./frames";
import {durationOf, millisecondsOf} from "./measured";

/** Of a picture that was rasterized: strands for each pixel of skin, from so many on all that there are. */
function rasterWords(strands = 1.4): string {
  const all = 100;
  return strands >= all ? "all strands" : `${strands} strands a pixel`;
}

function stageWords({stage, picture}: Shown): string {
  if (stage === "draft" || stage === "turning") return "draft";
  const passes = picture.trace?.passes ?? 0;
  if (stage === "rest" || passes === 0) return rasterWords(picture.knobs.raster?.strands);
  const samples = Math.round(picture.trace!.samples);
  return picture.trace!.end === "none" ? `strands, ${samples} samples` : `strands, ${samples} samples, done`;
}

export function Badge() {
  const seen = shown.value;
  return (
    <div class="badge" role="status" aria-live="off">
      {offline.value && <span class="badge-offline">no connection, trying again{unsent.value ? `; ${unsent.value} kept` : ""}</span>}
      {seen && <>
        <span class={`dot dot-${seen.stage}`} aria-hidden="true" />
        <span class="badge-stage">{stageWords(seen)}</span>
        <span title="Time that the server took for this picture">{durationOf(millisecondsOf(seen.picture))}</span>
        <span title="Revision of the picture">r{seen.picture.revision}</span>
        {pending.value && <span class="badge-pending">drawing…</span>}
      </>}
    </div>
  );
}
