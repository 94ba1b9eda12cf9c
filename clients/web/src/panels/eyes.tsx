// The eyes panel: a press on the model places eyes, in pairs. Their handles are in the picture while this panel is open.
import {useEffect} from "preact/hooks";
import type {Command, Vector} from "../api/types";
import {edit_all_eyes, isOnMirrorPlane, pairSymmetry, partnerOf, sunk_share, type Eye} from "../scene/eyes";
import {eyes} from "../scene/live_setting";
import {run, scene} from "../scene/session";
import {Form} from "../tools/form";
import {membersOf, schemas} from "../tools/schema";
import {orbit, pinholeOf} from "../view/camera";
import {chosen_eye, shows_eyes} from "../view/gizmos";
import {imagesOnSkin} from "../view/mirror";
import type {Hit} from "../view/proxy";
import {scale, subtract, unit} from "../view/vector";
import {pending_pick, proxy} from "../view/surface";

const bare_radii = 1.7;      // radius of the furless skin around an eye, in radii of the eye
const first_radius = 0.02;   // radius of the first eye, in sizes; same as a new creature's
/** Members that belong to one eye alone, also while eyes are edited together. */
const own = ["position", "gaze", "look_at"];

const maxEyes = () => schemas.value["SetEyes"] && membersOf(schemas.value["SetEyes"]).find(({name}) => name === "eyes")?.schema.maxItems || 8;

/** Returns an eye at a hit point, with the other members of `like`. */
function eyeAt(hit: Hit, like: Eye | undefined): Eye {
  const radius = like?.radius ?? first_radius;
  const {look_at: _, ...rest} = like ?? {lids: {}} as Partial<Eye>;
  const lids = rest.lids ? {...rest.lids, facing: hit.normal} : undefined;
  return {...rest, ...(lids ? {lids} : {}), radius, gaze: hit.normal, position: subtract(hit.point, scale(hit.normal, sunk_share * radius * (scene.value?.size ?? 1)))};
}

/** Returns the command that removes fur within `bare_radii` of an eye's centre. */
function clearing(eye: Eye): Command {
  const radius = bare_radii * (eye.radius ?? first_radius);
  return {op: "paint", field: "density", value: 0, brush: {radius, strength: 1, falloff: "constant", symmetry: {planes: []}}, stroke: {samples: [{position: eye.position}]}};
}

function place(now: Eye[], took: (index: number) => void) {
  pending_pick.value = {says: "Press where the eye goes. An eye on one side gets a mirrored partner.", take: (hit) => {
    const like = now[now.length - 1];
    const alone = isOnMirrorPlane(hit.point, (like?.radius ?? first_radius) * (scene.value?.size ?? 1));
    const pair = proxy.value && !alone ? imagesOnSkin(hit, pairSymmetry(), proxy.value) : [];
    const placed = [hit, ...pair].map((one) => eyeAt(one, like)).slice(0, maxEyes() - now.length);
    took(now.length);
    void run({op: "set_eyes", eyes: [...now, ...placed]}, ...placed.map(clearing));
  }};
}

/** Returns the eyes after a change of one member of one eye; if eyes are edited together, of the others, too. The tilt of
 * lids is mirrored, not copied. */
function changed(now: Eye[], index: number, name: string, value: unknown): Eye[] {
  return now.map((eye, k) => {
    if (k === index) {
      const {gaze, look_at, ...rest} = eye;
      const looks = name === "gaze" ? {} : name === "look_at" ? {} : {...(gaze ? {gaze} : {}), ...(look_at ? {look_at} : {})};
      return {...rest, ...looks, [name]: value} as Eye;
    }
    if (!edit_all_eyes.value || own.includes(name)) return eye;
    if (name !== "lids" || !eye.lids || !value) return {...eye, [name]: value} as Eye;
    const {facing, tilt_degrees} = eye.lids;
    return {...eye, lids: {...value, ...(facing ? {facing} : {}), ...(tilt_degrees === undefined ? {} : {tilt_degrees})}};
  });
}

const without = ({lids: _, ...eye}: Eye): Eye => eye;

function OneEye({now, index}: {now: Eye[]; index: number}) {
  const eye = now[index]!;
  const members = membersOf(schemas.value["Eye"] ?? {}).map((member) => (member.name === "radius" ? {...member, schema: {...member.schema, minimum: 0.002, maximum: 0.2}} : member));
  const hidden = new Set([eye.look_at ? "gaze" : "look_at", ...(eye.lids ? [] : ["lids"])]);
  const camera = () => pinholeOf(orbit.value).position;
  const lids = (on: boolean) => eyes.set(now.map((one, k) => (k !== index && !edit_all_eyes.value ? one : on ? {...one, lids: {}} : without(one))), true);
  return (
    <div class="eye">
      <div class="buttons">
        <button type="button" onClick={() => eyes.set(changed(now, index, "gaze", unit(subtract(camera(), eye.position as Vector))), true)}>Look at me</button>
        <button type="button" onClick={() => { const partner = partnerOf(now, index); eyes.set(now.filter((_, k) => k !== index && k !== partner), true); }}>{partnerOf(now, index) < 0 ? "Delete" : "Delete the pair"}</button>
        <label><input type="checkbox" checked={Boolean(eye.lids)} onChange={(event) => lids(event.currentTarget.checked)} /> Lids</label>
      </div>
      <Form members={members} values={eye} hidden={hidden} set={(name, value, done) => eyes.set(changed(now, index, name, value), done)} />
    </div>
  );
}

export function Eyes() {
  const chosen = chosen_eye;
  useEffect(() => {
    shows_eyes.value = true;
    return () => { pending_pick.value = null; shows_eyes.value = false; };
  }, []);
  const now = eyes.value.value;
  if (!now) return null;
  const index = Math.min(chosen.value, now.length - 1);
  return (
    <section>
      <h2>Eyes</h2>
      <div class="chips presets" role="group" aria-label="Eyes">
        {now.map((_, k) => <button key={k} type="button" class="chip" aria-pressed={k === index} onClick={() => { chosen.value = k; }}>Eye {k + 1}</button>)}
      </div>
      {now.length > 1 && <label class="check"><input type="checkbox" checked={edit_all_eyes.value} onChange={(event) => { edit_all_eyes.value = event.currentTarget.checked; }} /> Edit all eyes together</label>}
      <button type="button" aria-pressed={pending_pick.value !== null} disabled={now.length >= maxEyes()} onClick={() => { if (pending_pick.value) pending_pick.value = null; else place(now, (k) => { chosen.value = k; }); }}>Place an eye</button>
      {index >= 0 && <details class="group"><summary>Eye {index + 1}</summary><OneEye now={now} index={index} /></details>}
    </section>
  );
}
