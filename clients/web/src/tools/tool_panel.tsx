// The panel of the current tool: what it does, its settings, the brush, and buttons that apply it to all fur.
import {useSignal} from "@preact/signals";
import type {Op} from "../api/types";
import {useId} from "preact/hooks";
import {run, settings} from "../scene/session";
import {MaskSection} from "../panels/mask";
import {AlphaRow} from "./alpha";
import {firstMembers, handWords} from "./artist_words";
import {brush_members, schemaOf, toolOf, type Tool} from "./catalogue";
import {Form} from "./form";
import {removeGuide, guidesOf, layAgain} from "./guides";
import {Icon, ToolIcon} from "./icons";
import {presets, saved, type Preset} from "./presets";
import {forbidden, type Member} from "./schema";
import {brush, brushOf, commandOf, current, inverting, setBrush, setValue, set_brush, set_values, steadiness, valuesOf} from "./state";
import {ToolPicture} from "./tool_picture";

/** Brush members that are not in the form of other brush settings: those in the top bar, the main one, and the alpha. */
const in_the_bar = ["radius", "strength"], main_brush = ["falloff"], own_rows = ["alpha"];
const by_hand: Partial<Record<Op, string[]>> = {attract: ["radius", "units"]};

function flood(tool: Tool, more: Record<string, unknown> = {}) {
  const {strength} = brushOf(tool.op, false);
  void run(commandOf(tool.op, {...more, flood: true, brush: {...(strength === undefined ? {} : {strength}), ...(inverting.value ? {invert: true} : {})}}));
}

/** Directions for combing all fur, where no stroke gives one. */
const sides = [{says: "Back", direction: [0, 0, -1]}, {says: "Down", direction: [0, -1, 0]}, {says: "Up", direction: [0, 1, 0]}];

function Everywhere({tool, name}: {tool: Tool; name: string}) {
  if (!tool.floods) return null;
  if (tool.op !== "comb") return <button type="button" class="wide" onClick={() => flood(tool)}>{name} everywhere</button>;
  return (
    <div class="mask-buttons" role="group" aria-label={`${name} everywhere`}>
      <span>All fur</span>
      {sides.map(({says, direction}) => <button key={says} type="button" onClick={() => flood(tool, {direction})}>{says}</button>)}
    </div>
  );
}

/** Applies a preset to the tool and the brush. */
function take(op: Op, {values, brush: of_brush}: Preset) {
  set_values.value = {...set_values.value, [op]: values};
  set_brush.value = {...set_brush.value, ...of_brush};
}

function SavePreset({op}: {op: Op}) {
  const naming = useSignal(false);
  const save = (event: Event) => {
    event.preventDefault();
    const name = (new FormData(event.currentTarget as HTMLFormElement).get("name") as string).trim();
    naming.value = false;
    if (!name) return;
    const preset = {name, values: {...set_values.value[op]}, brush: {...set_brush.value}};
    saved.value = {...saved.value, [op]: [...(saved.value[op] ?? []).filter((other) => other.name !== name), preset]};
  };
  if (!naming.value) return <button type="button" class="chip" title="Save the settings of tool and brush in this browser" onClick={() => { naming.value = true; }}>Save…</button>;
  return <form class="name-row" onSubmit={save}><input name="name" type="text" maxLength={30} aria-label="Name of the preset" autoFocus /><button type="submit">Save</button></form>;
}

function Presets({tool: {op}}: {tool: Tool}) {
  const own = saved.value[op] ?? [];
  const remove = (name: string) => { saved.value = {...saved.value, [op]: own.filter((other) => other.name !== name)}; };
  return (
    <div class="chips presets" role="group" aria-label="Presets">
      {(presets[op] ?? []).map((preset) => <button key={preset.name} type="button" class="chip" onClick={() => take(op, preset)}>{preset.name}</button>)}
      {own.map((preset) => (
        <span key={preset.name} class="own-preset">
          <button type="button" class="chip" onClick={() => take(op, preset)}>{preset.name}</button>
          <button type="button" class="quiet" aria-label={`Forget ${preset.name}`} onClick={() => remove(preset.name)}><Icon sign="close" /></button>
        </span>
      ))}
      <SavePreset op={op} />
    </div>
  );
}

function Guides({op}: {op: "flow" | "interpolate"}) {
  const guides = guidesOf(op);
  return (
    <section>
      <h3>{op === "flow" ? "Guides" : "Keys"}</h3>
      <p class="help">{op === "flow" ? "Draw a line on the body: fur follows it." : "Draw short lines: fur between them blends from one to the next."} Drag points to move them.</p>
      {guides.map((guide, k) => (
        <div class="list-row" key={k}><span>{op === "flow" ? "Guide" : "Key"} {k + 1}</span><small>{guide.length} points</small>
          <button type="button" onClick={() => void removeGuide(op, k)}>Delete</button></div>
      ))}
      {guides.length > 0 && <button type="button" onClick={() => void layAgain(op)}>Lay the fur again with these settings</button>}
    </section>
  );
}

/** The list of named blowers or attractors, which are created here and moved in the picture. */
function Standing({op}: {op: "blow" | "attract"}) {
  const all = settings.value;
  if (!all) return null;
  const list = op === "blow" ? all.blowers : all.attractors;
  const put = (next: unknown[]) => run(op === "blow" ? {op: "set_blowers", blowers: next} : {op: "set_attractors", attractors: next});
  const add = () => {
    const name = `${op === "blow" ? "wind" : "stick"} ${list.length + 1}`;
    const {source, point} = {source: [0, 1, 0], point: [0, 1, 0]};
    void put([...list, op === "blow" ? {name, source, direction: [0, -1, 0]} : {name, point}]);
  };
  const use = (name: string) => void run(op === "blow" ? {op, blower: name} : {op, attractor: name});
  return (
    <section>
      <h3>{op === "blow" ? "Blowers of the scene" : "Attractors of the scene"}</h3>
      {list.map(({name}, k) => (
        <div class="list-row" key={name}><span>{name}</span>
          <button type="button" onClick={() => use(name)}>Use</button>
          <button type="button" onClick={() => void put(list.filter((_, j) => j !== k))}>Delete</button></div>
      ))}
      <button type="button" onClick={add}>Place one</button>
    </section>
  );
}

function ToolSettings({tool}: {tool: Tool}) {
  const {op} = tool;
  const values = valuesOf(op);
  const hidden = new Set([...forbidden(schemaOf(op), {op, ...values}), "strength", ...(by_hand[op] ?? [])]);
  const first = tool.members.filter(({name}) => firstMembers[op]?.includes(name) ?? true);
  const more = tool.members.filter((member) => !first.includes(member) && !hidden.has(member.name));
  const form = (members: Member[]) => <Form members={members} values={values} hidden={hidden} set={(name, value) => setValue(op, name, value)} />;
  return (
    <>
      {form(first)}
      {more.length > 0 && <details class="group"><summary>More settings of {tool.name}</summary>{form(more)}</details>}
    </>
  );
}

function Steadiness() {
  const id = useId();
  return (
    <div class="row" title="The brush trails the pointer, so that a shaky hand draws a smooth line">
      <label for={id}>Steady hand</label>
      <input id={id} type="range" min="0" max="1" step="0.05" value={steadiness.value} onInput={(event) => { steadiness.value = Number(event.currentTarget.value); }} />
    </div>
  );
}

function BrushSettings() {
  const main = brush_members.value.filter(({name}) => main_brush.includes(name));
  const more = brush_members.value.filter(({name}) => ![...main_brush, ...in_the_bar, ...own_rows].includes(name));
  return (
    <section>
      <h3>Brush</h3>
      <Form members={main} values={brush.value} set={setBrush} />
      <AlphaRow />
      <Steadiness />
      <details class="group"><summary>More brush settings</summary><Form members={more} values={brush.value} set={setBrush} /></details>
    </section>
  );
}

export function ToolPanel() {
  const tool = toolOf(current.value);
  if (!tool) return null;
  const {op, name} = tool;
  return (
    <>
      <header class="tool-head"><ToolIcon op={op} /><div><h2>{name}</h2><p>{tool.says}</p></div></header>
      {handWords[op] && <p class="help">{handWords[op]}</p>}
      <ToolPicture tool={tool} />
      <Presets tool={tool} />
      <ToolSettings tool={tool} />
      <BrushSettings />
      <Everywhere tool={tool} name={name} />
      {(op === "flow" || op === "interpolate") && <Guides op={op} />}
      {(op === "blow" || op === "attract") && <Standing op={op} />}
      <MaskSection />
    </>
  );
}
