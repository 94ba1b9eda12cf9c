// A number field. Text being typed survives when events redraw the panel. Enter accepts it, Escape discards it; both blur
// the field, so that shortcuts work again.
import {useSignal} from "@preact/signals";
import {say} from "../scene/messages";
import type {Range} from "./schema";

export const shownNumber = (value: number) => (Number.isInteger(value) ? String(value) : String(Number(value.toPrecision(3))));

interface NumberFieldProps { label: string; title?: string; value: number; range?: Range; whole?: boolean; take: (typed: number) => void }

/** Returns the nearest allowed number; null if there is none. */
function allowed(typed: number, whole: boolean, {minimum = -Infinity, maximum = Infinity, exclusiveMinimum = -Infinity}: Range): number | null {
  const held = Math.max(minimum, Math.min(maximum, whole ? Math.round(typed) : typed));
  return held > exclusiveMinimum ? held : null;
}

export function NumberField({label, title, value, range = {}, whole = false, take}: NumberFieldProps) {
  const typed = useSignal<string | null>(null);
  const accept = (number: number) => {
    const held = allowed(number, whole, range);
    if (held === null) return say(`${label}: the number must be above ${range.exclusiveMinimum}.`);
    if (held !== number) say(`${label}: ${held} is the nearest allowed number.`);
    take(held);
  };
  const change = (field: HTMLInputElement) => {
    const text = field.value, shown = shownNumber(value);
    typed.value = null;
    field.value = shown;  // until the accepted value comes back
    if (text !== "" && text !== shown && Number.isFinite(Number(text))) accept(Number(text));
  };
  const key = (event: KeyboardEvent & {currentTarget: HTMLInputElement}) => {
    if (event.key === "Escape") event.currentTarget.value = shownNumber(value);
    if (event.key === "Enter" || event.key === "Escape") event.currentTarget.blur();
  };
  return (
    <input type="number" step={whole ? 1 : "any"} aria-label={label} title={title} min={range.minimum ?? range.exclusiveMinimum} max={range.maximum}
           value={typed.value ?? shownNumber(value)} onInput={(event) => { typed.value = event.currentTarget.value; }} onKeyDown={key}
           onChange={(event) => change(event.currentTarget)} onBlur={() => { typed.value = null; }} />
  );
}
