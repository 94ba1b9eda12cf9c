// One control from fast to true: what pictures at rest are made with, what that takes here and how far it is from the truth.
import type {ComponentChildren} from "preact";
import {useId, useRef} from "preact/hooks";
import {kept} from "../api/identity";
import {scene} from "../scene/session";
import {NumberField, shownNumber} from "../tools/number_field";
import {schemas, words, type Range} from "../tools/schema";
import {durationOf, measured, stopOf, type Measure, type Stop} from "../view/measured";
import {dial, trace_at_rest} from "../view/quality";
import {dialog} from "./places";

const budget_ms = kept("dial-budget", 500);
const max_error = kept("dial-error", 0.05);

const tiers = ["draft", "interactive", "detailed", "reference"] as const;
const says: Record<Stop, string> = {
  draft: "Coarse and quick", interactive: "For grooming", detailed: "Sharp, with shadows", reference: "Every strand, traced",
  budget: "The best within it", error: "The quickest within it",
};

/** "about 60 ms, error .02" */
function measureWords(measure: Measure | undefined): string {
  if (!measure) return "not drawn yet";
  const parts = measure.milliseconds === null ? [] : [`about ${durationOf(measure.milliseconds)}`];
  if (measure.error !== null) parts.push(`error ${measure.error.toFixed(3)}`);
  if (measure.noise !== null) parts.push(`noise ${measure.noise.toFixed(3)} after ${Math.round(measure.samples)} samples`);
  return parts.join(", ") || "not drawn yet";
}

function choose(stop: Stop) {
  if (stop === "budget") dial.value = {kind: "budget", milliseconds: budget_ms.value};
  else if (stop === "error") dial.value = {kind: "error", error: max_error.value};
  else dial.value = {kind: "tier", tier: stop};
}

function StopRow({stop, name, children}: {stop: Stop; name: string; children?: ComponentChildren}) {
  const id = useId();
  const chosen = stopOf(dial.value) === stop;
  return (
    <div class="dial-stop" data-chosen={chosen ? "" : undefined}>
      <input type="radio" name={name} id={id} checked={chosen} onChange={() => choose(stop)} aria-describedby={`${id}m`} />
      <label for={id}><b>{stop === "budget" ? "Time" : stop === "error" ? "Error" : words(stop)}</b> <span>{says[stop]}</span></label>
      {children}
      <small id={`${id}m`}>{measureWords(measured.value[stop])}</small>
    </div>
  );
}

/** A number with the contract's limits that chooses its stop. */
function Limit({stop, value, set, unit}: {stop: "budget" | "error"; value: number; set: (to: number) => void; unit: string}) {
  const take = (typed: number) => {
    set(typed);
    choose(stop);
  };
  return (
    <span class="dial-limit"><NumberField label={stop === "budget" ? "Milliseconds of a picture" : "Error of a picture"}
      range={limitsOf(stop === "budget" ? "budget_ms" : "max_error")} value={value} take={take} /> {unit}</span>
  );
}

function limitsOf(name: string): Range {
  const member = schemas.value["FrameRequest"]?.properties?.[name];
  return typeof member === "object" ? member : {};
}

function Card({close}: {close: () => void}) {
  const name = useId();
  return (
    <>
      <fieldset>
        <legend>Quality at rest, from fast to true</legend>
        {tiers.map((tier) => <StopRow key={tier} stop={tier} name={name} />)}
        <StopRow stop="budget" name={name}><Limit stop="budget" value={budget_ms.value} set={(to) => { budget_ms.value = to; }} unit="ms" /></StopRow>
        <StopRow stop="error" name={name}><Limit stop="error" value={max_error.value} set={(to) => { max_error.value = to; }} unit="FLIP" /></StopRow>
      </fieldset>
      <p class="help">Times are those of the newest pictures here. Error is the server's estimate: mean FLIP over the fur against the same strands, traced.</p>
      <label class="dial-trace"><input type="checkbox" checked={trace_at_rest.value} onChange={(event) => { trace_at_rest.value = event.currentTarget.checked; }} /> Trace strands once the picture rests</label>
      <button type="button" class="wide" disabled={!scene.value} onClick={() => { close(); dialog.value = "reference"; }}>Compare with the reference</button>
    </>
  );
}

export function DialControl() {
  const card = useRef<HTMLDivElement>(null);
  const id = useId();
  const stop = stopOf(dial.value);
  const measure = measured.value[stop];
  const name = stop === "budget" ? `${shownNumber(budget_ms.value)} ms` : stop === "error" ? `error ${shownNumber(max_error.value)}` : words(stop);
  const time = measure?.milliseconds != null ? ` ${durationOf(measure.milliseconds)}` : "";
  return (
    <>
      <button type="button" class="dial-button" popovertarget={id} title="Quality at rest, from fast to true" aria-label={`Quality: ${name}${time}`}>
        <span class="dial-scale" data-stop={stop} aria-hidden="true"><i /><i /><i /><i /></span>
        <b>{name}</b>{time && <small>{time}</small>}
      </button>
      <div class="dial-card" id={id} ref={card} popover="auto" role="group" aria-label="Quality"><Card close={() => card.current?.hidePopover()} /></div>
    </>
  );
}
