// Forms made from the contract: one row for each member, with its range, unit, default and explanation.
import type {ComponentChildren} from "preact";
import {useId} from "preact/hooks";
import {NumberField, shownNumber} from "./number_field";
import {membersOf, plain, resolved, unitOf, words, type Member, type Schema} from "./schema";
import {ColourField} from "./colour_field";

type Values = Record<string, unknown>;
export interface FormProps {
  members: Member[];
  values: Values;
  /** `done` is false while a slider is dragged. */
  set: (name: string, value: unknown, done: boolean) => void;
  hidden?: Set<string> | undefined;
}

/** Returns a usable range for a slider; the contract's limits may be as large as 1e27, just to keep numbers finite. */
export function sliderEnd(member: Member): {min: number; max: number; step: number; curve: number} {
  const {minimum = 0, maximum = 1} = member.schema;
  const usual = typeof member.fallback === "number" && member.fallback > 0 ? member.fallback : 0.1;
  const max = maximum <= 360 ? maximum : Math.max(usual * 10, 1);
  const min = minimum < -360 ? -max : minimum;
  const whole = member.kind === "integer";
  const curve = !whole && min === 0 && usual > 0 && usual < max / 8 ? 3 : 1;  // finer near 0 if the default is small
  return {min, max, step: whole ? 1 : (max - min) / 200, curve};
}


/** Returns functions that convert between a member's number and the slider's position in [0, 1]. */
export function scaleOf(member: Member) {
  const {min, max, step, curve} = sliderEnd(member);
  const whole = member.kind === "integer";
  return {
    step: whole ? step / (max - min) : 0.005,
    shareOf: (number: number) => Math.pow(Math.max(0, (Math.min(number, max) - min) / (max - min)), 1 / curve),
    numberOf: (share: number) => {
      const raw = min + (max - min) * Math.pow(share, curve);
      return whole ? Math.round(raw) : Number(raw.toPrecision(3));
    },
  };
}

function NumberRow({member, value, set, units}: {member: Member; value: unknown; set: (value: number, done: boolean) => void; units: unknown}) {
  const id = useId();
  const {step, shareOf, numberOf} = scaleOf(member);
  const number = typeof value === "number" ? value : Number(member.fallback ?? member.schema.minimum ?? 0);
  const slide = (event: Event, done: boolean) => set(numberOf(Number((event.currentTarget as HTMLInputElement).value)), done);
  const unit = unitOf(member, units);
  return (
    <div class="row" title={plain(member.description)}>
      <label for={id}>{words(member.name)}</label>
      <input id={id} type="range" min="0" max="1" step={step} value={shareOf(number)} aria-valuetext={`${shownNumber(number)} ${unit}`}
             onInput={(event) => slide(event, false)} onChange={(event) => slide(event, true)} />
      <NumberField label={`${words(member.name)}, as a number`} value={number} range={member.schema}
                   whole={member.kind === "integer"} take={(typed) => set(typed, true)} />
      <span class="unit">{unit}</span>
    </div>
  );
}

function Row({member, children}: {member: Member; children: (id: string) => ComponentChildren}) {
  const id = useId();
  return <div class="row" title={plain(member.description)}><label for={id}>{words(member.name)}</label>{children(id)}</div>;
}

const options = (member: Member) => (member.kind === "choices" ? resolved(member.schema.items ?? {}).enum : member.schema.enum) as string[];

function VectorInputs({member, value, set}: {member: Member; value: unknown; set: (value: unknown, done: boolean) => void}) {
  const numbers = (Array.isArray(value) ? value : member.fallback ?? [0, 0, 0]) as number[];
  const range = resolved(member.schema.items ?? {});
  return (
    <div class="row vector" title={plain(member.description)} role="group" aria-label={words(member.name)}>
      <span>{words(member.name)}</span>
      {["x", "y", "z"].map((axis, k) => (
        <NumberField key={axis} label={`${words(member.name)} ${axis}`} value={numbers[k] ?? 0} range={range}
                     take={(typed) => set(numbers.map((old, j) => (j === k ? typed : old)), true)} />
      ))}
    </div>
  );
}

function Choices({member, value, set}: {member: Member; value: unknown; set: (value: unknown, done: boolean) => void}) {
  const chosen = (Array.isArray(value) ? value : []) as string[];
  const toggle = (one: string) => {
    const next = chosen.includes(one) ? chosen.filter((other) => other !== one) : [...chosen, one];
    if (next.length) set(next, true);
  };
  return (
    <div class="row chips" role="group" aria-label={words(member.name)} title={plain(member.description)}>
      <span>{words(member.name)}</span>
      <div>{options(member).map((one) => (
        <button key={one} type="button" class="chip" aria-pressed={chosen.includes(one)} onClick={() => toggle(one)}>{words(one)}</button>
      ))}</div>
    </div>
  );
}

/** A field for a number, or for a word such as one that leaves the choice to the server. */
function NumberOrWord({member, value, set, units}: {member: Member; value: unknown; set: (value: unknown, done: boolean) => void; units: unknown}) {
  const [number, word] = member.schema.oneOf! as [Schema, Schema];
  const free = typeof value === "number";
  const middle = ((number.minimum ?? 0) + (number.maximum ?? 1)) / 2;
  return (
    <>
      <Row member={member}>{(id) => (
        <select id={id} value={free ? "number" : "word"} onChange={(event) => set(event.currentTarget.value === "word" ? word.const : middle, true)}>
          <option value="word">{words(String(word.const))}</option><option value="number">By hand</option>
        </select>)}</Row>
      {free && <NumberRow member={{...member, schema: number, kind: "number", fallback: middle}} value={value} set={set} units={units} />}
    </>
  );
}

function Fields({member, value, set}: {member: Member; value: unknown; set: (value: unknown, done: boolean) => void}) {
  const inner = (value ?? {}) as Values;
  return (
    <details class="group">
      <summary>{words(member.name)}</summary>
      <Form members={membersOf(member.schema)} values={inner} set={(name, changed, done) => set({...inner, [name]: changed}, done)} />
    </details>
  );
}

function MemberRow({member, value, set, units}: {member: Member; value: unknown; set: (value: unknown, done: boolean) => void; units: unknown}) {
  switch (member.kind) {
    case "number": case "integer":
      return <NumberRow member={member} value={value} set={set} units={units} />;
    case "boolean":
      return <Row member={member}>{(id) => <input id={id} type="checkbox" checked={Boolean(value ?? member.fallback)} onChange={(event) => set(event.currentTarget.checked, true)} />}</Row>;
    case "choice":
      return <Row member={member}>{(id) => (
        <select id={id} value={String(value ?? member.fallback ?? "")} onChange={(event) => set(event.currentTarget.value || undefined, true)}>
          {member.fallback === undefined && !member.required && <option value="">Automatic</option>}
          {options(member).map((one) => <option key={one} value={one}>{words(one)}</option>)}
        </select>)}</Row>;
    case "colour":
      return <Row member={member}>{(id) => <ColourField id={id} label={words(member.name)} value={value ?? member.fallback} set={set} />}</Row>;
    case "text":
      return <Row member={member}>{(id) => <input id={id} type="text" value={String(value ?? "")} maxLength={member.schema.maxLength ?? 200} onChange={(event) => set(event.currentTarget.value, true)} />}</Row>;
    case "number_or_word": return <NumberOrWord member={member} value={value} set={set} units={units} />;
    case "vector": return <VectorInputs member={member} value={value} set={set} />;
    case "choices": return <Choices member={member} value={value} set={set} />;
    case "object": return <Fields member={member} value={value} set={set} />;
    default: return null;  // lists have their own panels
  }
}

export function Form({members, values, set, hidden}: FormProps) {
  return (
    <div class="form">
      {members.filter((member) => !hidden?.has(member.name)).map((member) => (
        <MemberRow key={member.name} member={member} value={values[member.name] ?? member.fallback} units={values["units"]}
                   set={(value, done) => set(member.name, value, done)} />
      ))}
    </div>
  );
}
