// Artists' names for tools and settings. Names that are in no table come from the contract.
import type {Op} from "../api/types";

export const toolNames: Partial<Record<Op, string>> = {attract: "Pull", erase: "Restore", interpolate: "Keys", noise: "Tousle", unify: "Even out"};

/** One line on what each tool does. */
export const toolWords: Partial<Record<Op, string>> = {
  comb: "Turns fur the way you drag.",
  blow: "Blows fur away from you, as a dryer does.",
  attract: "Pulls fur to where you let go, and stretches it.",
  interpolate: "Lays fur by short lines that you draw: between them it follows.",
  flow: "Lays fur along lines that you draw on the body.",
  smooth: "Makes fur agree with the fur beside it.",
  noise: "Tousles fur; with Ctrl it takes that off.",
  unify: "Makes fur under the brush alike.",
  part: "Draws a parting; with Ctrl fur closes over the line.",
  whorl: "Turns fur round a point: a cowlick.",
  length: "Makes fur longer or shorter.",
  trim: "Cuts fur to a height.",
  lift: "Raises fur; with Ctrl it lays it down.",
  erase: "Brings back the fur that was there at first, or at a checkpoint.",
  clump: "Gathers fur in tufts; with Ctrl it opens them.",
  curl: "Curls fur; with Ctrl it takes the curl out.",
  paint: "Paints colour, density and other things; with Ctrl it takes them off.",
};

/** How to use a tool, if its line above does not say so. */
export const handWords: Partial<Record<Op, string>> = {
  blow: "Drag over the fur: the wind comes from where you look.",
  attract: "Press on the fur, drag away and let go.",
  part: "Drag along the line of the parting.",
  whorl: "Drag where the fur is to turn.",
};

/** Settings that are always visible; the others are in a collapsed group. */
export const firstMembers: Partial<Record<Op, string[]>> = {
  comb: ["lean"], blow: ["lean"], attract: ["max_stretch"], interpolate: ["reach"], flow: ["reach"], smooth: ["passes"], noise: ["amount"],
  unify: ["weight"], whorl: ["turn_degrees"], length: ["mode", "value"], trim: ["height"], erase: ["checkpoint"], clump: ["gather"], curl: ["amount"],
  paint: ["field", "colour", "value"],
};

export const memberNames: Record<string, string> = {
  sigma: "How softly they blend", t: "Each pass", keep_inclination: "Keep how far it lies", inclination: "How far it lies", lean: "How far it lies",
  feature_size: "Grain", max_stretch: "Stretches up to", mean: "Alike in", weight: "How alike", passes: "How smooth", falloff_shape: "Form of the brush", falloff: "Edge",
  front_faces_only: "Only what faces you", cut_off_degrees: "Faces you within", pressure_to_radius: "Pen sets radius", pressure_to_strength: "Pen sets strength",
  strand_from: "Along strands, from", strand_to: "Along strands, to", crease_degrees: "Sharp edges from", two_sided: "Parts with a back",
  fur_patches: "How fur is laid", harmonics: "Light from all around", longitudinal_roughness: "Roughness along", azimuthal_roughness: "Roughness around",
  refractive_index: "Refraction", eumelanin: "Brown and black", pheomelanin: "Red and blond", caustic_width: "Width of glints",
  primary_shift: "Shift of the first highlight", secondary_shift: "Shift of the second highlight", angle_degrees: "Size in the sky",
};

/** Names of choices. */
export const choiceNames: Record<string, string> = {
  straight: "Through the air", dijkstra: "Along the skin", heat: "Along the skin, evenly", volume: "Ball", surface: "On the skin", screen: "As seen",
  lengyel: "First fur shells", scale: "Times", jitter: "Uneven", bare: "Skin without fur", tip_colour: "Colour of the tips", root_colour: "Colour of the roots",
};
