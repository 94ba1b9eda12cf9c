// The view cube, which turns with the camera; a press on a side goes to that view.
import type {AutoView, Vector} from "../api/types";
import {axes, backward} from "./camera";
import {seen_orbit} from "./surface";
import {dot} from "./vector";
import {moveTo} from "./views";

interface Side { view: AutoView | null; label: string; normal: Vector; u: Vector; v: Vector }

const sides: Side[] = [
  {view: "front", label: "Front", normal: [0, 0, 1], u: [1, 0, 0], v: [0, 1, 0]},
  {view: "back", label: "Back", normal: [0, 0, -1], u: [-1, 0, 0], v: [0, 1, 0]},
  {view: "left", label: "Left", normal: [1, 0, 0], u: [0, 0, -1], v: [0, 1, 0]},
  {view: "right", label: "Right", normal: [-1, 0, 0], u: [0, 0, 1], v: [0, 1, 0]},
  {view: "top", label: "Top", normal: [0, 1, 0], u: [1, 0, 0], v: [0, 0, -1]},
  {view: null, label: "", normal: [0, -1, 0], u: [1, 0, 0], v: [0, 0, 1]},
];
const half = 24;

export function ViewCube() {
  const {right, up} = axes(seen_orbit.value);
  const back = backward(seen_orbit.value);
  const flat = (v: Vector) => [dot(v, right) * half, -dot(v, up) * half] as const;
  const seen = sides.filter((side) => dot(side.normal, back) > 0.02);
  return (
    <nav class="view-cube" aria-label="Views">
      <svg viewBox="-44 -44 88 88" width="88" height="88">
        {seen.map((side) => {
          const [nx, ny] = flat(side.normal), [ux, uy] = flat(side.u), [vx, vy] = flat(side.v);
          const matrix = `matrix(${ux / half} ${uy / half} ${-vx / half} ${-vy / half} ${nx} ${ny})`;
          const go = () => side.view && moveTo(side.view);
          const button = side.view ? {role: "button" as const, tabindex: 0, "aria-label": `${side.label} view`} : {};
          return (
            <g key={side.normal.join()} transform={matrix} class="cube-side" onClick={go}
               onKeyDown={(event) => { if (event.key === "Enter" || event.key === " ") go(); }} {...button}>
              <rect x={-half} y={-half} width={2 * half} height={2 * half} />
              <text y="4">{side.label}</text>
            </g>
          );
        })}
      </svg>
    </nav>
  );
}
