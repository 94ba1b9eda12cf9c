// The welcome dialog of the first visit, which explains the controls, and the placeholder while no scene is open.
import {storedSignal} from "../api/identity";
import {makeSample, preparing, samples} from "../files/samples";
import {scene} from "../scene/session";
import {panel} from "./ui_state";

const welcomed = storedSignal("welcomed", false);

const hints = [
  ["Drag on the fur", "combs it in that direction."],
  ["Drag beside it", "turns the view; the wheel zooms."],
  ["Ctrl+Z", "undoes the last step."],
] as const;

export function Welcome() {
  if (welcomed.value || !scene.value || preparing.value) return null;
  return (
    <section class="welcome" aria-label="First steps">
      <h2>First steps</h2>
      <dl>{hints.map(([what, does]) => <div key={what}><dt>{what}</dt><dd>{does}</dd></div>)}</dl>
      <button type="button" class="primary" onClick={() => { welcomed.value = true; }}>Begin</button>
    </section>
  );
}

/** Replaces the picture while no scene is open. */
export function NoScene({looked}: {looked: boolean}) {
  if (preparing.value) return <div class="no-scene" role="status"><p>{preparing.value}…</p><progress aria-label={preparing.value} /></div>;
  if (scene.value || !looked) return null;
  return (
    <div class="no-scene">
      <p>No scene is open.</p>
      <div class="pair">
        <button type="button" class="primary" onClick={() => void makeSample(samples[0]!)}>A fox</button>
        <button type="button" onClick={() => { panel.value = "files"; }}>Scenes and files</button>
      </div>
    </div>
  );
}
