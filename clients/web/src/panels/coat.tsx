// The coat panel: parameters of the strands, a close-up of a patch, and looks to start with.
import type {Coat} from "../api/types";
import {coat, look} from "../scene/live_setting";
import {Form} from "../tools/form";
import {membersOf, schemas, type Member} from "../tools/schema";
import {Coats} from "./coats";
import {Looks} from "./looks";
import {Patch} from "./patch";
import {Ramp} from "./ramp";

/** Groups of members, chosen by their names; members that match no group come last. */
const groups: {label: string; of: RegExp; open?: boolean}[] = [
  {label: "Colour", of: /^(ramp|colour|warmth|ticking)/, open: true},
  {label: "Strands", of: /^(count|tile|width|length|root|lean|bend|mess)/, open: true},
  {label: "Clumps and tufts", of: /^(clump|fine_clump|lodge|tufts|wetness)/},
  {label: "Curls and waves", of: /^(curl|wave)/},
  {label: "Undercoat", of: /^undercoat$/},
  {label: "Pattern", of: /^pattern$/},
  {label: "Variation over the body", of: /^variation$/},
  {label: "More", of: /^/},
];
const groupOf = (member: Member) => groups.find(({of}) => of.test(member.name));
function Group({label, members, open}: {label: string; members: Member[]; open?: boolean | undefined}) {
  const now = coat.value.value as Record<string, unknown>;
  const set = (change: Record<string, unknown>, done: boolean) => coat.set({...now, ...change} as Coat, done);
  const only = members.length === 1 && members[0]!.kind === "object" ? members[0]! : null;
  const inner = (only ? now[only.name] : now) as Record<string, unknown>;
  const shown = only ? membersOf(only.schema) : members;
  const hidden = only?.name === "pattern" && inner["kind"] === "none" ? new Set(shown.map(({name}) => name).filter((name) => name !== "kind")) : undefined;
  return (
    <details class="group" open={open}>
      <summary>{label}</summary>
      {members.some(({name}) => name === "ramp") && <ColourSource />}
      {members.some(({name}) => name === "ramp") && <Ramp stops={coat.value.value!.ramp!} set={(ramp, done) => set({ramp}, done)} />}
      <Form members={shown} values={inner} hidden={hidden} set={(name, value, done) => set(only ? {[only.name]: {...inner, [name]: value}} : {[name]: value}, done)} />
    </details>
  );
}

/** A hint for models with their own colours: these replace the coat's unless the colour source is the coat. */
function ColourSource() {
  const now = look.value.value;
  if (!now || now.colour_source === "coat") return null;
  return (
    <p class="help">The model's own colours replace these. <button type="button" onClick={() => look.set({...now, colour_source: "coat"}, true)}>Show the coat's colours</button></p>
  );
}

export function CoatPanel() {
  if (!coat.value.value) return null;
  const members = membersOf(schemas.value["Coat"] ?? {});
  return (
    <>
      <details class="group" open><summary>Coats</summary><Coats /></details>
      <Patch />
      <details class="group" open><summary>Looks to begin with</summary><Looks /></details>
      {groups.map((group) => {
        const own = members.filter((member) => groupOf(member) === group);
        return own.length > 0 && <Group key={group.label} label={group.label} members={own} open={group.open} />;
      })}
    </>
  );
}
