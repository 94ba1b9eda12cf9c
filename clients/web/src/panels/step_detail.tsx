// The actions on one step: compare, branch, name, copy, change and drop.
import {useSignal} from "@preact/signals";
import {useEffect} from "preact/hooks";
import {branchScene, compareRevisions} from "../api/client";
import {token} from "../api/identity";
import type {Comparison} from "../api/types";
import {copyText, copy_forms, type CopyForm} from "../scene/copy_as";
import {say, sayError} from "../scene/messages";
import {listScenes, openScene, revision, scene} from "../scene/session";
import {present, fullCommands, type Step} from "../scene/steps";
import {stepWords, vertices} from "../scene/step_words";
import {compared} from "../view/compared";
import {NameCheckpoint} from "./checkpoints";
import {copyToClipboard} from "./copy_dialog";
import {StepForm} from "./step_form";

async function branchAt(step: Step) {
  const open = scene.value;
  if (!open) return;
  try {
    const made = await branchScene(open.id, {name: `${open.name.slice(0, 150)}, ${stepWords(step)}`, revision: step.last});
    await listScenes();
    await openScene(made.id);
    say(`The branch ${made.name} is open.`);
  } catch (error) {
    sayError(error);
  }
}

function copyStep(form: CopyForm, label: string, step: Step) {
  const open = scene.value;
  if (!open) return;
  const text = copyText(form, {commands: fullCommands(step), scene: open, origin: location.origin, needs_token: token.value !== ""});
  void copyToClipboard(text, `this step as ${label}`);
}

/** Shows exactly what a step changed; the log has counts only for each part of a stroke. */
function Changes({step}: {step: Step}) {
  const found = useSignal<Comparison | null>(null);
  useEffect(() => {
    const id = scene.value?.id;
    let left = false;
    if (id) compareRevisions(id, step.before, step.last).then((answer) => { if (!left) found.value = answer; }, sayError);
    return () => { left = true; };
  }, [step.before, step.last]);
  if (!found.value) return <p class="help">…</p>;
  const {touched, fields} = found.value;
  return <p class="help">{touched === 0 ? "This step changed no fur." : `${vertices(touched)}: ${fields.map(({field, changed}) => `${field.replaceAll("_", " ")} ${changed.toLocaleString("en")}`).join(", ")}`}</p>;
}

export function StepDetail({step, close}: {step: Step; close: () => void}) {
  const naming = useSignal(false);
  const now = step.last === present.value?.last || step.last === revision.value;
  const compare = () => { compared.value = {revision: step.last, label: stepWords(step)}; };
  return (
    <div class="step-detail">
      <Changes step={step} />
      <div class="chips presets">
        <button type="button" class="chip" disabled={now} onClick={compare}>Compare with now</button>
        <button type="button" class="chip" onClick={() => void branchAt(step)}>Branch from here</button>
        <button type="button" class="chip" aria-expanded={naming.value} onClick={() => { naming.value = !naming.value; }}>Checkpoint here</button>
      </div>
      {naming.value && <NameCheckpoint at={step.last} done={() => { naming.value = false; }} />}
      {step.kind !== "revert" && (
        <div class="row chips" role="group" aria-label="Copy as">
          <span>Copy as</span>
          <div>{copy_forms.map(({form, label}) => <button key={form} type="button" class="chip" onClick={() => copyStep(form, label, step)}>{label}</button>)}</div>
        </div>
      )}
      {step.in_effect && step.kind !== "revert" && <StepForm key={step.last} step={step} close={close} />}
    </div>
  );
}
