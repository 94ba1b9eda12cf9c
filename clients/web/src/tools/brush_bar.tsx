// The brush's radius and strength in the top bar, whichever panel is open; touch screens get buttons for Ctrl and Shift, too.
import {brush_members} from "./catalogue";
import {scaleOf} from "./form";
import {NumberField, shownNumber} from "./number_field";
import {plain, unitOf, words, type Member} from "./schema";
import {brush, inverting, setBrush, smoothing} from "./state";

function BrushSlider({member, keys}: {member: Member; keys: string}) {
  const {step, shareOf, numberOf} = scaleOf(member);
  const number = Number(brush.value[member.name] ?? member.fallback ?? 0);
  const shown = `${shownNumber(number)} ${unitOf(member, brush.value["units"])}`.trim();
  return (
    <div class="brush-slider" title={`${plain(member.description)} (${keys})`}>
      <span>{words(member.name)}</span>
      <input type="range" min="0" max="1" step={step} value={shareOf(number)} aria-label={`Brush ${member.name}`} aria-valuetext={shown}
             onInput={(event) => setBrush(member.name, numberOf(Number(event.currentTarget.value)))} />
      <NumberField label={`${words(member.name)}, as a number`} value={number} range={member.schema} take={(typed) => setBrush(member.name, typed)} />
    </div>
  );
}

/** Toggle buttons that replace holding Ctrl (opposite effect) and Shift (smooth). */
function HandButtons() {
  return (
    <div class="hand-buttons" role="group" aria-label="Hand">
      <button type="button" aria-pressed={inverting.value} onClick={() => { inverting.value = !inverting.value; }}>Opposite</button>
      <button type="button" aria-pressed={smoothing.value} onClick={() => { smoothing.value = !smoothing.value; }}>Smooth</button>
    </div>
  );
}

export function BrushBar() {
  const named = (name: string) => brush_members.value.find((member) => member.name === name);
  const [radius, strength] = [named("radius"), named("strength")];
  if (!radius || !strength) return null;
  return (
    <div class="brush-bar" role="group" aria-label="Brush">
      <BrushSlider member={radius} keys="hold F, or [ and ]" /><BrushSlider member={strength} keys="hold Shift+F, or Shift+[ and Shift+]" />
      <HandButtons />
    </div>
  );
}
