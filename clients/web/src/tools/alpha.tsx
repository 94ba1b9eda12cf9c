// The brush alpha, a picture that modulates each dab: drawn here or chosen by the user. It is uploaded as a picture of the
// scene.
import {useRef} from "preact/hooks";
import {call, scenePath} from "../api/client";
import {sayError} from "../scene/messages";
import {scene} from "../scene/session";
import {alpha} from "./state";

const drawn = ["Streaks", "Grain", "Patches"];

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
    else void import("./alpha_pictures").then(({pictureOf}) => pictureOf(label)).then((picture) => take(label, picture)).catch(sayError);
  };
  const takeFile = (own: File | undefined) => { if (own) void take(own.name, own).catch(sayError); };
  return (
    <label class="row" title="Each dab applies this picture, with its top in the direction of the stroke. Bright pixels change the fur, black ones do not."><span>Alpha</span>
      <select value={now} onChange={(event) => { choose(event.currentTarget.value); event.currentTarget.value = now; }}>
        <option value="">None</option>
        {drawn.map((label) => <option key={label} value={label}>{label}</option>)}
        {now && !drawn.includes(now) && <option value={now}>{now}</option>}
        <option value="own">A picture…</option>
      </select>
      <input ref={file} type="file" hidden accept="image/png,image/jpeg" onChange={(event) => { takeFile(event.currentTarget.files?.[0]); event.currentTarget.value = ""; }} />
    </label>
  );
}
