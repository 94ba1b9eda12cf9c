// The list of the server's scenes: open, branch, share, remove and create.
import {signal} from "@preact/signals";
import {useEffect} from "preact/hooks";
import {branchScene, createScene, removeScene} from "../api/client";
import type {Scene} from "../api/types";
import {say, sayError} from "../scene/messages";
import {making} from "../files/download";
import {sideBySide} from "../files/sheets";
import {drawMissing, thumbnails} from "../scene/thumbnails";
import {listScenes, openScene, scene, scenes} from "../scene/session";
import {Dialog} from "../shell/dialog";
import {Form} from "../tools/form";
import {membersOf, schemas} from "../tools/schema";
import type {Values} from "../tools/state";

const removing = signal<Scene | null>(null);
const sharing = signal<Scene | null>(null);
const fresh = signal<Values>({name: "creature", ground: true});

const guarded = (work: () => Promise<unknown>) => () => void work().catch(sayError);
const linkOf = ({id}: Scene) => `${location.origin}/?scene=${encodeURIComponent(id)}`;

const branch = async (of: Scene) => {
  const made = await branchScene(of.id, {name: `${of.name}, branch`});
  await Promise.all([listScenes(), openScene(made.id)]);
};

const share = async (of: Scene) => {
  try {
    await navigator.clipboard.writeText(linkOf(of));
    say("The link was copied.", "Everyone who opens it can groom this scene.");
  } catch {
    sharing.value = of;  // the clipboard needs https and permission
  }
};

const remove = async (gone: Scene) => {
  removing.value = null;
  await removeScene(gone.id);
  if (scene.value?.id === gone.id) scene.value = null;
  await listScenes();
  const next = scenes.value[0];
  if (!scene.value && next) await openScene(next.id);
};

const make = async () => {
  const made = await createScene(fresh.value);
  await Promise.all([listScenes(), openScene(made.id)]);
};

function Row({of}: {of: Scene}) {
  const open = of.id === scene.value?.id;
  const now = open ? scene.value! : of;  // newer than the list, which is not read again after each stroke
  return (
    <li class="scene-row" aria-current={open ? "true" : undefined}>
      <button type="button" class="quiet scene-open" disabled={open} onClick={guarded(() => openScene(of.id))}>
        {thumbnails.value[of.id] ? <img src={thumbnails.value[of.id]} alt="" width="64" height="48" /> : <i aria-hidden="true" />}
        <span>{now.name}</span><small>{now.model}, {now.triangles.toLocaleString()} triangles</small>
      </button>
      <div class="scene-acts">
        {!open && scene.value && <button type="button" class="quiet" aria-label={`Side by side: ${of.name} and the open scene`} disabled={making.value !== null} onClick={() => void sideBySide(of)}>Side by side</button>}
        <button type="button" class="quiet" aria-label={`Branch ${of.name}`} onClick={guarded(() => branch(of))}>Branch</button>
        <button type="button" class="quiet" aria-label={`Link to ${of.name}`} onClick={guarded(() => share(of))}>Link</button>
        <button type="button" class="quiet" aria-label={`Remove ${of.name}`} onClick={() => { removing.value = of; }}>Remove</button>
      </div>
    </li>
  );
}

function Questions() {
  const gone = removing.value, shared = sharing.value;
  return (
    <>
      {gone && (
        <Dialog title={`Remove ${gone.name}?`} close={() => { removing.value = null; }}>
          <div class="question">
            <p>This deletes the scene and its groom for everyone. It cannot be undone.</p>
            <div class="pair"><button type="button" class="primary" onClick={guarded(() => remove(gone))}>Remove</button><button type="button" autoFocus onClick={() => { removing.value = null; }}>Keep</button></div>
          </div>
        </Dialog>)}
      {shared && (
        <Dialog title={`Link to ${shared.name}`} close={() => { sharing.value = null; }}>
          <div class="question"><label>Everyone who opens it can groom this scene. <input type="text" readOnly value={linkOf(shared)} size={48} onFocus={(event) => event.currentTarget.select()} autoFocus /></label></div>
        </Dialog>)}
    </>
  );
}

function NewOne() {
  const members = membersOf(schemas.value["NewScene"] ?? {});
  return (
    <details class="group">
      <summary>New scene from a built-in model</summary>
      <Form members={members} values={fresh.value} set={(name, value) => { fresh.value = {...fresh.value, [name]: value}; }} />
      <button type="button" class="wide" onClick={guarded(make)}>Create</button>
    </details>
  );
}

export function SceneList() {
  const listed = scenes.value.map(({id}) => id).join();
  useEffect(() => { void drawMissing(); }, [listed]);
  return (
    <section>
      <h3>Scenes</h3>
      {scenes.value.length === 0 && <p class="help">There are no scenes yet.</p>}
      <ul class="scenes">{scenes.value.map((of) => <Row key={of.id} of={of} />)}</ul>
      <NewOne />
      <Questions />
    </section>
  );
}
