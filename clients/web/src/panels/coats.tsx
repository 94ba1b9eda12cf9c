// The scene's coats: which are visible, which one the tools work on, and where a new one grows.
import {effect, useSignal} from "@preact/signals";
import type {Settings} from "../api/types";
import {sayError} from "../scene/messages";
import {coats, groomed_coat, run, settings} from "../scene/session";
import {Icon} from "../tools/icons";

type Coat = Settings["coats"][number];
type Region = "all" | "none" | "mask";
const max_coats = 8;
const regions: {region: Region; words: string}[] = [
  {region: "mask", words: "Where the mask is"}, {region: "none", words: "Nowhere yet: paint its density"}, {region: "all", words: "Everywhere"},
];

let turn: Promise<unknown> = Promise.resolve();
/** Runs changes one after the other, so that each starts from the result of the previous one. */
function inTurn(work: () => unknown) { turn = turn.then(work).catch(sayError); }

const entries = () => coats().map(({name, id, muted}) => ({name, id, muted}));
const set = (all: object[]) => run({op: "set_coats", coats: all});
const change = (id: number, members: Partial<Coat>) => set(entries().map((one) => (one.id === id ? {...one, ...members} : one)));

// Deselects the tools' coat when it is removed or muted.
effect(() => { if (groomed_coat.value && settings.value && !coats().some(({name, muted}) => name === groomed_coat.value && !muted)) groomed_coat.value = ""; });

function freshName(): string {
  const taken = new Set(coats().map(({name}) => name));
  for (let k = coats().length + 1; ; ++k) if (!taken.has(`coat ${k}`)) return `coat ${k}`;
}

async function add(region: Region) {
  const name = freshName(), from = groomed_coat.value || coats()[0]!.name;
  if (await set([...entries(), {name, begins: {from, region}}])) groomed_coat.value = name;
}

async function rename({id, name}: Coat, to: string) {
  if (!to || to === name) return;
  const held = groomed_coat.value === name;
  if (await change(id, {name: to}) && held) groomed_coat.value = to;
}

function moveUp(id: number) {
  const all = entries(), at = all.findIndex((one) => one.id === id);
  if (at > 0) all.splice(at - 1, 0, ...all.splice(at, 1));
  return set(all);
}

function Row({coat, at, editing}: {coat: Coat; at: number; editing: {value: number | null}}) {
  const {id, name, muted} = coat;
  const last_seen = !muted && coats().filter((one) => !one.muted).length === 1;
  const save = (event: Event) => {
    if (editing.value !== id) return;  // cancelled with Escape
    editing.value = null;
    inTurn(() => rename(coat, (event.target as HTMLInputElement).value.trim()));
  };
  const press = (event: KeyboardEvent) => {
    if (event.key === "Enter") save(event);
    if (event.key === "Escape") editing.value = null;
  };
  return (
    <li class={`layer${muted ? " layer-muted" : ""}`}>
      <div class="layer-line">
        <label class="layer-pick">
          <input type="radio" name="coat" disabled={muted} checked={groomed_coat.value === name} aria-label={`Tools work on ${name}`} onChange={() => { groomed_coat.value = name; }} />
          {editing.value === id
            ? <input type="text" class="layer-name" maxLength={200} defaultValue={name} aria-label={`New name of ${name}`} onKeyDown={press} onBlur={save} autofocus />
            : <span class="layer-name">{name}</span>}
        </label>
        <button type="button" class="quiet" aria-label={`Rename ${name}`} title="Rename" onClick={() => { editing.value = id; }}><Icon sign="edit" /></button>
        <button type="button" class="quiet" disabled={at === 0} aria-label={`Move ${name} up`} title="Move up" onClick={() => inTurn(() => moveUp(id))}><span aria-hidden="true">↑</span></button>
        <button type="button" class="quiet" aria-pressed={muted} disabled={last_seen} aria-label={`Mute ${name}`} title={muted ? "Unmute" : "Mute"} onClick={() => inTurn(() => change(id, {muted: !muted}))}><Icon sign={muted ? "eye_off" : "eye"} /></button>
        <button type="button" class="quiet" disabled={last_seen} aria-label={`Remove ${name}`} title="Remove" onClick={() => inTurn(() => set(entries().filter((one) => one.id !== id)))}><Icon sign="trash" /></button>
      </div>
    </li>
  );
}

export function Coats() {
  const editing = useSignal<number | null>(null), region = useSignal<Region>("mask");
  const all = coats();
  return (
    <>
      <ol class="layers" aria-label="Coats">
        {all.length > 1 && (
          <li class="layer"><label class="layer-pick"><input type="radio" name="coat" checked={groomed_coat.value === ""} onChange={() => { groomed_coat.value = ""; }} />All coats</label></li>
        )}
        {all.map((coat, at) => <Row key={coat.id} coat={coat} at={at} editing={editing} />)}
      </ol>
      <select class="wide" aria-label="Where a new coat grows" value={region.value} onChange={(event) => { region.value = event.currentTarget.value as Region; }}>
        {regions.map((one) => <option key={one.region} value={one.region}>{one.words}</option>)}
      </select>
      <button type="button" class="wide" disabled={all.length >= max_coats} onClick={() => inTurn(() => add(region.value))}><Icon sign="plus" />Add a coat</button>
    </>
  );
}
