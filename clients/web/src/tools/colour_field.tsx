// A colour picker: a wheel with a brightness slider, swatches, a text field, and an eyedropper that samples the fur.
import {useEffect, useId, useRef} from "preact/hooks";
import {storedSignal} from "../api/identity";
import {pending_pick} from "../view/surface";
import {view} from "../view/viewport";
import {fromHsv, toHex, toHsv, type Hsv} from "./colour";

interface Props { id: string; label: string; value: unknown; set: (value: string, done: boolean) => void }

const side = 168;  // width of the wheel in CSS pixels
/** Recent colours, newest first. */
const swatches = storedSignal<string[]>("swatches", ["#f2e6d8", "#c98a4b", "#8a4b22", "#4a2d1c", "#1d1512", "#e9b08a", "#9a9a9a", "#ffffff"]);
const max_swatches = 16;

function remember(colour: string) {
  swatches.value = [colour, ...swatches.value.filter((one) => one !== colour)].slice(0, max_swatches);
}

/** Paints the wheel: hue by angle, saturation by radius, at the colour's brightness. */
function paintWheel(canvas: HTMLCanvasElement, brightness: number) {
  const pen = canvas.getContext("2d")!, half = canvas.width / 2;
  const picture = pen.createImageData(canvas.width, canvas.height);
  for (let y = 0, at = 0; y < canvas.height; ++y) {
    for (let x = 0; x < canvas.width; ++x, at += 4) {
      const [dx, dy] = [(x + 0.5 - half) / half, (y + 0.5 - half) / half], far = Math.hypot(dx, dy);
      if (far > 1) continue;
      const hex = fromHsv({hue: (Math.atan2(dy, dx) / (2 * Math.PI) + 1) % 1, saturation: far, brightness});
      for (let k = 0; k < 3; ++k) picture.data[at + k] = parseInt(hex.slice(1 + 2 * k, 3 + 2 * k), 16);
      picture.data[at + 3] = 255 * Math.min(1, (1 - far) * half);
    }
  }
  pen.putImageData(picture, 0, 0);
}

function Wheel({now, set}: {now: Hsv; set: (next: Hsv, done: boolean) => void}) {
  const canvas = useRef<HTMLCanvasElement>(null);
  useEffect(() => paintWheel(canvas.current!, Math.max(0.25, now.brightness)), [now.brightness]);
  const at = (event: PointerEvent): Hsv => {
    const box = canvas.current!.getBoundingClientRect();
    const [x, y] = [(event.clientX - box.left) / box.width * 2 - 1, (event.clientY - box.top) / box.height * 2 - 1];
    return {...now, hue: (Math.atan2(y, x) / (2 * Math.PI) + 1) % 1, saturation: Math.min(1, Math.hypot(x, y))};
  };
  const down = (event: PointerEvent) => { canvas.current!.setPointerCapture(event.pointerId); set(at(event), false); };
  const move = (event: PointerEvent) => { if (canvas.current!.hasPointerCapture(event.pointerId)) set(at(event), false); };
  const angle = 2 * Math.PI * now.hue, dot = {left: `${50 + 50 * now.saturation * Math.cos(angle)}%`, top: `${50 + 50 * now.saturation * Math.sin(angle)}%`};
  return (
    <div class="colour-wheel">
      <canvas ref={canvas} width={side} height={side} aria-hidden="true" onPointerDown={down} onPointerMove={move} onPointerUp={(event) => set(at(event), true)} />
      <i style={dot} aria-hidden="true" />
    </div>
  );
}

function Share({label, value, set}: {label: string; value: number; set: (to: number, done: boolean) => void}) {
  const to = (event: Event) => Number((event.currentTarget as HTMLInputElement).value);
  return <label class="colour-share"><span>{label}</span><input type="range" min="0" max="1" step="0.01" value={value} onInput={(event) => set(to(event), false)} onChange={(event) => set(to(event), true)} /></label>;
}

export function ColourField({id, label, value, set}: Props) {
  const card = useRef<HTMLDivElement>(null);
  const card_id = useId();
  const hex = toHex(value), now = toHsv(hex);
  const take = (colour: string, done: boolean) => {
    if (done) remember(colour);
    set(colour, done);
  };
  const change = (part: Partial<Hsv>, done: boolean) => take(fromHsv({...now, ...part}), done);
  const drop = () => {
    card.current!.hidePopover();
    pending_pick.value = {says: "Press on the fur to pick its colour.", take: (_, pixel) => { const seen = view.value?.colourAt(...pixel); if (seen) take(seen, true); }};
  };
  const typed = (event: Event & {currentTarget: HTMLInputElement}) => {
    const text = event.currentTarget.value.trim().replace(/^#?/, "#");
    if (/^#[0-9a-f]{6}$/i.test(text)) take(text.toLowerCase(), true);
    event.currentTarget.value = hex;
  };
  return (
    <>
      <button type="button" id={id} class="colour-button" style={{background: hex}} popovertarget={card_id} aria-label={`${label}: ${hex}`} />
      <div class="colour-card" id={card_id} ref={card} popover="auto" role="group" aria-label={label}>
        <Wheel now={now} set={(next, done) => take(fromHsv(next), done)} />
        <Share label="Hue" value={now.hue} set={(hue, done) => change({hue}, done)} />
        <Share label="Saturation" value={now.saturation} set={(saturation, done) => change({saturation}, done)} />
        <Share label="Brightness" value={now.brightness} set={(brightness, done) => change({brightness}, done)} />
        <div class="colour-line"><input type="text" aria-label={`${label}, as #rrggbb`} value={hex} maxLength={7} onChange={typed} /><button type="button" onClick={drop}>From the fur</button></div>
        <div class="swatches" role="group" aria-label="Swatches">{swatches.value.map((one) => <button key={one} type="button" style={{background: one}} aria-label={one} aria-pressed={one === hex} onClick={() => take(one, true)} />)}</div>
      </div>
    </>
  );
}
