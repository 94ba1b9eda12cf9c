// The tools, read from the contract: each command that takes a stroke is a tool.
import {computed} from "@preact/signals";
import type {Op} from "../api/types";
import {toolNames, toolWords} from "./artist_words";
import {alternatives, membersOf, plain, resolved, schemas, words, type Member} from "./schema";

export interface Tool {
  op: Op;
  name: string;
  /** One line on what it does. */
  says: string;
  members: Member[];
  /** Members of which exactly one must be set. */
  alternatives: string[];
  floods: boolean;
}

const not_for_forms = ["op", "stroke", "brush", "flood", "edit_layer", "coats"];
/** Members that are set by the pointer on the model, not in the form. */
const by_hand: Partial<Record<Op, string[]>> = {
  blow: ["source", "direction", "blower"], attract: ["point", "attractor"], flow: ["curves"], interpolate: ["keys"], erase: ["revision"],
};

/** Returns the first sentence of a description; the rest is for authors of commands. */
const firstSentence = (text: string) => `${plain(text).split(/[;.](?:\s|$)/)[0]!}.`;

/** All tools, in the contract's order. */
export const tools = computed<Tool[]>(() => {
  const mapping = schemas.value["Command"]?.discriminator?.mapping ?? {};
  return Object.entries(mapping).flatMap(([op, ref]) => {
    const schema = resolved({$ref: ref});
    if (!schema.properties?.["stroke"]) return [];
    const without = [...not_for_forms, ...(by_hand[op as Op] ?? [])];
    return [{op: op as Op, name: toolNames[op as Op] ?? words(op), says: toolWords[op as Op] ?? firstSentence(schema.description ?? ""), members: membersOf(schema, without),
             alternatives: alternatives(schema), floods: "flood" in schema.properties}];
  });
});

export const brush_members = computed<Member[]>(() => membersOf(schemas.value["Brush"] ?? {}, ["falloff_points", "invert", "symmetry"]));
/** Returns true if a tool has its own member `strength`; it takes the brush's value, so that there is one slider. */
export const ownStrength = (tool: Tool | undefined) => tool?.members.some(({name}) => name === "strength") ?? false;
export const toolOf = (op: Op) => tools.value.find((tool) => tool.op === op);
export const schemaOf = (op: Op) => {
  const ref = schemas.value["Command"]?.discriminator?.mapping[op];
  return ref ? resolved({$ref: ref}) : {};
};
