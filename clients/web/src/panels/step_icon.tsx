// The icon beside a step: its tool's, or that of the panel that makes such settings.
import type {Op} from "../api/types";
import {commandsIn, type Step} from "../scene/steps";
import {toolOf} from "../tools/catalogue";
import {Icon, ToolIcon, type Sign} from "../tools/icons";

const signs: Partial<Record<Op, Sign>> = {
  mask: "mask", edit_layer: "layers", checkpoint: "flag", set_coat: "coat", set_look: "look", set_lights: "light", set_environment: "light",
  set_ground: "look", set_wind: "wind", set_symmetry: "mirror", set_eyes: "eye", map: "files", retarget: "people",
};

export function StepIcon({step, amended}: {step: Step; amended: boolean}) {
  if (amended) return <Icon sign="edit" />;
  if (step.kind === "revert") return <Icon sign="history" />;
  const op = commandsIn(step.entries[0]!)[0]?.op;
  if (op && toolOf(op)) return <ToolIcon op={op} />;
  return <Icon sign={(op && signs[op]) ?? "coat"} />;
}
