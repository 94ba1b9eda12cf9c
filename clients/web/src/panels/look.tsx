// The look panel: shading of fur, skin and eyes, and the view's overlays.
import type {Settings} from "../api/types";
import {look} from "../scene/live_setting";
import {run, settings} from "../scene/session";
import {takePicture} from "../scene/upload";
import {Form} from "../tools/form";
import {membersOf, resolved, schemas, words, type Member} from "../tools/schema";
import {background, exposure, overlay} from "../view/quality";
import {Eyes} from "./eyes";
import {FileButton} from "./file_button";

type Look = Settings["look"];

/** Title and one line for each shading model; others show only their name from the contract. */
const models: Record<string, {title: string; line: string}> = {
  energy_conserving: {title: "Energy-conserving", line: "Light passes through and around each fibre, and none is lost."},
  marschner: {title: "Marschner", line: "Three highlights of a hair, with the glints of its cross-section."},
  scheuermann: {title: "Scheuermann", line: "Two shifted highlights, one white and one in the hair's colour. Fast."},
  kajiya_kay: {title: "Kajiya-Kay", line: "One highlight around a cylinder, and diffuse light."},
  kajiya: {title: "Kajiya", line: "A hair as a thin cylinder, with shadow inside the fur."},
  lengyel: {title: "First fur shells", line: "Light at vertices only."},
};

function Shading({now}: {now: Look}) {
  const names = (resolved(schemas.value["Look"]?.properties?.["shading"] as object).enum ?? []) as string[];
  const ordered = [...names].sort((a, b) => Object.keys(models).indexOf(a) - Object.keys(models).indexOf(b));
  return (
    <fieldset class="models">
      <legend>Shading</legend>
      {ordered.map((name) => (
        <label key={name}>
          <input type="radio" name="shading" checked={now.shading === name} onChange={() => look.set({...now, shading: name as Look["shading"]}, true)} />
          <span><b>{models[name]?.title ?? words(name)}</b>{models[name] && <small>{models[name].line}</small>}</span>
        </label>
      ))}
    </fieldset>
  );
}

/** Returns the members to hide: those whose descriptions name shading models other than the current one. */
function notOf(shading: string, members: Member[]): Set<string> {
  const names = (resolved(schemas.value["Look"]?.properties?.["shading"] as object).enum ?? []) as string[];
  const named = (member: Member) => names.filter((name) => new RegExp(`\\b${name}\\b`).test(member.description));
  return new Set(members.filter((member) => named(member).length > 0 && !named(member).includes(shading)).map(({name}) => name));
}

function Fur({now}: {now: Look}) {
  const members = membersOf(schemas.value["Look"] ?? {}, ["shading", "fibre", "skin"]);
  const fibre = membersOf(schemas.value["Fibre"] ?? {});
  const inner = (now.fibre ?? {}) as Record<string, unknown>;
  const not_read = notOf(String(now.shading), fibre);
  if (inner["absorption"] !== "melanin") not_read.add("eumelanin").add("pheomelanin");
  return (
    <>
      <Form members={members} values={now} hidden={notOf(String(now.shading), members)} set={(name, value, done) => look.set({...now, [name]: value} as Look, done)} />
      <details class="group">
        <summary>Fibre</summary>
        <Form members={fibre} values={inner} hidden={not_read} set={(name, value, done) => look.set({...now, fibre: {...inner, [name]: value}} as Look, done)} />
      </details>
    </>
  );
}

function Skin({now}: {now: Look}) {
  const colour = membersOf(schemas.value["Look"] ?? {}).filter(({name}) => name === "skin");
  const own = settings.value?.skin_texture === "own";
  return (
    <section>
      <h2>Skin</h2>
      <Form members={colour} values={now} set={(name, value, done) => look.set({...now, [name]: value} as Look, done)} />
      <p class="help">{own ? "A model with texture coordinates can wear a picture." : "The model shows your picture."}</p>
      <FileButton accept="image/*" take={takePicture}>Skin texture…</FileButton>
      {!own && <button type="button" onClick={() => void run({op: "set_skin_texture", picture: "own"})}>Remove the picture</button>}
    </section>
  );
}

/** Overlays that do not show a field of the fur. */
const other_overlays = ["difference", "light_depth", "light_occlusion", "shadow_width"];
const shown_stops = {minimum: -4, maximum: 4};

function View() {
  const members = membersOf(schemas.value["FrameRequest"] ?? {});
  const of = (name: string, change: object) => members.filter((member) => member.name === name).map((member) => ({...member, schema: {...member.schema, ...change}}));
  const fields = (of("overlay", {})[0]?.schema.enum ?? []).filter((name) => !other_overlays.includes(String(name)));
  const plain = background.value !== "studio";
  return (
    <section>
      <h2>View</h2>
      <p class="help">These settings change only your view, not the scene.</p>
      <div class="row"><label for="view-background">Background</label>
        <select id="view-background" value={plain ? "plain" : "studio"} onChange={(event) => { background.value = event.currentTarget.value === "studio" ? "studio" : "#8f9498"; }}>
          <option value="studio">Studio</option><option value="plain">One colour</option>
        </select></div>
      {plain && <div class="row"><label for="view-colour">Colour</label>
        <input id="view-colour" type="color" value={background.value} onInput={(event) => { background.value = event.currentTarget.value; }} /></div>}
      <Form members={of("exposure", shown_stops)} values={{exposure: exposure.value}} set={(_, value) => { exposure.value = Number(value); }} />
      <Form members={of("overlay", {enum: fields})} values={{overlay: overlay.value}} set={(_, value) => { overlay.value = value as typeof overlay.value; }} />
    </section>
  );
}

export function LookPanel() {
  const now = look.value.value;
  if (!now) return null;
  return (
    <>
      <Shading now={now} />
      <Fur now={now} />
      <Skin now={now} />
      <Eyes />
      <View />
    </>
  );
}
