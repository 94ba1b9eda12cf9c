// A wipe between two pictures of the same size, with a divider that the pointer or the arrow keys move.
import {useSignal} from "@preact/signals";
import {useRef} from "preact/hooks";

export interface WipeProps {
  /** URLs of the pictures. */
  left: string;
  right: string;
  left_label: string;
  right_label: string;
}

const key_step = 2;        // percent
const large_key_step = 10;

export function Wipe({left, right, left_label, right_label}: WipeProps) {
  const box = useRef<HTMLDivElement>(null);
  const share = useSignal(50);
  const move = (event: PointerEvent) => {
    const {left: start, width} = box.current!.getBoundingClientRect();
    share.value = Math.max(0, Math.min(100, ((event.clientX - start) / width) * 100));
  };
  const down = (event: PointerEvent) => {
    if (event.button !== 0) return;
    box.current!.setPointerCapture(event.pointerId);
    move(event);
  };
  const dragged = (event: PointerEvent) => { if (box.current!.hasPointerCapture(event.pointerId)) move(event); };
  const press = (event: KeyboardEvent) => {
    const step = event.shiftKey ? large_key_step : key_step;
    const to = {ArrowLeft: share.value - step, ArrowDown: share.value - step, ArrowRight: share.value + step, ArrowUp: share.value + step, Home: 0, End: 100}[event.key];
    if (to === undefined) return;
    event.preventDefault();
    event.stopPropagation();
    share.value = Math.max(0, Math.min(100, to));
  };
  return (
    <div class="wipe" ref={box} onPointerDown={down} onPointerMove={dragged}>
      <img src={right} alt={right_label} draggable={false} />
      <img src={left} alt={left_label} draggable={false} style={{clipPath: `inset(0 ${100 - share.value}% 0 0)`}} />
      <span class="wipe-label wipe-left" aria-hidden="true">{left_label}</span>
      <span class="wipe-label wipe-right" aria-hidden="true">{right_label}</span>
      <div class="wipe-divider" role="slider" tabIndex={0} style={{left: `${share.value}%`}} aria-label={`Divider between ${left_label} and ${right_label}`}
           aria-valuemin={0} aria-valuemax={100} aria-valuenow={Math.round(share.value)} aria-valuetext={`${Math.round(share.value)}% ${left_label}`} onKeyDown={press} />
    </div>
  );
}
