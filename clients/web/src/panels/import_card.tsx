// The card of a model's upload: the question about its axes, the progress, and what was repaired.
import {leave, startImport, type Import, type Loss, importing, upload_speed} from "../files/import";
import type {Repair} from "../api/types";
import type {Plan} from "../files/plan";
import {scene} from "../scene/session";
import {Form} from "../tools/form";
import {membersOf, schemas, words} from "../tools/schema";
import {durationOf} from "../view/measured";

const repair_words: Record<string, string> = {
  welded_vertices: "duplicate positions were merged", flipped_triangles: "triangles were flipped to face outwards", split_polygons: "polygons were split into triangles",
  invalid_faces: "faces without valid vertices were left out", degenerate_faces: "faces without area were left out", repeated_faces: "duplicate faces were left out",
  unused_vertices: "vertices without a face were left out", open_edges: "edges are open: the model has holes", non_manifold_edges: "edges have more than two faces",
  one_sided_edges: "edges join a face that points outwards with one that points inwards", bad_indices: "faces name vertices that the file does not have",
  unusable_uvs: "triangles have unusable texture coordinates", ignored_extensions: "extensions of the file were ignored",
  mirrored_joints: "joints mirror their skin: its faces were flipped",
};

function Asking({plan, into, loss}: {plan: Plan; into: string; loss: Loss | undefined}) {
  const members = membersOf(schemas.value["ImportOptions"] ?? {}, ["format"]);
  const set = (name: string, value: unknown) => { importing.value = {stage: "asking", plan: {...plan, options: {...plan.options, [name]: value}}, into, ...(loss && {loss})}; };
  return (
    <>
      <h3>{into ? "Upload again" : "Upload"}: {plan.name} ({plan.format})</h3>
      <Notes notes={plan.notes} />
      {plan.texture && <p class="help">Its texture is uploaded, too.</p>}
      <p class="help">Tools and looks expect an animal that stands upright and faces +z. The axes are a guess: if the model lies on its side, upload it again with other axes.</p>
      <Form members={members} values={plan.options} set={set} />
      <KeepGroom plan={plan} into={into} />
      <p class="help">{sizeWords(plan.bytes.size)}</p>
      <div class="pair">
        <button type="button" class="primary" onClick={() => void startImport(plan, into, loss)}>Upload</button>
        <button type="button" onClick={leave}>Cancel</button>
      </div>
    </>
  );
}

/** A checkbox: the model is a new version of the open scene's model and gets its groom. The old scene stays in the list. */
function KeepGroom({plan, into}: {plan: Plan; into: string}) {
  const open = scene.value;
  if (!open || into || open.undo_steps === 0 && !plan.version_of) return null;
  const change = (on: boolean) => { importing.value = {stage: "asking", plan: {...plan, version_of: on ? open.id : ""}, into}; };
  return <label class="check"><input type="checkbox" checked={plan.version_of !== ""} onChange={(event) => change(event.currentTarget.checked)} /> A new version of {open.name}: keep its groom</label>;
}

/** Returns text such as "12 MiB, about 40 s to send". */
function sizeWords(bytes: number): string {
  const size = bytes < 1048576 ? `${Math.ceil(bytes / 1024)} KiB` : `${(bytes / 1048576).toFixed(1)} MiB`;
  const seconds = upload_speed.value > 0 ? bytes / upload_speed.value : 0;
  return seconds >= 2 ? `${size}, about ${durationOf(1000 * seconds)} to send` : size;
}

function Notes({notes}: {notes: string[]}) {
  if (notes.length === 0) return null;
  return <ul class="notes">{notes.map((note) => <li key={note}>{note}</li>)}</ul>;
}

function Repairs({repairs}: {repairs: Repair[]}) {
  const some = repairs.filter(({count}) => count > 0);
  if (some.length === 0) return <p class="help">Nothing had to be repaired.</p>;
  return <ul class="notes">{some.map(({code, count}) => <li key={code}>{count.toLocaleString()} {repair_words[code] ?? words(code)}</li>)}</ul>;
}

function Underway({now}: {now: Extract<Import, {stage: "sending" | "preparing"}>}) {
  const says = now.stage === "sending" ? `Sending ${now.what}: ${Math.round(now.share * 100)}%` : "The server repairs the model and grows its first fur.";
  return (
    <>
      <h3>{now.plan.name}</h3>
      <p role="status">{says}</p>
      <progress aria-label={says} max={1} {...(now.stage === "sending" ? {value: now.share} : {})} />
      <button type="button" onClick={() => now.stop.abort()}>Cancel</button>
    </>
  );
}

function Done({now}: {now: Extract<Import, {stage: "done"}>}) {
  return (
    <>
      <h3>{now.plan.name} is loaded</h3>
      <p role="status">{now.triangles.toLocaleString()} triangles.</p>
      <Repairs repairs={now.repairs} />
      <Notes notes={now.notes} />
      <div class="pair">
        {!now.plan.version_of && <button type="button" onClick={() => { importing.value = {stage: "asking", plan: now.plan, into: now.into, loss: {revision: now.revision}}; }}>Other axes…</button>}
        <button type="button" onClick={leave}>Good</button>
      </div>
    </>
  );
}

function Failed({now}: {now: Extract<Import, {stage: "failed"}>}) {
  const {plan, into} = now;
  return (
    <>
      <p role="alert">{now.says}</p>
      <p class="help">{now.next}</p>
      <div class="pair">
        {plan && <button type="button" onClick={() => { importing.value = {stage: "asking", plan, into}; }}>Try again…</button>}
        <button type="button" onClick={leave}>Close</button>
      </div>
    </>
  );
}

export function ImportCard({now}: {now: Import}) {
  return (
    <div class={`card${now.stage === "failed" ? " card-bad" : ""}`} role="group" aria-label="Upload">
      {now.stage === "reading" && <p role="status">Reading the files…</p>}
      {now.stage === "asking" && <Asking plan={now.plan} into={now.into} loss={now.loss} />}
      {(now.stage === "sending" || now.stage === "preparing") && <Underway now={now} />}
      {now.stage === "done" && <Done now={now} />}
      {now.stage === "failed" && <Failed now={now} />}
    </div>
  );
}
