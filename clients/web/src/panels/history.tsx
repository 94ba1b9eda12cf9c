// The history panel: all steps of the log, newest first. A press on a step goes there; the button beside it shows details.
import {signal} from "@preact/signals";
import {storedSignal, author} from "../api/identity";
import {log_read, scene, settings} from "../scene/session";
import {checkpoints, commandsIn, first_revision, present, steps, touchedBy, type Step} from "../scene/steps";
import {layerOf, shareOfFur, stepWords} from "../scene/step_words";
import {goTo} from "../scene/travel";
import {Icon} from "../tools/icons";
import {CopyDialog} from "./copy_dialog";
import {Checkpoints} from "./checkpoints";
import {StepDetail} from "./step_detail";
import {StepIcon} from "./step_icon";

/** A row of the list: a step, or an amendment with the steps that it replayed. */
interface Row { step: Step; replays: Step[]; inner: boolean }

const window_size = 200;
const shown_rows = signal(window_size);
const only_in_effect = storedSignal("history-in-effect", false);
/** Revision of the step whose detail is open. */
const opened = signal<number | null>(null);
/** Amendments, by first revision, that the user folded (false) or unfolded (true). */
const unfolded = signal<Record<number, boolean>>({});

const isOpen = (row: Row) => unfolded.value[row.step.first] ?? row.replays.some(({in_effect}) => in_effect);

/** Returns the rows, newest first, each amendment before the steps that it replayed. */
function rowsOf(all: Step[]): Row[] {
  const groups: Row[] = [];
  for (const step of all) {
    const newest = groups[groups.length - 1];
    if (step.kind === "replay" && newest) newest.replays.push(step);
    else groups.push({step, replays: [], inner: false});
  }
  return groups.reverse().flatMap((row) => {
    const inner = isOpen(row) ? [...row.replays].reverse().map((step): Row => ({step, replays: [], inner: true})) : [];
    return [row, ...inner];
  });
}

/** Arrow keys go from step to step. */
function arrows(event: KeyboardEvent) {
  const step = {ArrowUp: -1, ArrowDown: 1}[event.key];
  const list = event.currentTarget as HTMLElement;
  if (!step || !(event.target as HTMLElement).closest(".step-go")) return;
  const all = [...list.querySelectorAll<HTMLElement>(".step-go")];
  const next = all[all.indexOf((event.target as HTMLElement).closest<HTMLElement>(".step-go")!) + step];
  if (!next) return;
  event.preventDefault();
  next.focus();
}

const by = (step: Step) => (step.author && step.author !== author.value ? `${step.author}, ` : "");

function about(row: Row): string {
  const {step} = row;
  if (row.replays.length) return `${by(step)}${row.replays.length === 1 ? "1 step" : `${row.replays.length} steps`} ran again`;
  const {count, exact} = touchedBy(step);
  const layer = layerOf(step);
  const changed = step.kind !== "revert" && count === 0 ? "setting" : shareOfFur(count, exact);
  return `${by(step)}${changed}${layer ? `, in ${layer}` : ""}`;
}

function StepRow({row, here, names}: {row: Row; here: boolean; names: string[]}) {
  const {step} = row;
  const amended = row.replays.length > 0;
  const to = row.replays[row.replays.length - 1]?.last ?? step.last;
  const name = amended ? "Changed an earlier step" : stepWords(step);
  const open = amended ? isOpen(row) : opened.value === step.last;
  const toggle = () => {
    if (amended) unfolded.value = {...unfolded.value, [step.first]: !open};
    else opened.value = open ? null : step.last;
  };
  const live = step.in_effect || row.replays.some(({in_effect}) => in_effect);
  const kind = `step${live ? "" : " step-out"}${row.inner ? " step-inner" : ""}${here ? " step-here" : ""}`;
  return (
    <li class={kind} data-revision={to}>
      <div class="step-line">
        <button type="button" class="step-go" aria-current={here ? "step" : undefined} title={here ? "The groom is at this step" : "Go to this step; the other steps stay in the list"} onClick={() => void goTo(to)}>
          <StepIcon step={step} amended={amended} />
          <span class="step-words"><span class="step-name">{name}</span><small>{about(row)}{!live && <span class="hidden">, not in effect</span>}</small></span>
          {names.map((one) => <span key={one} class="tag">{one}</span>)}
        </button>
        <button type="button" class="quiet step-more" aria-expanded={open} aria-label={`${amended ? "Steps of" : "More of"} ${name}, revision ${to}`} onClick={toggle}>
          <Icon sign={amended ? "fold" : "more"} /></button>
      </div>
      {open && !amended && <StepDetail step={step} close={() => { opened.value = null; }} />}
    </li>
  );
}

/** Returns the checkpoint names of a step's revisions, except those that the step itself creates. */
function namesOf(step: Step, names: Map<number, string[]>): string[] {
  return step.entries.flatMap((entry) => (commandsIn(entry).some(({op}) => op === "checkpoint") ? [] : names.get(entry.revision) ?? []));
}

function FirstRow() {
  const first = first_revision.value;
  const here = present.value === null;
  return (
    <li class={`step${here ? " step-here" : ""}`} data-revision={first}>
      <div class="step-line">
        <button type="button" class="step-go" aria-current={here ? "step" : undefined} onClick={() => void goTo(first)}>
          <Icon sign="coat" /><span class="step-words"><span class="step-name">First groom</span></span>
        </button>
      </div>
    </li>
  );
}

export function HistoryPanel() {
  if (!scene.value) return <p class="help">No scene is open.</p>;
  if (!settings.value || !log_read.value) return <p class="help" role="status">Reading the steps…</p>;
  const all = steps.value;
  const rows = rowsOf(only_in_effect.value ? all.filter(({in_effect}) => in_effect) : all);
  const seen = rows.slice(0, shown_rows.value);
  const here = present.value?.last;
  const names = new Map<number, string[]>();
  for (const {name, revision} of checkpoints.value) names.set(revision, [...names.get(revision) ?? [], name]);
  return (
    <>
      <Checkpoints />
      <label class="check"><input type="checkbox" checked={only_in_effect.value} onChange={(event) => { only_in_effect.value = event.currentTarget.checked; }} />Only steps in effect</label>
      <ol class="steps" aria-label="Steps, newest first" reversed onKeyDown={arrows}>
        {seen.map((row) => <StepRow key={row.step.first} row={row} here={row.step.last === here} names={namesOf(row.step, names)} />)}
        {seen.length === rows.length && <FirstRow />}
      </ol>
      {seen.length < rows.length && (
        <button type="button" class="wide" onClick={() => { shown_rows.value += window_size; }}>Show {Math.min(window_size, rows.length - seen.length)} more of {rows.length - seen.length}</button>
      )}
      <CopyDialog />
    </>
  );
}
