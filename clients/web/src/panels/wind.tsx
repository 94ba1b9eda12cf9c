// The wind panel: the wind that moves the fur, and a clock to play it.
import {useId} from "preact/hooks";
import type {Settings, Vector} from "../api/types";
import {wind} from "../scene/live_setting";
import {Form} from "../tools/form";
import {membersOf, schemas, type Member} from "../tools/schema";
import {moment, pause, play, playing, rewind} from "../view/clock";

type Wind = Settings["wind"];

const breeze = 0.5;        // sizes per second
const fastest_slider = 3;  // sizes per second; the contract allows much more

function withUsualEnds(member: Member, now: Wind): Member {
  if (member.name !== "speed") return member;
  return {...member, fallback: breeze, schema: {...member.schema, maximum: Math.max(fastest_slider, now.speed ?? 0)}};
}

function Clock({now}: {now: Wind}) {
  const at = moment.value ?? now.time ?? 0;
  if (!now.speed) return (
    <>
      <p class="help">Nothing moves while the speed is 0.</p>
      <button type="button" onClick={() => wind.set({...now, speed: breeze}, true)}>Start a breeze</button>
    </>
  );
  return (
    <div class="clock" role="group" aria-label="Time">
      <button type="button" aria-pressed={playing.value} onClick={() => (playing.value ? pause() : play(at))}>{playing.value ? "Pause" : "Play"}</button>
      <button type="button" disabled={moment.value === null} onClick={rewind}>Stop</button>
      <button type="button" disabled={moment.value === null || playing.value} title="Makes all pictures of the scene show this time"
              onClick={() => { wind.set({...now, time: Number(at.toFixed(3))}, true); rewind(); }}>Keep this time</button>
      <output aria-label="Time shown">{at.toFixed(2)} s</output>
    </div>
  );
}

const sides = ["front", "front left", "left", "back left", "back", "back right", "right", "front right"];  // of the animal, every 45 degrees

/** Turns the wind around the vertical axis; its vertical component stays. */
function Heading({now}: {now: Wind}) {
  const id = useId();
  const [x, y, z] = (now.direction ?? [1, 0, 0]) as Vector;
  const degrees = Math.round((Math.atan2(x, z) * 180) / Math.PI), level = Math.hypot(x, z) || 1;
  const turn = (to: number, done: boolean) => {
    const angle = (to * Math.PI) / 180;
    wind.set({...now, direction: [level * Math.sin(angle), y, level * Math.cos(angle)]}, done);
  };
  return (
    <div class="row">
      <label for={id}>Wind blows towards the animal's</label>
      <input id={id} type="range" min="-180" max="180" step="1" value={degrees} aria-valuetext={sides[(Math.round(degrees / 45) + 8) % 8]}
             onInput={(event) => turn(Number(event.currentTarget.value), false)} onChange={(event) => turn(Number(event.currentTarget.value), true)} />
      <output>{sides[(Math.round(degrees / 45) + 8) % 8]}</output>
    </div>
  );
}

/** Members that are always visible; the others are in a collapsed group. */
const first_members = ["speed", "gusts", "turbulence"];

export function WindPanel() {
  const now = wind.value.value;
  if (!now) return null;
  const members = membersOf(schemas.value["Wind"] ?? {}).map((member) => withUsualEnds(member, now));
  const form = (some: Member[]) => <Form members={some} values={now} set={(name, value, done) => wind.set({...now, [name]: value} as Wind, done)} />;
  return (
    <section>
      <h2>Wind</h2>
      <Clock now={now} />
      <Heading now={now} />
      {form(members.filter(({name}) => first_members.includes(name)))}
      <details class="group"><summary>More wind settings</summary>{form(members.filter(({name}) => !first_members.includes(name)))}</details>
      <p class="help">The wind moves the fur without changing the groom. Paint Stiffness where fur should move less.</p>
    </section>
  );
}
