// A pie menu of the most used tools around the pointer: hold Space, move towards one, release.
import {signal} from "@preact/signals";
import type {Op} from "../api/types";
import {toolOf} from "../tools/catalogue";
import {ToolIcon} from "../tools/icons";
import {current} from "../tools/state";

const offered: Op[] = ["comb", "smooth", "length", "lift", "clump", "paint", "trim", "noise"];  // clockwise from the top
const radius = 106, dead = 26;  // pixels

/** Centre of the menu in the picture, in pixels; null while it is closed. */
export const pie = signal<[number, number] | null>(null);
const chosen = signal<Op | null>(null);

/** Position of the pointer in the picture, in pixels. */
let pointer: [number, number] | null = null;

export function openPie() {
  if (pie.value || !pointer) return;
  chosen.value = null;
  pie.value = pointer;
}

/** Closes the menu and selects the tool that the pointer moved to. */
export function closePie() {
  if (pie.value && chosen.value) current.value = chosen.value;
  pie.value = null;
}

/** Handles a pointer move. Returns true if the menu is open and used it. */
export function movePie(at: [number, number] | null): boolean {
  pointer = at;
  if (!pie.value || !at) return false;
  const [x, y] = [at[0] - pie.value[0], at[1] - pie.value[1]];
  const turn = Math.atan2(x, -y) / (2 * Math.PI);
  chosen.value = Math.hypot(x, y) < dead ? null : offered[Math.round(((turn + 1) % 1) * offered.length) % offered.length]!;
  return true;
}

export function PieMenu() {
  if (!pie.value) return null;
  const [x, y] = pie.value;
  return (
    <div class="pie" role="menu" aria-label="Tools" style={{left: `${x}px`, top: `${y}px`}}>
      {offered.map((op, k) => {
        const angle = (2 * Math.PI * k) / offered.length;
        const at = {left: `${radius * Math.sin(angle)}px`, top: `${-radius * Math.cos(angle)}px`};
        return <div key={op} class="pie-tool" role="menuitemradio" aria-checked={chosen.value === op} style={at}><ToolIcon op={op} /><span>{toolOf(op)?.name}</span></div>;
      })}
    </div>
  );
}
