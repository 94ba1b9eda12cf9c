// The colour ramp from root to tip: stops on a bar. Drag a stop to move it, click beside the stops to add one, press
// Delete to remove one.
import {useSignal} from "@preact/signals";
import {useId, useRef} from "preact/hooks";
import type {Coat} from "../api/types";
import {toHex, toLinear} from "../tools/colour";
import {ColourField} from "../tools/colour_field";
import {resolved, schemas} from "../tools/schema";

type Stops = Coat["ramp"] & object;
interface Props { stops: Stops; set: (stops: Stops, done: boolean) => void }

const gap = 0.01;  // minimum distance of stops, which the contract requires to ascend
const rounded = (at: number) => Math.round(at * 1000) / 1000;
const maxStops = () => resolved(schemas.value["Coat"]?.properties?.["ramp"] as object ?? {}).maxItems ?? 4;

/** Returns the ramp's colour at a position in [0, 1]. */
function colourAt(stops: Stops, at: number): string {
  const after = stops.findIndex((stop) => stop.at >= at);
  if (after <= 0) return toHex(stops[after === 0 ? 0 : stops.length - 1]!.colour);
  const [a, b] = [stops[after - 1]!, stops[after]!];
  const t = (at - a.at) / (b.at - a.at);
  const [from, to] = [toLinear(a.colour), toLinear(b.colour)];
  return toHex(from.map((part, k) => part + (to[k]! - part) * t));
}

/** Returns a CSS gradient that interpolates in linear light, as the server does. */
function gradient(stops: Stops): string {
  const steps = Array.from({length: 33}, (_, k) => k / 32);
  return `linear-gradient(to right, ${steps.map((at) => `${colourAt(stops, at)} ${at * 100}%`).join(", ")})`;
}

function withStop(stops: Stops, at: number): {stops: Stops; index: number} | null {
  if (stops.length >= maxStops() || stops.some((stop) => Math.abs(stop.at - at) < gap)) return null;
  const next = [...stops, {at: rounded(at), colour: colourAt(stops, at)}].sort((a, b) => a.at - b.at);
  return {stops: next, index: next.findIndex((stop) => stop.at === rounded(at))};
}

const widestGap = (stops: Stops) => {
  const ends = [0, ...stops.map(({at}) => at), 1];
  const gaps = ends.slice(1).map((at, k) => ({middle: (at + ends[k]!) / 2, width: at - ends[k]!}));
  return gaps.reduce((a, b) => (b.width > a.width ? b : a)).middle;
};

export function Ramp({stops, set}: Props) {
  const chosen = useSignal(0);
  const id = useId();
  const bar = useRef<HTMLDivElement>(null);
  const at = Math.min(chosen.value, stops.length - 1);
  const stop = stops[at]!;
  const share = (event: PointerEvent) => {
    const box = bar.current!.getBoundingClientRect();
    return Math.max(0, Math.min(1, (event.clientX - box.left) / box.width));
  };
  const add = (where: number) => {
    const added = withStop(stops, where);
    if (!added) return;
    chosen.value = added.index;
    set(added.stops, true);
  };
  const remove = (index: number) => {
    if (stops.length < 2) return;
    chosen.value = Math.max(0, index - 1);
    set(stops.filter((_, k) => k !== index), true);
  };
  const colour = (value: string, done: boolean) => set(stops.map((one, k) => (k === at ? {...one, colour: value} : one)), done);
  return (
    <div class="ramp" role="group" aria-label="Colour from root to tip">
      <div class="ramp-bar" ref={bar} style={{background: gradient(stops)}} onPointerDown={(event) => { if (event.target === bar.current) add(share(event)); }}>
        {stops.map((_, k) => <Stop key={k} stops={stops} index={k} chosen={k === at} share={share} set={set} choose={() => { chosen.value = k; }} remove={() => remove(k)} />)}
      </div>
      <div class="ramp-ends" aria-hidden="true"><span>root</span><span>tip</span></div>
      <div class="row"><label for={id}>Colour at {Math.round(stop.at * 100)}%</label>
        <ColourField id={id} label={`Colour at ${Math.round(stop.at * 100)}%`} value={stop.colour} set={colour} /></div>
      <div class="buttons">
        <button type="button" disabled={stops.length >= maxStops()} onClick={() => add(widestGap(stops))}>Add a stop</button>
        <button type="button" disabled={stops.length < 2} onClick={() => remove(at)}>Delete it</button>
      </div>
    </div>
  );
}

interface StopProps extends Props { index: number; chosen: boolean; share: (event: PointerEvent) => number; choose: () => void; remove: () => void }

function Stop({stops, index, chosen, share, set, choose, remove}: StopProps) {
  const dragged = useRef<{stops: Stops; moved: boolean} | null>(null);
  const stop = stops[index]!;
  const moved = (to: number): Stops => {
    const [low, high] = [index > 0 ? stops[index - 1]!.at + gap : 0, index < stops.length - 1 ? stops[index + 1]!.at - gap : 1];
    const held = rounded(Math.max(low, Math.min(high, to)));
    return stops.map((one, k) => (k === index ? {...one, at: held} : one));
  };
  const down = (event: PointerEvent) => {
    (event.currentTarget as HTMLElement).setPointerCapture(event.pointerId);
    choose();
    dragged.current = {stops, moved: false};
  };
  const move = (event: PointerEvent) => {
    if (!dragged.current) return;
    dragged.current = {stops: moved(share(event)), moved: true};
    set(dragged.current.stops, false);
  };
  const up = () => {
    const last = dragged.current;
    dragged.current = null;
    if (last?.moved) set(last.stops, true);
  };
  const key = (event: KeyboardEvent) => {
    const step = (event.shiftKey ? 0.1 : 0.01) * ({ArrowLeft: -1, ArrowDown: -1, ArrowRight: 1, ArrowUp: 1}[event.key] ?? 0);
    if (event.key === "Delete" || event.key === "Backspace") remove();
    else if (!step) return;
    else { set(moved(stop.at + step), false); set(moved(stop.at + step), true); }
    event.preventDefault();
    event.stopPropagation();
  };
  return (
    <button type="button" class="ramp-stop" role="slider" aria-label={`Stop ${index + 1}`} aria-valuemin={0} aria-valuemax={100} aria-valuenow={Math.round(stop.at * 100)}
            aria-valuetext={`${Math.round(stop.at * 100)}% from root to tip, ${toHex(stop.colour)}`} aria-current={chosen} title="Drag to move this stop along the hair; Delete removes it"
            style={{left: `${stop.at * 100}%`, background: toHex(stop.colour)}} onFocus={choose} onPointerDown={down} onPointerMove={move} onPointerUp={up} onPointerCancel={up} onKeyDown={key} />
  );
}
