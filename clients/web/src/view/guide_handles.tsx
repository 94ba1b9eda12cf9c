// Guide curves and keys, drawn over the picture while their tool is current.
import {useSignal} from "@preact/signals";
import type {Vector} from "../api/types";
import {chosen, guidesOf, movePoint, removeGuide, type GuideOp} from "../tools/guides";
import {current} from "../tools/state";
import {Handle} from "./handle";
import {projectionNow, skinAt} from "./surface";

export function GuideHandles() {
  const op = current.value;
  if (op !== "flow" && op !== "interpolate") return null;
  return <GuidesOf op={op} />;
}

function GuidesOf({op}: {op: GuideOp}) {
  const dragged = useSignal<{guide: number; point: number; to: Vector} | null>(null);
  const guides = guidesOf(op).map((points, g) => points.map((point, p) =>
    (dragged.value && dragged.value.guide === g && dragged.value.point === p ? dragged.value.to : point)));
  const projection = projectionNow();
  const onSurface = (x: number, y: number) => skinAt(x, y)?.point ?? null;
  const path = (points: Vector[]) => points.map((point) => projection.project(point)?.map((n) => n.toFixed(1)).join()).filter(Boolean).join(" ");
  return (
    <div class="handles">
      <svg class="guide-lines" aria-hidden="true">{guides.map((points, g) => <polyline key={g} points={path(points)} />)}</svg>
      {guides.flatMap((points, g) => points.map((point, p) => (
        <Handle key={`${g}-${p}`} at={point} label={`${op === "flow" ? "Guide" : "Key"} ${g + 1}, point ${p + 1}; Delete removes it`}
                chosen={chosen.value.guide === g} positionAt={onSurface} pressed={() => { chosen.value = {guide: g, point: p}; }}
                remove={() => void removeGuide(op, g)}
                moved={(to, done) => {
                  dragged.value = {guide: g, point: p, to};
                  if (done) void movePoint(op, g, p, to).then(() => { dragged.value = null; });
                }} />
      )))}
    </div>
  );
}
