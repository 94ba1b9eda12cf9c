// The badge on the picture: its quality, the progress of tracing, and whether a better picture is coming.
import {offline, unsent} from "../api/outbox";
import {pending, shown, tracing, type Shown} from "./frames";
import {durationOf, millisecondsOf, stopNames, stopOf} from "./measured";

const passesOf = ({picture}: Shown) => picture.trace?.passes ?? 0;

function stageWords(seen: Shown): string {
  if (seen.stage === "draft" || seen.stage === "turning") return stopNames.draft;
  if (seen.stage === "rest") return stopNames[stopOf(seen.dial)];
  return passesOf(seen) ? stopNames.reference : stopNames[stopOf(seen.dial)];
}

/** Details for measurements: how the picture was drawn, how long it took, and which revision it shows. */
function details({stage, picture}: Shown): string {
  const samples = picture.trace ? `${Math.round(picture.trace.samples)} samples per pixel` : `${picture.knobs.raster?.strands ?? 1.4} strands per pixel`;
  return `${stage === "traced" ? `Traced, ${samples}` : `Rasterized, ${samples}`}; drawn in ${durationOf(millisecondsOf(picture))}; revision ${picture.revision}`;
}

function progressWords(seen: Shown | null): string {
  if (!pending.value) return "";
  const is_tracing = seen?.stage === "traced" && seen.picture.trace?.end === "none" && passesOf(seen) > 0;
  return is_tracing ? `${passesOf(seen)} of ${tracing.passes}, drawing…` : "drawing…";
}

export function Badge() {
  const seen = shown.value;
  return (
    <div class="badge" role="status" aria-live="off">
      {offline.value && <span class="badge-offline">no connection, trying again{unsent.value ? `; changes waiting: ${unsent.value}` : ""}</span>}
      {seen && <>
        <span class={`dot dot-${seen.stage}`} aria-hidden="true" />
        <span class="badge-stage" title={details(seen)}>{stageWords(seen)}</span>
        <span class="badge-pending">{progressWords(seen)}</span>
      </>}
    </div>
  );
}
