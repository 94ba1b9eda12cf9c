// Edits a step's parameters in forms made from the contract. A dry run shows what would change, then "Apply" amends the step.
import {useSignal} from "@preact/signals";
import {tryAmend} from "../api/client";
import type {Command, CommandAnswer} from "../api/types";
import {say, sayError} from "../scene/messages";
import {change, scene} from "../scene/session";
import {commandsIn, steps, touchedBy, fullCommands, type Step} from "../scene/steps";
import {amount, commandWords, stepWords, vertices} from "../scene/step_words";
import {alternatives, forbidden, membersOf, type Member} from "../tools/schema";
import {brush_members, schemaOf} from "../tools/catalogue";
import {Form} from "../tools/form";

type Values = Record<string, unknown>;
/** Members that say where a step works, not how; they stay as logged. */
const kept_as_is = ["op", "stroke", "brush", "flood", "edit_layer"];
const in_forms = ["number", "integer", "boolean", "choice", "choices", "colour", "vector", "text", "object"];

function editable(command: Command): Member[] {
  const others = alternatives(schemaOf(command.op));
  return membersOf(schemaOf(command.op), kept_as_is).filter(({name, kind}) => in_forms.includes(kind) && (!others.includes(name) || command[name] !== undefined));
}

/** Returns the command with one member changed, and without members that the contract's rules then forbid. */
function withMember(command: Command, name: string, value: unknown): Command {
  const changed: Command = {...command, [name]: value};
  for (const other of forbidden(schemaOf(command.op), changed)) delete changed[other];
  return changed;
}

/** Returns the later steps in effect, which an amendment runs again. */
const laterThan = (step: Step) => steps.value.filter((other) => other.in_effect && other.first > step.last);

const sum = (results: CommandAnswer["results"]) => results.reduce((total, {touched}) => total + touched, 0);

/** Describes a dry run's result in lines: this step, then each later step that would touch another number of vertices. */
function verdict(step: Step, count: number, answer: CommandAnswer): string[] {
  const {results} = answer;
  const was = touchedBy(step);
  const lines = [`${stepWords(step)}: ${vertices(sum(results.slice(0, count)))} (currently ${amount(was.count, was.exact)})`];
  const later = laterThan(step);
  let at = count;
  let same = 0;
  for (const one of later) {
    const many = commandsIn(one.entries[0]!).length;
    const touched = sum(results.slice(at, at + many));
    at += many;
    const before = touchedBy(one);
    if (touched === before.count || !before.exact) ++same;
    else lines.push(`${stepWords(one)}: ${vertices(touched)} (currently ${amount(before.count)})`);
  }
  if (later.length) lines.push(same === later.length ? `${same} later ${same === 1 ? "step runs" : "steps run"} again.` : `${same} of ${later.length} later steps change as many vertices as before.`);
  return [...lines, ...new Set(results.flatMap(({warnings}) => warnings))];
}

function CommandForm({command, set}: {command: Command; set: (command: Command) => void}) {
  const schema = schemaOf(command.op);
  const brush = (command["brush"] ?? {}) as Values;
  const has_brush = "brush" in (schema.properties ?? {});
  const main = brush_members.value.filter(({name}) => (command["flood"] ? name === "strength" : ["radius", "strength", "falloff"].includes(name)));
  const more = brush_members.value.filter((member) => !main.includes(member));
  const setBrush = (name: string, value: unknown) => set({...command, brush: {...brush, [name]: value}});
  return (
    <>
      <Form members={editable(command)} values={command} hidden={forbidden(schema, command)} set={(name, value) => set(withMember(command, name, value))} />
      {has_brush && <Form members={main} values={brush} set={setBrush} />}
      {has_brush && !command["flood"] && <details class="group"><summary>More brush settings</summary><Form members={more} values={brush} set={setBrush} /></details>}
    </>
  );
}

export function StepForm({step, close}: {step: Step; close: () => void}) {
  const logged = fullCommands(step);
  const commands = useSignal(logged);
  const chosen = useSignal(0);
  const tried = useSignal<string[] | null>(null);
  const busy = useSignal(false);
  const later = laterThan(step).length;
  const touched = commands.value !== logged && JSON.stringify(commands.value) !== JSON.stringify(logged);
  const set = (changed: Command) => {
    commands.value = commands.value.map((old, k) => (k === chosen.value ? changed : old));
    tried.value = null;
  };
  const attempt = async () => {
    busy.value = true;
    try {
      tried.value = verdict(step, commands.value.length, await tryAmend(scene.value!.id, {revision: step.last, commands: commands.value}));
    } catch (error) { sayError(error); }
    busy.value = false;
  };
  const amend = async (next: Command[], done: string) => {
    busy.value = true;
    const answer = await change("amend", {revision: step.last, commands: next});
    busy.value = false;
    if (!answer) return;
    say(done, `${later ? `${later} later ${later === 1 ? "step" : "steps"} ran again. ` : ""}Undo reverts this.`);
    close();
  };
  return (
    <>
      {commands.value.length > 1 && (
        <select aria-label="Command of this step" value={chosen.value} onChange={(event) => { chosen.value = Number(event.currentTarget.value); }}>
          {commands.value.map((command, k) => <option key={k} value={k}>{k + 1} of {commands.value.length}: {commandWords(command)}</option>)}
        </select>
      )}
      <CommandForm command={commands.value[chosen.value]!} set={set} />
      {tried.value && <div class="verdict" role="status"><ul>{tried.value.map((line, k) => <li key={k}>{line}</li>)}</ul></div>}
      <div class="step-actions">
        {tried.value
          ? <button type="button" class="primary" disabled={busy.value} onClick={() => void amend(commands.value, `Changed ${stepWords(step)}.`)}>Apply</button>
          : <button type="button" class="primary" disabled={busy.value || !touched} title="Shows what would change, without changing it" onClick={() => void attempt()}>Try</button>}
        <span class="grow" />
        <button type="button" class="danger" disabled={busy.value} onClick={() => void amend([], `Dropped ${stepWords(step)}.`)}>Drop this step</button>
      </div>
    </>
  );
}
