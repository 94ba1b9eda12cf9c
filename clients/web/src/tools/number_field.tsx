// A number to type. What is being typed stays when the scene's news draw the panel again.
import {useSignal} from "@preact/signals";

export const shownNumber = (value: number) => (Number.isInteger(value) ? String(value) : String(Number(value.toPrecision(3))));

export function NumberField({label, title, value, min, max, take}: {label: string; title?: string; value: number; min?: number; max?: number; take: (typed: number) => void}) {
  const typed = useSignal<string | null>(null);
  const change = (text: string) => {
    typed.value = null;
    if (text !== "" && Number.isFinite(Number(text))) take(Number(text));
  };
  return (
    <input type="number" step="any" aria-label={label} title={title} min={min} max={max} value={typed.value ?? shownNumber(value)}
           onInput={(event) => { typed.value = event.currentTarget.value; }} onBlur={() => { typed.value = null; }}
           onChange={(event) => change(event.currentTarget.value)} />
  );
}
