// Artists' names for tools and settings. Names that are in no table come from the contract.
import type {Op} from "../api/types";

export const toolNames: Partial<Record<Op, string>> = {attract: "Pull", erase: "Restore", interpolate: "Keys", noise: "Tousle", unify: "Even out"};

/** One line on what each tool does. */
export const toolWords: Partial<Record<Op, string>> = {
  comb: "Combs fur in the direction of your drag.",
  blow: "Blows fur away from you, like a hair dryer.",
  attract: "Pulls fur towards the point where you let go, and stretches it.",
  interpolate: "Lays fur along short lines that you draw, and blends it between them.",
  flow: "Lays fur along lines that you draw on the body.",
  smooth: "Blends fur with the fur around it.",
  noise: "Tousles fur. Ctrl reverses it.",
  unify: "Makes all fur under the brush the same.",
  part: "Draws a parting. Ctrl closes it.",
  whorl: "Turns fur around a point, as in a cowlick.",
  length: "Makes fur longer or shorter.",
  trim: "Cuts fur at a height above the skin.",
  lift: "Raises fur. Ctrl lays it down.",
  erase: "Restores the first groom, or that of a checkpoint.",
  clump: "Gathers fur in tufts. Ctrl spreads them.",
  curl: "Curls fur. Ctrl straightens it.",
  paint: "Paints colour, density and other properties. Ctrl restores their defaults.",
};

/** How to use a tool, if its line above does not say so. */
export const handWords: Partial<Record<Op, string>> = {
  blow: "Drag over the fur: the wind blows away from the view.",
  attract: "Press on the fur, drag away and let go.",
  part: "Drag along the line of the parting.",
  whorl: "Press at the centre of the whorl, or draw a line.",
};

/** Settings that are always visible; the others are in a collapsed group. */
export const firstMembers: Partial<Record<Op, string[]>> = {
  comb: ["lean"], blow: ["lean"], attract: ["max_stretch"], interpolate: ["reach"], flow: ["reach"], smooth: ["passes"], noise: ["amount"],
  unify: ["weight"], whorl: ["turn_degrees"], length: ["mode", "value"], trim: ["height"], erase: ["checkpoint"], clump: ["gather"], curl: ["amount"],
  paint: ["field", "colour", "value"],
};

export const memberNames: Record<string, string> = {
  sigma: "Blend width", t: "Amount per pass", keep_inclination: "Keep the lean", inclination: "Lean", lean: "Lean",
  feature_size: "Grain size", max_stretch: "Maximum stretch", mean: "Even out", weight: "Amount", passes: "Passes", falloff_shape: "Brush shape", falloff: "Falloff",
  front_faces_only: "Front faces only", cut_off_degrees: "Largest angle to the view", pressure_to_radius: "Pen sets radius", pressure_to_strength: "Pen sets strength",
  strand_from: "Along strands, from", strand_to: "Along strands, to", crease_degrees: "Sharp edges from", two_sided: "Two-sided parts",
  fur_patches: "Fur layout", harmonics: "Light from all around", longitudinal_roughness: "Roughness along", azimuthal_roughness: "Roughness around",
  refractive_index: "Refractive index", eumelanin: "Brown-black pigment", pheomelanin: "Red-blond pigment", caustic_width: "Width of glints",
  primary_shift: "Shift of the first highlight", secondary_shift: "Shift of the second highlight", angle_degrees: "Angular size",
};

/** Names of AOVs whose names mean something else where a setting has them. */
export const aovWords: Record<string, string> = {shadow: "Unshadowed share"};

/** Names of choices. */
export const choiceNames: Record<string, string> = {
  straight: "In a straight line", dijkstra: "Along the skin", heat: "Along the skin, smooth", volume: "Ball", surface: "Disc on the skin", screen: "Circle on the screen",
  lengyel: "First fur shells", scale: "Scale", jitter: "Random", direct: "Direct light", root: "Root position", strand: "Strand number", sample_count: "Samples", bare: "Bare skin", tip_colour: "Colour of the tips", root_colour: "Colour of the roots",
};
