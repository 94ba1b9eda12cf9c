// The quality dial, from fast to accurate: the quality of pictures at rest, with its measured time and estimated error.
import type {ComponentChildren} from "preact";
import {useId, useRef} from "preact/hooks";
import {storedSignal} from "../api/identity";
import type {Tier} from "../api/types";
import {scene} from "../scene/session";
import {NumberField, shownNumber} from "../tools/number_field";
import {schemas, type Range} from "../tools/schema";
import {durationOf, measured, stopNames, stopOf, type Measure, type Stop} from "../view/measured";
import {dial, trace_at_rest} from "../view/quality";
import {dial_pictures, drawDialPictures} from "./dial_pictures";
import {dialog} from "./ui_state";

const budget_ms = storedSignal("dial-budget", 500);
const max_error = storedSignal("dial-error", 0.05);

const tiers = ["draft", "interactive", "detailed", "reference"] as const;
const says: Record<Stop, string> = {
  draft: "Coarse and fast, for blocking out", interactive: "Sharp enough for combing", detailed: "Fine hair and soft shadows, for judging colour", reference: "Every strand traced, for final pictures",
  budget: "The best picture within", error: "The fastest picture with an error up to",
};

/** Returns text such as "about 60 ms"; "" if unknown. */
const secondsWords = (measure: Measure | undefined) => (measure?.milliseconds == null ? "" : `about ${durationOf(measure.milliseconds)}`);

/** Returns text such as "error 0.020" or "noise 0.010 after 300 samples". */
function errorWords(measure: Measure | undefined): string {
  if (measure?.noise != null) return `noise ${measure.noise.toFixed(3)} after ${Math.round(measure.samples)} samples`;
  return measure?.error == null ? "not drawn yet" : `error ${measure.error.toFixed(3)}`;
}

function choose(stop: Stop) {
  if (stop === "budget") dial.value = {kind: "budget", milliseconds: budget_ms.value};
  else if (stop === "error") dial.value = {kind: "error", error: max_error.value};
  else dial.value = {kind: "tier", tier: stop};
}

function StopRow({stop, name, children}: {stop: Stop; name: string; children?: ComponentChildren}) {
  const id = useId();
  const chosen = stopOf(dial.value) === stop;
  const picture = dial_pictures.value[stop as Tier];
  return (
    <div class="dial-stop" data-chosen={chosen ? "" : undefined}>
      <input type="radio" name={name} id={id} checked={chosen} onChange={() => choose(stop)} aria-describedby={`${id}m`} />
      {children ? null : picture ? <img src={picture} alt="" width="76" height="56" /> : <span class="dial-blank" aria-hidden="true" />}
      <label for={id}><b>{stopNames[stop]}</b> <span>{says[stop]}</span></label>
      {children}
      <small id={`${id}m`}>{secondsWords(measured.value[stop])}</small>
    </div>
  );
}

/** A number field with the contract's limits; entering a number selects its stop. */
function Limit({stop, value, set, unit}: {stop: "budget" | "error"; value: number; set: (to: number) => void; unit: string}) {
  const take = (typed: number) => {
    set(typed);
    choose(stop);
  };
  return (
    <span class="dial-limit"><NumberField label={stop === "budget" ? "Milliseconds per picture" : "Error of a picture"}
      range={limitsOf(stop === "budget" ? "budget_ms" : "max_error")} value={value} take={take} /> {unit}</span>
  );
}

function limitsOf(name: string): Range {
  const member = schemas.value["FrameRequest"]?.properties?.[name];
  return typeof member === "object" ? member : {};
}

/** Details for measurements: budgets, and the error of each quality. */
function Numbers({name}: {name: string}) {
  return (
    <details class="group">
      <summary>Limits and measurements</summary>
      <StopRow stop="budget" name={name}><Limit stop="budget" value={budget_ms.value} set={(to) => { budget_ms.value = to; }} unit="ms" /></StopRow>
      <StopRow stop="error" name={name}><Limit stop="error" value={max_error.value} set={(to) => { max_error.value = to; }} unit="FLIP" /></StopRow>
      <dl class="dial-errors">{tiers.map((tier) => <div key={tier}><dt>{stopNames[tier]}</dt><dd>{errorWords(measured.value[tier])}</dd></div>)}</dl>
      <p class="help">Times are those of your newest pictures. The error is the server's estimate: the mean difference (FLIP, 0 to 1) from a traced picture, over the fur.</p>
    </details>
  );
}

function Card({close}: {close: () => void}) {
  const name = useId();
  return (
    <>
      <fieldset>
        <legend>Picture quality</legend>
        {tiers.map((tier) => <StopRow key={tier} stop={tier} name={name} />)}
        <Numbers name={name} />
      </fieldset>
      <label class="dial-trace"><input type="checkbox" checked={trace_at_rest.value} onChange={(event) => { trace_at_rest.value = event.currentTarget.checked; }} /> Continue to Final when nothing moves</label>
      <button type="button" class="wide" disabled={!scene.value} onClick={() => { close(); dialog.value = "reference"; }}>Compare with Final</button>
    </>
  );
}

export function DialControl() {
  const card = useRef<HTMLDivElement>(null);
  const drawing = useRef(new AbortController());
  const toggled = (event: ToggleEvent) => {
    drawing.current.abort();
    if (event.newState !== "open") return;
    drawing.current = new AbortController();
    void drawDialPictures(drawing.current.signal);
  };
  const id = useId();
  const stop = stopOf(dial.value);
  const measure = measured.value[stop];
  const name = stop === "budget" ? `${shownNumber(budget_ms.value)} ms` : stop === "error" ? `error ${shownNumber(max_error.value)}` : stopNames[stop];
  const time = measure?.milliseconds != null ? ` ${durationOf(measure.milliseconds)}` : "";
  return (
    <>
      <button type="button" class="dial-button" popovertarget={id} title="Picture quality, from fast to accurate" aria-label={`Quality: ${name}${time}`}>
        <span class="dial-scale" data-stop={stop} aria-hidden="true"><i /><i /><i /><i /></span>
        <b>{name}</b>{time && <small>{time}</small>}
      </button>
      <div class="dial-card" id={id} ref={card} popover="auto" role="group" aria-label="Quality" onToggle={toggled}><Card close={() => card.current?.hidePopover()} /></div>
    </>
  );
}
