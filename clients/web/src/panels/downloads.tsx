// The panel for downloads: pictures, maps and steps.
import {signal} from "@preact/signals";
import {useId} from "preact/hooks";
import {storedSignal} from "../api/identity";
import {aovNames, downloadLog, downloadMap, downloadPicture, downloadRecipe, making, pixelsOf, sizes, type Size} from "../files/download";
import {beforeAndAfter, contactSheet, turntable} from "../files/sheets";
import {scene} from "../scene/session";
import {aovWords} from "../tools/artist_words";
import {Form} from "../tools/form";
import {membersOf, schemas, words} from "../tools/schema";
import type {Values} from "../tools/state";

const size = storedSignal<Size>("picture-size", "1x");
const transparent = storedSignal("picture-transparent", false);
const aovs = storedSignal<string[]>("picture-aovs", []);
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

const chosenAovs = () => aovNames().filter((name) => aovs.value.includes(name));

/** Chooses the AOVs that an EXR holds beside the picture. */
function Aovs() {
  const now = chosenAovs();
  const choose = (name: string, on: boolean) => { aovs.value = on ? [...aovs.value, name] : aovs.value.filter((one) => one !== name); };
  return (
    <details class="group">
      <summary>AOVs in the EXR{now.length > 0 ? `: ${now.length}` : ""}</summary>
      <p class="help">Extra channels for compositing. Final has neither Strand number nor Root position.</p>
      {aovNames().map((name) => (
        <label key={name} class="check"><input type="checkbox" checked={now.includes(name)} onChange={(event) => choose(name, event.currentTarget.checked)} /> {aovWords[name] ?? words(name)}</label>
      ))}
    </details>
  );
}

function Pictures({busy}: {busy: boolean}) {
  const id = useId();
  const {width, height} = pixelsOf(size.value);
  return (
    <>
      <div class="row"><label for={`${id}s`}>Size</label>
        <select id={`${id}s`} value={size.value} onChange={(event) => { size.value = event.currentTarget.value as Size; }}>
          {sizes.map((one) => <option key={one} value={one}>{one === "1x" ? "as on the screen" : one === "2x" ? "twice the screen" : "4K wide"}</option>)}
        </select>
      </div>
      <div class="row"><label for={`${id}t`}>Transparent</label><input id={`${id}t`} type="checkbox" checked={transparent.value} onChange={(event) => { transparent.value = event.currentTarget.checked; }} /></div>
      <p class="help">The picture has {width} x {height} pixels and the quality of the dial. EXR has linear light and no background.</p>
      <div class="pair">
        <button type="button" disabled={busy} onClick={() => void downloadPicture("png", size.value, {transparent: transparent.value})}>PNG</button>
        <button type="button" disabled={busy} onClick={() => void downloadPicture("exr", size.value, {transparent: true, aovs: chosenAovs()})}>EXR</button>
      </div>
      <Aovs />
    </>
  );
}

/** Buttons for sheets and films to show to others. */
function Sheets({busy}: {busy: boolean}) {
  return (
    <div class="sheets" role="group" aria-label="Sheets and films">
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
      <p class="help">A map holds one property of the fur, such as its length, as a picture for other programs. It uses the model's texture coordinates.</p>
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
      <p class="help">These files hold the steps of the groom. To repeat them, drop a file on this page or use <code>pelage run</code>.</p>
      <div class="pair">
        <button type="button" disabled={busy} onClick={() => void downloadLog()}>Log (lines)</button>
        <button type="button" disabled={busy} onClick={() => void downloadRecipe()}>Recipe</button>
      </div>
    </section>
  );
}
