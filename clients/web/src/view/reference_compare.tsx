// Compares the dial's picture with traced strands from the same camera: as a wipe, side by side, or as a difference.
import {useSignal, type Signal} from "@preact/signals";
import {useEffect} from "preact/hooks";
import {Aborted, drawFrame, type Picture} from "../api/client";
import {page_id} from "../api/identity";
import type {FrameRequest} from "../api/types";
import {sayError} from "../scene/messages";
import {scene} from "../scene/session";
import {Dialog} from "../shell/dialog";
import {dialog} from "../shell/ui_state";
import {orbit, pinholeOf} from "./camera";
import {differenceOf, full_scale, type Difference} from "./difference";
import {durationOf, millisecondsOf} from "./measured";
import {plain_request, rest_quality} from "./quality";
import {traceToEnd} from "./trace";
import {viewport_size} from "./surface";
import {Wipe} from "./wipe";

interface Pair {
  picture: Picture; reference: Picture;
  /** Object URLs of the pictures; revoked once they are not shown. */
  left: string; right: string; map: string;
  difference: Difference;
}
type Mode = "wipe" | "beside" | "difference";

const reference_passes = 64, reference_noise = 0.004;
const modes: Record<Mode, string> = {wipe: "Wipe", beside: "Side by side", difference: "Difference"};

async function pairOf(picture: Picture, reference: Picture): Promise<Pair> {
  const difference = await differenceOf(picture.bytes, reference.bytes);
  const address = (bytes: Blob) => URL.createObjectURL(bytes);
  return {picture, reference, difference, left: address(picture.bytes), right: address(reference.bytes), map: address(difference.map)};
}

const drop = (pair: Pair | null) => [pair?.left, pair?.right, pair?.map].forEach((address) => address && URL.revokeObjectURL(address));

/** Draws the picture, then traces the reference, and shows each better one. */
async function compare(pair: Signal<Pair | null>, stop: AbortController) {
  const {width, height} = viewport_size.value;
  const request: FrameRequest = {...plain_request.value, background: "transparent", width: Math.round(width), height: Math.round(height), camera: pinholeOf(orbit.value)};
  const id = scene.value!.id;
  const picture = await drawFrame(id, {...request, ...rest_quality.value, view: `${page_id}-compared`}, null, stop.signal);
  if (!picture) return;
  const traced = {...request, quality: "interactive" as const, view: `${page_id}-reference`};
  let last = Promise.resolve();
  const seen = (reference: Picture) => {
    if (!reference.trace?.passes) return;
    last = last.then(async () => {
      const next = await pairOf(picture, reference);
      if (stop.signal.aborted) return drop(next);
      drop(pair.value);
      pair.value = next;
    });
  };
  await traceToEnd(id, traced, {passes: reference_passes, noise: reference_noise}, seen, stop.signal);
  await last;
}

function Report({pair: {picture, reference, difference}}: {pair: Pair}) {
  const {passes, samples, noise, end, grow_ms, trace_ms} = reference.trace!;
  return (
    <dl class="versus-report">
      <div><dt>Mean absolute difference, sRGB, where the model is</dt><dd>{difference.mean.toFixed(4)} <small>of 1{end === "none" ? ", so far, noise included" : ""}; largest {difference.largest.toFixed(2)}</small></dd></div>
      {picture.estimate && <div><dt>The server's estimate, mean FLIP against traced strands</dt><dd>{picture.estimate.error.toFixed(3)}</dd></div>}
      <div><dt>This picture</dt><dd>{picture.redrawn > 0 ? durationOf(millisecondsOf(picture)) : "cached"}</dd></div>
      <div><dt>Final{end === "none" ? `, pass ${passes} of at most ${reference_passes}` : ""}</dt><dd>{durationOf(grow_ms + trace_ms)} <small>{Math.round(samples)} samples, noise {noise.toFixed(3)}</small></dd></div>
    </dl>
  );
}

function Pictures({pair, mode}: {pair: Pair; mode: Mode}) {
  if (mode === "wipe") return <Wipe left={pair.left} right={pair.right} left_label="This picture" right_label="Final" />;
  if (mode === "beside") return <div class="versus-beside"><figure><img src={pair.left} alt="This picture" /><figcaption>This picture</figcaption></figure><figure><img src={pair.right} alt="Final" /><figcaption>Final</figcaption></figure></div>;
  return (
    <figure class="versus-map"><img src={pair.map} alt="Where the pictures differ" />
      <figcaption><span>0</span><span class="versus-scale" aria-hidden="true" /><span>{full_scale} and more: mean of red, green and blue</span></figcaption></figure>
  );
}

function Body() {
  const pair = useSignal<Pair | null>(null);
  const mode = useSignal<Mode>("wipe");
  useEffect(() => {
    const stop = new AbortController();
    compare(pair, stop).catch((error: unknown) => { if (!(error instanceof Aborted)) sayError(error); });
    return () => { stop.abort(); drop(pair.value); };
  }, []);
  return (
    <div class="versus">
      <div class="chips" role="group" aria-label="How to compare">
        {(Object.keys(modes) as Mode[]).map((one) => <button key={one} type="button" class="chip" aria-pressed={mode.value === one} onClick={() => { mode.value = one; }}>{modes[one]}</button>)}
      </div>
      {pair.value ? <><Pictures pair={pair.value} mode={mode.value} /><Report pair={pair.value} /></>
        : <div class="versus-wait" role="status"><p>Drawing the picture, then tracing strands…</p><progress aria-label="Drawing" /></div>}
    </div>
  );
}

export function ReferenceCompare() {
  if (dialog.value !== "reference" || !scene.value) return null;
  return <Dialog title="Compared with Final" close={() => { dialog.value = null; }}><Body /></Dialog>;
}
