// The mask panel. The mask says where tools work: 1 is editable, 0 is protected.
import {computed, effect} from "@preact/signals";
import {storedSignal} from "../api/identity";
import type {Command} from "../api/types";
import {run, scene} from "../scene/session";
import {schemaOf} from "../tools/catalogue";
import {Form} from "../tools/form";
import {Icon} from "../tools/icons";
import {panel} from "../shell/ui_state";
import {forbidden, membersOf} from "../tools/schema";
import {current, setValue, valuesOf} from "../tools/state";
import {masked, overlay} from "../view/quality";
import {pending_pick} from "../view/surface";

/** Settings for growing and softening the mask's edge; the contract's defaults unless the user sets them. */
const edge = storedSignal<Record<string, unknown>>("mask-edge", {});
const edge_members = ["distance", "units", "passes"];

export const toggleMasked = () => { masked.value = !masked.value; };

export function toggleMask() {
  overlay.value = overlay.value === "mask" ? "none" : "mask";
}

const painting = computed(() => panel.value === "tool" && current.value === "paint" && valuesOf("paint")["field"] === "mask");

/** Shows the mask overlay while the mask is painted and hides it afterwards, because it would hide coat and lights. */
export function followMask(): () => void {
  let shown_by_itself = painting.peek() && overlay.peek() === "mask";
  return effect(() => {
    if (painting.value && overlay.peek() === "none") {
      overlay.value = "mask";
      shown_by_itself = true;
    } else if (!painting.value && shown_by_itself) {
      if (overlay.peek() === "mask") overlay.value = "none";
      shown_by_itself = false;
    }
  });
}

function change(action: string) {
  const command: Command = {op: "mask", action, ...edge.value};
  for (const name of forbidden(schemaOf("mask"), command)) delete command[name];
  if (command["distance"] === undefined) delete command["units"];
  if (scene.value) void run(command);
}
export const invertMask = () => change("invert");

function select(shape: Record<string, unknown>) {
  void run({op: "mask", action: "select", ...shape});
  if (overlay.value === "none") overlay.value = "mask";
}

/** Lets the next press on the model choose the part that tools work on. */
function choosePart() {
  pending_pick.value = {says: "Press on the part that tools may change; all others are protected.", take: ({point}) => select({part: {position: point}})};
}

/** A menu of the model's materials; tools then work on the chosen one. */
function Materials() {
  const materials = scene.value?.materials ?? [];
  if (materials.length < 2) return null;
  return (
    <label class="mask-material"><span>Material</span>
      <select value="" title="Limits tools to one material of the model" onChange={(event) => select({material: {name: event.currentTarget.value}})}>
        <option value="" disabled>Choose…</option>
        {materials.map(({name}) => <option key={name} value={name}>{name}</option>)}
      </select></label>
  );
}

function paint(value: number) {
  setValue("paint", "field", "mask");
  setValue("paint", "value", value);
  current.value = "paint";
}

export function MaskSection() {
  const schema = schemaOf("mask");
  const members = membersOf(schema).filter(({name}) => edge_members.includes(name));
  const {field, value} = valuesOf("paint");
  const paints = (what: number) => current.value === "paint" && field === "mask" && value === what;
  const shown = overlay.value === "mask";
  return (
    <section aria-label="Mask">
      <div class="section-head"><h3>Mask</h3>
        <button type="button" class="chip" aria-pressed={shown} title="Yellow where tools work, violet where they do not (M)" onClick={toggleMask}><Icon sign="eye" />Show</button>
        <button type="button" class="chip" aria-pressed={masked.value} title="Shows only what tools may change (Shift+M)" onClick={toggleMasked}>Hide the rest</button></div>
      <div class="mask-buttons">
        <span>Paint</span>
        <button type="button" aria-pressed={paints(0)} title="Paint areas that tools leave unchanged" onClick={() => paint(0)}>Protect</button>
        <button type="button" aria-pressed={paints(1)} title="Paint areas that tools may change" onClick={() => paint(1)}>Free</button>
        <button type="button" title="Limits tools to one part of the model" onClick={choosePart}>A part…</button>
      </div>
      <Materials />
      <div class="mask-buttons">
        <button type="button" title="Protect what is free, free what is protected (Ctrl+I)" onClick={invertMask}>Invert</button>
        <button type="button" title="Enlarge the free area" onClick={() => change("grow")}>Grow</button>
        <button type="button" title="Reduce the free area" onClick={() => change("shrink")}>Shrink</button>
        <button type="button" title="Soften the edge" onClick={() => change("smooth")}>Blur</button>
        <button type="button" title="Free everything" onClick={() => change("select")}>Clear</button>
      </div>
      <details class="group"><summary>Grow, shrink and blur by</summary>
        <Form members={members} values={edge.value} set={(name, to) => { edge.value = {...edge.value, [name]: to}; }} />
      </details>
    </section>
  );
}
