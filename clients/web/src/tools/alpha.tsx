// What the brush prints with each dab: a picture drawn here, or one of the artist's own. The server takes it as a picture of the scene.
import {useRef} from "preact/hooks";
import {call, scenePath} from "../api/client";
import {sayError} from "../scene/messages";
import {scene} from "../scene/session";
import {alpha} from "./state";

const side = 64;  // pixels

/** Values in [0, 1] on a grid of `across` by `down` cells, smooth between them; the same each time. */
function cells(across: number, down: number): (x: number, y: number) => number {
  const at = (i: number, j: number) => { const s = Math.sin(12.9898 * (i % across) + 78.233 * (j % down) + 0.5) * 43758.5453; return s - Math.floor(s); };
  return (x, y) => {
    const [i, j] = [Math.floor(x * across), Math.floor(y * down)];
    const [u, v] = [x * across - i, y * down - j].map((t) => t * t * (3 - 2 * t)) as [number, number];
    return (at(i, j) * (1 - u) + at(i + 1, j) * u) * (1 - v) + (at(i, j + 1) * (1 - u) + at(i + 1, j + 1) * u) * v;
  };
}
const contrast = (value: number) => Math.min(1, Math.max(0, 3 * (value - 0.5) + 0.5));

const drawn: Record<string, (x: number, y: number) => number> = {
  Streaks: ((noise) => (x: number) => contrast(noise(x, 0)))(cells(14, 1)),
  Grain: ((noise) => (x: number, y: number) => contrast(noise(x, y)))(cells(12, 12)),
  Patches: ((noise) => (x: number, y: number) => contrast(noise(x, y)))(cells(5, 5)),
};

async function pictureOf(value: (x: number, y: number) => number): Promise<Blob> {
  const canvas = new OffscreenCanvas(side, side), context = canvas.getContext("2d")!;
  const image = context.createImageData(side, side);
  for (let k = 0; k < side * side; ++k) {
    const grey = Math.round(255 * value((k % side + 0.5) / side, (Math.floor(k / side) + 0.5) / side));
    image.data.set([grey, grey, grey, 255], 4 * k);
  }
  context.putImageData(image, 0, 0);
  return canvas.convertToBlob({type: "image/png"});
}

async function take(label: string, picture: Blob) {
  const id = scene.value?.id;
  if (!id) return;
  const answer = await call(`${scenePath(id)}/pictures`, {method: "PUT", body: picture, headers: {"Content-Type": "application/octet-stream"}});
  alpha.value = {label, scene: id, picture: (await answer.json() as {picture: string}).picture};
}

export function AlphaRow() {
  const file = useRef<HTMLInputElement>(null);
  const now = alpha.value?.scene === scene.value?.id ? alpha.value?.label ?? "" : "";
  const choose = (label: string) => {
    if (label === "own") return file.current!.click();
    if (!label) alpha.value = null;
    else void pictureOf(drawn[label]!).then((picture) => take(label, picture)).catch(sayError);
  };
  const takeFile = (own: File | undefined) => { if (own) void take(own.name, own).catch(sayError); };
  return (
    <label class="row" title="Each dab prints this picture, its top to where the stroke goes: bright changes much, black nothing"><span>Alpha</span>
      <select value={now} onChange={(event) => { choose(event.currentTarget.value); event.currentTarget.value = now; }}>
        <option value="">None</option>
        {Object.keys(drawn).map((label) => <option key={label} value={label}>{label}</option>)}
        {now && !drawn[now] && <option value={now}>{now}</option>}
        <option value="own">A picture…</option>
      </select>
      <input ref={file} type="file" hidden accept="image/png,image/jpeg" onChange={(event) => { takeFile(event.currentTarget.files?.[0]); event.currentTarget.value = ""; }} />
    </label>
  );
}
