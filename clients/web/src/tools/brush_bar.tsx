// Size and strength of the brush, within reach whichever panel is open.
import {brush_members} from "./catalogue";
import {scaleOf} from "./form";
import {shownNumber} from "./number_field";
import {plain, unitOf, words, type Member} from "./schema";
import {brush, setBrush} from "./state";

function BrushSlider({member, keys}: {member: Member; keys: string}) {
  const {step, shareOf, numberOf} = scaleOf(member);
  const number = Number(brush.value[member.name] ?? member.fallback ?? 0);
  const shown = `${shownNumber(number)} ${unitOf(member, brush.value["units"])}`.trim();
  return (
    <label class="brush-slider" title={`${plain(member.description)} (${keys})`}>
      <span>{words(member.name)}</span>
      <input type="range" min="0" max="1" step={step} value={shareOf(number)} aria-label={`Brush ${member.name}`} aria-valuetext={shown}
             onInput={(event) => setBrush(member.name, numberOf(Number(event.currentTarget.value)))} />
      <output>{shownNumber(number)}</output>
    </label>
  );
}

export function BrushBar() {
  const named = (name: string) => brush_members.value.find((member) => member.name === name);
  const [radius, strength] = [named("radius"), named("strength")];
  if (!radius || !strength) return null;
  return <div class="brush-bar" role="group" aria-label="Brush"><BrushSlider member={radius} keys="[ and ]" /><BrushSlider member={strength} keys="Shift+[ and Shift+]" /></div>;
}
