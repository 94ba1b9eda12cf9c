// The files panel: scenes, models from files, samples and downloads.
import {useEffect} from "preact/hooks";
import {sayError} from "../scene/messages";
import {listScenes, scene} from "../scene/session";
import {turnModel, turns} from "../scene/turn";
import {importing, take} from "../files/import";
import {model_endings} from "../files/plan";
import {makeSample, preparing, samples} from "../files/samples";
import {takeChosen} from "../files/take";
import {Downloads} from "./downloads";
import {ImportCard} from "./import_card";
import {SceneList} from "./scene_list";

const accept = [...model_endings.map((one) => `.${one}`), ".bin", ".mtl", ".png", ".jpg", ".jpeg", ".json", ".jsonl"].join(",");

function choose(folder: boolean) {
  const input = document.createElement("input");
  input.type = "file";
  input.multiple = true;
  if (folder) input.webkitdirectory = true;
  else input.accept = accept;
  input.onchange = () => { if (input.files) void take(takeChosen(input.files)); };
  input.click();
}

function OpenFiles() {
  return (
    <div class="open-files">
      <h2>Open your model</h2>
      <div class="pair">
        <button type="button" class="wide" onClick={() => choose(false)}>Files…</button>
        <button type="button" class="wide" onClick={() => choose(true)}>Folder…</button>
      </div>
      <p class="help">You can also drop files anywhere on the page: {model_endings.join(", ")}, with their pictures. A recipe (.json, .jsonl) runs on the open scene.</p>
    </div>
  );
}

/** Buttons that turn a model that lies on its side or faces the wrong direction. */
function Turn() {
  if (!scene.value) return null;
  return (
    <details class="group"><summary>Turn the model</summary>
      <div class="pair">
        {turns.map((turn) => <button key={turn.says} type="button" title={turn.title} onClick={() => void turnModel(turn)}>{turn.says}</button>)}
      </div>
      <p class="help">Each press turns the model by 90 degrees, with its fur, mask, layers and eyes. Afterwards neither the turn nor earlier steps can be undone.</p>
    </details>
  );
}

function Samples() {
  return (
    <section>
      <h3>Samples</h3>
      <p class="help">Each sample opens a new scene with a groomed creature.</p>
      <div class="chips presets" role="group" aria-label="Samples">
        {samples.map((sample) => <button key={sample.name} type="button" class="chip" disabled={preparing.value !== ""} onClick={() => void makeSample(sample)}>{sample.name}</button>)}
      </div>
    </section>
  );
}

export function FilesPanel() {
  useEffect(() => { listScenes().catch(sayError); }, []);
  return (
    <>
      {importing.value && <ImportCard now={importing.value} />}
      <OpenFiles />
      <Turn />
      <Downloads />
      <Samples />
      <SceneList />
    </>
  );
}
