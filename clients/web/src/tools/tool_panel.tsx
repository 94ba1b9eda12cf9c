// The tool in hand: what it does, its settings, the brush, and the same everywhere at once.
import type {Op} from "../api/types";
import {run, settings} from "../scene/session";
import {MaskSection} from "../panels/mask";
import {firstMembers, handWords} from "./artist_words";
import {brush_members, schemaOf, toolOf, type Tool} from "./catalogue";
import {Form} from "./form";
import {removeGuide, guidesOf, layAgain} from "./guides";
import {ToolIcon} from "./icons";
import {presets} from "./presets";
import {forbidden, type Member} from "./schema";
import {brush, brushOf, commandOf, current, inverting, setBrush, setValue, set_brush, set_values, valuesOf} from "./state";
import {ToolPicture} from "./tool_picture";

/** Radius and strength are in the bar above the picture. */
const in_the_bar = ["radius", "strength"], main_brush = ["falloff"];
const by_hand: Partial<Record<Op, string[]>> = {attract: ["radius", "units"]};

function flood(tool: Tool) {
  const {strength} = brushOf(tool.op, false);
  void run(commandOf(tool.op, {flood: true, brush: {...(strength === undefined ? {} : {strength}), ...(inverting.value ? {invert: true} : {})}}));
}

function Presets({tool}: {tool: Tool}) {
  const of_tool = presets[tool.op] ?? [];
  if (of_tool.length === 0) return null;
  const take = (index: number) => {
    const preset = of_tool[index]!;
    set_values.value = {...set_values.value, [tool.op]: preset.values};
    set_brush.value = {...set_brush.value, ...preset.brush};
  };
  return (
    <div class="chips presets" role="group" aria-label="Presets">
      {of_tool.map((preset, k) => <button key={preset.name} type="button" class="chip" onClick={() => take(k)}>{preset.name}</button>)}
    </div>
  );
}

function Guides({op}: {op: "flow" | "interpolate"}) {
  const guides = guidesOf(op);
  return (
    <section>
      <h3>{op === "flow" ? "Guides" : "Keys"}</h3>
      <p class="help">{op === "flow" ? "Draw on the body: fur follows the line." : "Draw short lines: fur between them follows."} Drag points to move them.</p>
      {guides.map((guide, k) => (
        <div class="list-row" key={k}><span>{op === "flow" ? "Guide" : "Key"} {k + 1}</span><small>{guide.length} points</small>
          <button type="button" onClick={() => void removeGuide(op, k)}>Delete</button></div>
      ))}
      {guides.length > 0 && <button type="button" onClick={() => void layAgain(op)}>Lay again with these settings</button>}
    </section>
  );
}

/** Named blowers and attractors: made here, moved in the picture. */
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
      <h3>{op === "blow" ? "Blowers that stay" : "Attractors that stay"}</h3>
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
      {more.length > 0 && <details class="group"><summary>More of {tool.name}</summary>{form(more)}</details>}
    </>
  );
}

function BrushSettings() {
  const main = brush_members.value.filter(({name}) => main_brush.includes(name));
  const more = brush_members.value.filter(({name}) => !main_brush.includes(name) && !in_the_bar.includes(name));
  return (
    <section>
      <h3>Brush</h3>
      <Form members={main} values={brush.value} set={setBrush} />
      <details class="group"><summary>More of the brush</summary><Form members={more} values={brush.value} set={setBrush} /></details>
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
      {tool.floods && <button type="button" class="wide" onClick={() => flood(tool)}>{name} everywhere</button>}
      {(op === "flow" || op === "interpolate") && <Guides op={op} />}
      {(op === "blow" || op === "attract") && <Standing op={op} />}
      <MaskSection />
    </>
  );
}
