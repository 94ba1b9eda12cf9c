// The wind that moves the fur, and a clock to watch it by.
import type {Settings} from "../api/types";
import {wind} from "../scene/live_setting";
import {Form} from "../tools/form";
import {membersOf, schemas, type Member} from "../tools/schema";
import {moment, pause, play, playing, rewind} from "../view/clock";

type Wind = Settings["wind"];

const breeze = 0.5;        // sizes per second
const fastest_slider = 3;  // the contract goes to storms that no hand needs

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
      <button type="button" disabled={moment.value === null || playing.value} title="Makes this the time that the scene's pictures show"
              onClick={() => { wind.set({...now, time: Number(at.toFixed(3))}, true); rewind(); }}>Keep this time</button>
      <output aria-label="Time shown">{at.toFixed(2)} s</output>
    </div>
  );
}

export function WindPanel() {
  const now = wind.value.value;
  if (!now) return null;
  const members = membersOf(schemas.value["Wind"] ?? {}).map((member) => withUsualEnds(member, now));
  return (
    <section>
      <h2>Wind</h2>
      <Clock now={now} />
      <Form members={members} values={now} set={(name, value, done) => wind.set({...now, [name]: value} as Wind, done)} />
      <p class="help">The wind turns the lean of the fur and leaves the groom as it is. Paint the field stiffness where fur is to move less.</p>
    </section>
  );
}
