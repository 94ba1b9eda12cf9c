// Checkpoints, which are named revisions: creates them and goes to them.
import {useSignal} from "@preact/signals";
import {revision, run} from "../scene/session";
import {checkpoints} from "../scene/steps";
import {goTo} from "../scene/travel";

/** A field that names a revision, by default the current one. */
export function NameCheckpoint({at, done}: {at?: number; done?: () => void}) {
  const name = useSignal("");
  const save = async (event: Event) => {
    event.preventDefault();
    const text = name.value.trim();
    if (!text || !await run({op: "checkpoint", name: text, ...(at === undefined ? {} : {revision: at})})) return;
    name.value = "";
    done?.();
  };
  return (
    <form class="name-row" onSubmit={(event) => void save(event)}>
      <input type="text" maxLength={200} placeholder={at === undefined ? "Name this state" : `Name revision ${at}`} aria-label="Name of the checkpoint" value={name.value}
             onInput={(event) => { name.value = event.currentTarget.value; }} />
      <button type="submit" disabled={!name.value.trim()}>Checkpoint</button>
    </form>
  );
}

export function Checkpoints() {
  const all = checkpoints.value;
  return (
    <div class="checkpoints">
      <NameCheckpoint />
      {all.length > 0 && (
        <div class="chips presets" role="group" aria-label="Go to a checkpoint">
          {all.map(({name, revision: at}) => (
            <button key={name} type="button" class="chip" disabled={at === revision.value} title={`Go to revision ${at}`} onClick={() => void goTo(at)}>{name}</button>
          ))}
        </div>
      )}
    </div>
  );
}
