// The panel of edit layers, from the topmost to the base groom: weights, order, which are visible and which one the tools
// write to.
import {effect, signal, useSignal} from "@preact/signals";
import {useEffect, useRef} from "preact/hooks";
import type {Command, EditLayer} from "../api/types";
import {sayError} from "../scene/messages";
import {edit_layer, layers, run, scene} from "../scene/session";
import {schemaOf} from "../tools/catalogue";
import {Icon} from "../tools/icons";
import {resolved, schemas, type Schema} from "../tools/schema";
import {NumberField} from "../tools/number_field";

const set = (name: string, members: Record<string, unknown>): Command => ({op: "edit_layer", action: "set", name, ...members});
const memberSchema = (schema: Schema, name: string): Schema => {
  const member = schema.properties?.[name];
  return typeof member === "object" ? resolved(member) : {};
};
const maxLayers = () => memberSchema(resolved(schemas.value["Scene"] ?? {}), "edit_layers").maxItems ?? Infinity;
const weightRange = () => {
  const {minimum = 0, maximum = 1} = memberSchema(schemaOf("edit_layer"), "weight");
  return {min: minimum, max: maximum};
};

let turn: Promise<unknown> = Promise.resolve();
/** Runs changes one after the other, so that each starts from the result of the previous one: a user presses buttons faster
 * than the server answers. */
function inTurn(work: () => unknown) {
  turn = turn.then(work).catch(sayError);
}
const current = (name: string) => layers().find((layer) => layer.name === name);

/** The layer in solo mode, and which layers were muted before. */
const solo = signal<{name: string; muted: Record<string, boolean>} | null>(null);
const isSolo = (layer: EditLayer) => solo.value?.name === layer.name && layers().every((other) => other.muted === (other.name !== layer.name));

// Deselects the tools' layer when it is removed, also by undo or by other users.
effect(() => { if (edit_layer.value && scene.value && !layers().some(({name}) => name === edit_layer.value)) edit_layer.value = ""; });

async function toggleSolo(name: string) {
  const layer = current(name);
  if (!layer) return;
  const on = isSolo(layer);
  const before = solo.value?.muted ?? {};
  const wanted = (other: EditLayer) => (on ? before[other.name] ?? false : other.name !== layer.name);
  // Switching from one solo to another keeps what was muted before the first one.
  const from_solo = !on && solo.value && layers().some((other) => other.name === solo.value!.name && isSolo(other));
  const muted = from_solo ? before : Object.fromEntries(layers().map((other) => [other.name, other.muted]));
  const commands = layers().filter((other) => other.muted !== wanted(other)).map((other) => set(other.name, {muted: wanted(other)}));
  solo.value = on ? null : {name: layer.name, muted};
  if (commands.length) await run(...commands);
}

/** Moves a layer to the index that `placeOf` returns for its current one, counted from the bottom. */
async function moveBy(name: string, placeOf: (now: number) => number) {
  const now = layers().findIndex((layer) => layer.name === name);
  if (now < 0) return;
  const others = layers().filter((layer) => layer.name !== name);
  const to = Math.max(0, Math.min(others.length, placeOf(now)));
  if (to !== now) await run({op: "edit_layer", action: "move", name, above: others[to - 1]?.name ?? ""});
}

async function add(name: string) {
  if (await run({op: "edit_layer", name})) edit_layer.value = name;
}

function freshName(): string {
  const taken = new Set(layers().map(({name}) => name));
  for (let k = layers().length + 1; ; ++k) if (!taken.has(`layer ${k}`)) return `layer ${k}`;
}

function Weight({layer}: {layer: EditLayer}) {
  const {min, max} = weightRange();
  const shown = useSignal(layer.weight);
  useEffect(() => { shown.value = layer.weight; }, [layer.weight]);
  const low = Math.min(0, layer.weight), high = Math.max(1, layer.weight);  // beyond [0, 1] only if typed so
  const send = (weight: number) => {
    const held = Math.max(min, Math.min(max, weight));
    shown.value = held;
    if (Number.isFinite(held) && held !== layer.weight) void run(set(layer.name, {weight: held}));
  };
  return (
    <>
      <input type="range" min={low} max={high} step="0.01" value={shown.value} aria-label={`Weight of ${layer.name}`}
             onInput={(event) => { shown.value = Number(event.currentTarget.value); }} onChange={(event) => send(Number(event.currentTarget.value))} />
      <NumberField label={`Weight of ${layer.name}, as a number`} title={`From ${min} to ${max}. A negative weight reverses the layer.`} range={{minimum: min, maximum: max}} value={shown.value} take={send} />
    </>
  );
}

function Name({layer, editing}: {layer: EditLayer; editing: {value: string | null}}) {
  const field = useRef<HTMLInputElement>(null);
  useEffect(() => { field.current?.select(); }, [editing.value]);
  const save = async () => {
    if (editing.value !== layer.name) return;  // cancelled with Escape
    const name = field.current?.value.trim() ?? "";
    editing.value = null;
    if (!name || name === layer.name) return;
    const held = edit_layer.value === layer.name;
    if (!await run(set(layer.name, {rename: name}))) return;
    if (held) edit_layer.value = name;
    if (solo.value?.name === layer.name) solo.value = {...solo.value, name};
  };
  if (editing.value !== layer.name) return <span class="layer-name">{layer.name}</span>;
  const press = (event: KeyboardEvent) => {
    if (event.key === "Enter") void save();
    if (event.key === "Escape") editing.value = null;
  };
  return <input type="text" class="layer-name" ref={field} maxLength={200} defaultValue={layer.name} aria-label={`New name of ${layer.name}`} onKeyDown={press} onBlur={() => void save()} />;
}

/** The layer that is dragged, and the index that it is over, counted from the bottom. */
const dragged = signal<{name: string; to: number} | null>(null);

function Grip({layer, at}: {layer: EditLayer; at: number}) {
  const placeOf = (event: PointerEvent) => {
    const rows = [...(event.currentTarget as HTMLElement).closest("ol")!.querySelectorAll<HTMLElement>("[data-layer]")];
    const above = rows.filter((row) => { const {top, height} = row.getBoundingClientRect(); return event.clientY > top + height / 2; }).length;
    return Math.max(0, Math.min(rows.length - 1, rows.length - above - (rows.length - above > at ? 1 : 0)));
  };
  const down = (event: PointerEvent) => {
    (event.currentTarget as HTMLElement).setPointerCapture(event.pointerId);
    dragged.value = {name: layer.name, to: at};
  };
  const move = (event: PointerEvent) => { if (dragged.value?.name === layer.name) dragged.value = {name: layer.name, to: placeOf(event)}; };
  const up = () => {
    const to = dragged.value;
    if (to?.name === layer.name) inTurn(() => moveBy(layer.name, () => to.to));
    dragged.value = null;
  };
  const press = (event: KeyboardEvent) => {
    const step = {ArrowUp: 1, ArrowDown: -1}[event.key];
    if (!step) return;
    event.preventDefault();
    inTurn(() => moveBy(layer.name, (now) => now + step));
  };
  return (
    <button type="button" class="quiet grip" aria-label={`Move ${layer.name}`} title="Drag to reorder; arrow keys move it up and down" onPointerDown={down} onPointerMove={move} onPointerUp={up}
            onPointerCancel={() => { dragged.value = null; }} onKeyDown={press}><Icon sign="grip" /></button>
  );
}

function LayerRow({layer, at, editing}: {layer: EditLayer; at: number; editing: {value: string | null}}) {
  const {name, muted} = layer;
  const below = layers()[at - 1];
  const merges = !muted && !below?.muted;
  const drop = dragged.value && dragged.value.name !== name && dragged.value.to === at;
  const from = layers().findIndex((other) => other.name === dragged.value?.name);
  const mark = drop ? (from < at ? " drop-above" : " drop-below") : "";
  return (
    <li class={`layer${muted ? " layer-muted" : ""}${mark}${dragged.value?.name === name ? " layer-dragged" : ""}`} data-layer={name}>
      <div class="layer-line">
        <Grip layer={layer} at={at} />
        <label class="layer-pick" title="Tools write to this layer" onDblClick={() => { editing.value = name; }}>
          <input type="radio" name="edit-layer" checked={edit_layer.value === name} aria-label={`Tools write to ${name}`} onChange={() => { edit_layer.value = name; }} />
          <Name layer={layer} editing={editing} />
        </label>
        <button type="button" class="quiet" aria-label={`Rename ${name}`} title="Rename" onClick={() => { editing.value = name; }}><Icon sign="edit" /></button>
        <button type="button" class="quiet" aria-pressed={isSolo(layer)} aria-label={`Only ${name}`} title="Solo: mute all others" onClick={() => inTurn(() => toggleSolo(name))}><Icon sign="solo" /></button>
        <button type="button" class="quiet" aria-pressed={muted} aria-label={`Mute ${name}`} title={muted ? "Unmute" : "Mute"} onClick={() => inTurn(() => run(set(name, {muted: !current(name)?.muted})))}><Icon sign={muted ? "eye_off" : "eye"} /></button>
      </div>
      <div class="layer-line">
        <Weight layer={layer} />
        <button type="button" class="quiet" disabled={!merges} aria-label={`Merge ${name} down`} title={merges ? `Merge into ${below?.name ?? "the base groom"}` : "Muted layers cannot be merged"}
                onClick={() => inTurn(() => run({op: "edit_layer", action: "merge_down", name}))}><Icon sign="merge" /></button>
        <button type="button" class="quiet" aria-label={`Remove ${name}`} title="Remove" onClick={() => inTurn(() => run({op: "edit_layer", action: "remove", name}))}><Icon sign="trash" /></button>
      </div>
    </li>
  );
}

function Note() {
  const layer = layers().find(({name}) => name === edit_layer.value);
  if (!layer) return null;
  if (layer.muted) return <p class="help" role="status">Tools write to {layer.name}, which is muted.</p>;
  return Math.abs(layer.weight) < 0.05 ? <p class="help" role="status">Tools cannot change {layer.name} while its weight is between -0.05 and 0.05.</p> : null;
}

export function LayersPanel() {
  const editing = useSignal<string | null>(null);
  if (!scene.value) return <p class="help">No scene is open.</p>;
  const all = layers();
  const full = all.length >= maxLayers();
  return (
    <>
      <p class="help">A layer keeps changes apart from the groom below it. You can change its weight, or mute, move or merge it, at any time. Tools write to the selected layer.</p>
      <button type="button" class="wide" disabled={full} title={full ? `A scene has at most ${all.length} layers` : ""} onClick={() => inTurn(() => add(freshName()))}><Icon sign="plus" />Add a layer</button>
      <ol class="layers" aria-label="Layers, highest first" reversed>
        {all.map((layer, at) => <LayerRow key={layer.name} layer={layer} at={at} editing={editing} />).reverse()}
        <li class="layer">
          <label class="layer-pick"><input type="radio" name="edit-layer" checked={edit_layer.value === ""} onChange={() => { edit_layer.value = ""; }} />Base groom</label>
        </li>
      </ol>
      <Note />
    </>
  );
}
