// The panel for downloads: pictures, maps and steps.
import {signal} from "@preact/signals";
import {useId} from "preact/hooks";
import {storedSignal} from "../api/identity";
import {downloadLog, downloadMap, downloadPicture, downloadRecipe, making, pixelsOf, sizes, type Size} from "../files/download";
import {beforeAndAfter, contactSheet, turntable} from "../files/sheets";
import {scene} from "../scene/session";
import {Form} from "../tools/form";
import {membersOf, schemas} from "../tools/schema";
import type {Values} from "../tools/state";

const size = storedSignal<Size>("picture-size", "1x");
const transparent = storedSignal("picture-transparent", false);
const map = signal<Values>({field: "length"});

function Progress() {
  const now = making.value;
  if (!now) return null;
  return (
    <div class="card" role="group" aria-label="Download">
      <p role="status">{now.says}</p>
      <progress aria-label={now.says} max={1} {...(now.share === null ? {} : {value: now.share})} />
      <button type="button" onClick={() => now.stop.abort()}>Stop</button>
    </div>
  );
}

function Pictures({busy}: {busy: boolean}) {
  const id = useId();
  const {width, height} = pixelsOf(size.value);
  return (
    <>
      <div class="row"><label for={`${id}s`}>Size</label>
        <select id={`${id}s`} value={size.value} onChange={(event) => { size.value = event.currentTarget.value as Size; }}>
          {sizes.map((one) => <option key={one} value={one}>{one === "1x" ? "as seen" : one === "2x" ? "twice" : "4K wide"}</option>)}
        </select>
      </div>
      <div class="row"><label for={`${id}t`}>Transparent</label><input id={`${id}t`} type="checkbox" checked={transparent.value} onChange={(event) => { transparent.value = event.currentTarget.checked; }} /></div>
      <p class="help">{width} x {height} pixels, with the quality of the dial. EXR holds linear light without background.</p>
      <div class="pair">
        <button type="button" disabled={busy} onClick={() => void downloadPicture("png", size.value, transparent.value)}>PNG</button>
        <button type="button" disabled={busy} onClick={() => void downloadPicture("exr", size.value, true)}>EXR</button>
      </div>
    </>
  );
}

/** Buttons for sheets and films to show to others. */
function Sheets({busy}: {busy: boolean}) {
  return (
    <div class="sheets" role="group" aria-label="To show">
      <button type="button" disabled={busy} onClick={() => void contactSheet()}>Contact sheet</button>
      <button type="button" disabled={busy} onClick={() => void beforeAndAfter()}>Before and after</button>
      <button type="button" disabled={busy} onClick={() => void turntable()}>Turntable</button>
    </div>
  );
}

function Maps({busy}: {busy: boolean}) {
  const members = membersOf(schemas.value["MapRequest"] ?? {});
  return (
    <details class="group">
      <summary>Maps of the groom</summary>
      <p class="help">A field as a picture through the model's texture coordinates, for other programs.</p>
      <Form members={members} values={map.value} set={(name, value) => { map.value = {...map.value, [name]: value}; }} />
      <button type="button" class="wide" disabled={busy} onClick={() => void downloadMap(map.value)}>Map</button>
    </details>
  );
}

export function Downloads() {
  const busy = making.value !== null || !scene.value;
  return (
    <section>
      <h3>Download</h3>
      <Progress />
      <Pictures busy={busy} />
      <Sheets busy={busy} />
      <Maps busy={busy} />
      <p class="help">The steps of the groom, to do them again with <code>pelage run</code> or by dropping them here.</p>
      <div class="pair">
        <button type="button" disabled={busy} onClick={() => void downloadLog()}>Log (lines)</button>
        <button type="button" disabled={busy} onClick={() => void downloadRecipe()}>Recipe</button>
      </div>
    </section>
  );
}
