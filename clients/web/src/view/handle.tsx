// A handle over the picture that the pointer drags and arrow keys move.
import {useRef} from "preact/hooks";
import type {Vector} from "../api/types";
import {add, scale} from "./vector";
import {projectionNow} from "./surface";

export interface HandleProps {
  at: Vector;
  label: string;
  shape?: "dot" | "arrow" | "light" | "star";
  chosen?: boolean;
  /** Text on the handle. */
  text?: string;
  /** Called during the drag; `done` is true for the last position. */
  moved: (to: Vector, done: boolean) => void;
  pressed?: () => void;
  remove?: () => void;
  /** Returns the position for a pixel; without it, the handle keeps its distance from the camera. */
  positionAt?: (x: number, y: number) => Vector | null;
}

export function Handle({at, label, shape = "dot", chosen = false, text, moved, pressed, remove, positionAt}: HandleProps) {
  const dragging = useRef(false);
  const last = useRef(at);
  const start = useRef(at);
  const projection = projectionNow();
  const pixel = projection.project(at);
  if (!pixel) return null;
  const placed = (event: PointerEvent): Vector => {
    const box = (event.currentTarget as HTMLElement).parentElement!.getBoundingClientRect();
    const [x, y] = [event.clientX - box.left, event.clientY - box.top];
    const ray = projection.ray(x, y);
    return positionAt?.(x, y) ?? add(ray.origin, scale(ray.direction, projection.distanceTo(at)));
  };
  const down = (event: PointerEvent) => {
    event.stopPropagation();
    (event.currentTarget as HTMLElement).setPointerCapture(event.pointerId);
    dragging.current = true;
    last.current = start.current = at;
    pressed?.();
  };
  const move = (event: PointerEvent) => {
    if (!dragging.current) return;
    last.current = placed(event);
    moved(last.current, false);
  };
  const up = () => {
    if (!dragging.current) return;
    dragging.current = false;
    if (last.current !== start.current) moved(last.current, true);
  };
  const key = (event: KeyboardEvent) => {
    const steps: Record<string, [number, number]> = {ArrowLeft: [-6, 0], ArrowRight: [6, 0], ArrowUp: [0, -6], ArrowDown: [0, 6]};
    const step = steps[event.key];
    if ((event.key === "Delete" || event.key === "Backspace") && remove) { event.preventDefault(); event.stopPropagation(); return remove(); }
    if (!step) return;
    event.preventDefault();
    event.stopPropagation();
    const [x, y] = [pixel[0] + step[0], pixel[1] + step[1]];
    const ray = projection.ray(x, y);
    moved(positionAt?.(x, y) ?? add(ray.origin, scale(ray.direction, projection.distanceTo(at))), true);
  };
  return (
    <button type="button" class={`handle handle-${shape}${chosen ? " handle-chosen" : ""}`} aria-label={label} title={label}
            style={{transform: `translate(${pixel[0]}px, ${pixel[1]}px)`}}
            onPointerDown={down} onPointerMove={move} onPointerUp={up} onPointerCancel={up} onKeyDown={key}>{text}</button>
  );
}
