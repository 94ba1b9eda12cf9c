// The panel for lights, the environment and the ground. Lights have handles in the picture while this panel is open.
import {useEffect, useId} from "preact/hooks";
import type {Settings, Vector} from "../api/types";
import {environment, ground, lights} from "../scene/live_setting";
import {intensityOf, isRig, max_intensity, rig_names, turnOf, withIntensity, withRig, withTurn, type Light} from "../scene/rig";
import {scene} from "../scene/session";
import {shownNumber} from "../tools/number_field";
import {takePicture} from "../scene/upload";
import {toHex} from "../tools/colour";
import {Form} from "../tools/form";
import {membersOf, schemas, words, type Member} from "../tools/schema";
import {axes, orbit} from "../view/camera";
import {chosen_light, lightBall, shows_lights} from "../view/gizmos";
import {add, scale, unit} from "../view/vector";
import {FileButton} from "./file_button";

type Environment = Settings["environment"];
type Ground = Settings["ground"];

const maxLights = () => membersOf(schemas.value["SetLights"] ?? {}).find(({name}) => name === "lights")?.schema.maxItems ?? 8;

/** Returns a directional light that shines from above and to the left of the camera. */
function newLight(): Light {
  const {right, up, forward} = axes(orbit.value);
  return {kind: "directional", direction: unit(add(forward, add(scale(right, 0.8), scale(up, -0.9)))), intensity: 0.8, cast_shadow: "penumbra"};
}

/** Returns the kinds of light that a member applies to, from its description, such as "a point or spot light"; undefined
 * for all kinds. */
const kindsOf = ({name, description}: Member) => (name === "kind" ? undefined : /\ban? ((?:\w+(?:, | or ))*\w+) light\b(?!')/.exec(description)?.[1]?.split(/, | or /));

function notOf(light: Light, members: Member[]): Set<string> {
  const kind = light.kind ?? "directional";
  return new Set(members.filter((member) => !(kindsOf(member)?.includes(kind) ?? true)).map(({name}) => name));
}

/** Returns the light with one member changed. A directional light that becomes another kind gets its handle's position. */
function changed(light: Light, name: string, value: unknown): Light {
  const next = {...light, [name]: value} as Light;
  const ball = lightBall();
  if (name !== "kind" || value === "directional" || light.kind !== "directional" || !ball) return next;
  return {...next, position: add(ball.middle, scale(unit((light.direction ?? [0, -1, 0]) as Vector), -ball.radius))};
}

function OneLight({now, index}: {now: Light[]; index: number}) {
  const light = now[index]!;
  const members = membersOf(schemas.value["Light"] ?? {}).map((member) => (member.name === "intensity" ? {...member, schema: {...member.schema, maximum: Math.max(5, Number(light.intensity ?? 1))}} : member));
  const set = (name: string, value: unknown, done: boolean) => lights.set(now.map((one, k) => (k === index ? changed(one, name, value) : one)), done);
  return (
    <>
      <Form members={members} values={light} hidden={notOf(light, members)} set={set} />
      <button type="button" onClick={() => lights.set(now.filter((_, k) => k !== index), true)}>Delete light {index + 1}</button>
    </>
  );
}

function RigSlider({label, value, range: [min, max], step, unit: sign, set}: {label: string; value: number; range: [number, number]; step: number; unit: string; set: (to: number, done: boolean) => void}) {
  const id = useId();
  const to = (event: Event) => Number((event.currentTarget as HTMLInputElement).value);
  return (
    <div class="row">
      <label for={id}>{label}</label>
      <input id={id} type="range" min={min} max={max} step={step} value={value} onInput={(event) => set(to(event), false)} onChange={(event) => set(to(event), true)} />
      <output for={id}>{shownNumber(value)}{sign}</output>
    </div>
  );
}

/** The light rig: a slider for the intensity of each of three lights and one that turns all; the rest is done by handles. */
function Rig({now}: {now: Light[]}) {
  if (!isRig(now)) return <button type="button" class="wide" onClick={() => lights.set(withRig(now), true)}>Key, fill and rim light</button>;
  return (
    <div class="rig" role="group" aria-label="Light rig">
      {rig_names.map((name, k) => (
        <RigSlider key={name} label={name} value={intensityOf(now, k)} range={[0, max_intensity]} step={0.05} unit="" set={(to, done) => lights.set(withIntensity(now, k, to), done)} />
      ))}
      <RigSlider label="Turn" value={turnOf(now)} range={[-180, 180]} step={1} unit="°" set={(to, done) => lights.set(withTurn(now, to), done)} />
    </div>
  );
}

function Lights() {
  const now = lights.value.value;
  if (!now) return null;
  const index = Math.min(chosen_light.value, now.length - 1);
  const put = () => {
    chosen_light.value = now.length;
    lights.set([...now, newLight()], true);
  };
  return (
    <>
      <h2>Lights</h2>
      <Rig now={now} />
      {now.length > 0 && <p class="help">Drag the handles around the model.</p>}
      <details class="group"><summary>Each light</summary>
        <div class="light-list" role="group" aria-label="Lights">
          {now.map((light, k) => (
            <button key={k} type="button" aria-pressed={k === index} onClick={() => { chosen_light.value = k; }}>
              <span class="swatch" style={{background: toHex(light.colour)}} aria-hidden="true" />{isRig(now) && rig_names[k] ? rig_names[k] : `Light ${k + 1}`}<small>{words(light.kind ?? "directional")}</small>
            </button>
          ))}
        </div>
        <button type="button" disabled={now.length >= maxLights()} onClick={put}>Add a light</button>
        {index >= 0 && <OneLight now={now} index={index} />}
      </details>
    </>
  );
}

const picture_members = ["turn_degrees"];

function Around() {
  const now = environment.value.value;
  if (!now) return null;
  const members = membersOf(schemas.value["Environment"] ?? {});
  const from_picture = Boolean(now.harmonics);
  const hidden = new Set(members.filter(({name, kind}) => (from_picture ? kind === "colour" : picture_members.includes(name))).map(({name}) => name));
  return (
    <section>
      <h2>Light from all around</h2>
      <Form members={members} values={now} hidden={hidden} set={(name, value, done) => environment.set({...now, [name]: value} as Environment, done)} />
      <FileButton accept=".hdr,.exr" take={takePicture}>{from_picture ? "Another picture" : "From a picture"} (HDR, EXR)…</FileButton>
      {from_picture && <button type="button" onClick={() => environment.set({intensity: now.intensity ?? 1}, true)}>Back to three colours</button>}
    </section>
  );
}

/** Returns the slider's range of the ground's height: half the model's height below and above its lowest point. */
function heightRange(): {minimum: number; maximum: number; fallback: number} {
  const {min, max} = scene.value!.bounds as {min: Vector; max: Vector};
  const half = (max[1] - min[1]) / 2;
  return {minimum: min[1] - half, maximum: min[1] + half, fallback: min[1]};
}

function Below() {
  const now = ground.value.value;
  if (!now || !scene.value) return null;
  const {fallback, ...range} = heightRange();
  const members = membersOf(schemas.value["Ground"] ?? {}).map((member) => (member.name === "height" ? {...member, fallback, schema: {...member.schema, ...range}} : member));
  const hidden = new Set(now.visible ? [] : members.map(({name}) => name).filter((name) => name !== "visible"));
  return (
    <section>
      <h2>Ground</h2>
      <Form members={members} values={now} hidden={hidden} set={(name, value, done) => ground.set({...now, [name]: value} as Ground, done)} />
    </section>
  );
}

export function LightPanel() {
  useEffect(() => {
    shows_lights.value = true;
    return () => { shows_lights.value = false; };
  }, []);
  return <><Lights /><Around /><Below /></>;
}
