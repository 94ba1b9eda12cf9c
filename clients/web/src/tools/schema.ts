// Reads the contract's schemas for forms: members with their kinds, ranges, units and defaults.
import {signal} from "@preact/signals";
import {call} from "../api/client";
import {choiceNames, memberNames} from "./artist_words";

/** The allowed range of a number. */
export interface Range { minimum?: number; maximum?: number; exclusiveMinimum?: number }
export interface Schema extends Range {
  $ref?: string; type?: string | string[]; const?: unknown; enum?: unknown[]; default?: unknown; description?: string;
  "x-unit"?: string; minItems?: number; maxItems?: number; maxLength?: number;
  properties?: Record<string, Schema | boolean>; required?: string[]; items?: Schema;
  oneOf?: Schema[]; anyOf?: Schema[]; allOf?: Schema[]; not?: Schema; if?: Schema; then?: Schema; else?: Schema;
  discriminator?: {mapping: Record<string, string>};
}
export type Kind = "number" | "integer" | "boolean" | "choice" | "choices" | "colour" | "vector" | "text" | "object" | "list" | "number_or_word" | "other";
export interface Member { name: string; kind: Kind; schema: Schema; description: string; fallback: unknown; required: boolean }

/** Schemas by name; empty until the contract is loaded. */
export const schemas = signal<Record<string, Schema>>({});

export async function loadContract() {
  const contract = await (await call("/openapi.json")).json() as {components: {schemas: Record<string, Schema>}};
  schemas.value = contract.components.schemas;
}

const nameOf = (ref: string) => ref.slice(ref.lastIndexOf("/") + 1);

/** Returns the schema with its $ref resolved; members beside the $ref take precedence. */
export function resolved(schema: Schema): Schema {
  if (!schema.$ref) return schema;
  const {$ref, ...beside} = schema;
  return {...resolved(schemas.value[nameOf($ref)] ?? {}), ...beside};
}

const vector_names = ["Position", "Direction"];

export function kindOf(schema: Schema): Kind {
  if (schema.$ref && nameOf(schema.$ref) === "Colour") return "colour";
  if (schema.$ref && vector_names.includes(nameOf(schema.$ref))) return "vector";
  const full = resolved(schema);
  if (full.enum) return "choice";
  if (full.oneOf?.length === 2 && full.oneOf[0]!.type === "number" && typeof full.oneOf[1]!.const === "string") return "number_or_word";
  if (full.type === "array") {
    if (full.items && resolved(full.items).enum) return "choices";
    return full.items && ["object", "array"].includes(String(resolved(full.items).type)) ? "list" : "other";
  }
  if (full.type === "string") return "text";
  if (full.properties) return "object";
  return full.type === "number" || full.type === "integer" || full.type === "boolean" ? full.type : "other";
}

export function membersOf(schema: Schema, without: string[] = []): Member[] {
  const full = resolved(schema);
  return Object.entries(full.properties ?? {}).flatMap(([name, member]) => {
    if (typeof member === "boolean" || without.includes(name)) return [];
    const inner = resolved(member);
    return [{name, kind: kindOf(member), schema: inner, description: inner.description ?? "", fallback: inner.default,
             required: full.required?.includes(name) ?? false}];
  });
}

const is_object = (value: unknown): value is Record<string, unknown> => typeof value === "object" && value !== null && !Array.isArray(value);

/** Returns true if the value satisfies the rule. Supports the JSON Schema keywords that the contract's rules use. */
export function matches(rule: Schema | boolean, value: unknown): boolean {
  if (typeof rule === "boolean") return rule;
  if ("const" in rule && rule.const !== value) return false;
  if (rule.enum && !rule.enum.includes(value)) return false;
  if (rule.not && matches(rule.not, value)) return false;
  if (rule.anyOf && !rule.anyOf.some((one) => matches(one, value))) return false;
  if (!is_object(value)) return true;
  if (rule.required?.some((name) => value[name] === undefined)) return false;
  return Object.entries(rule.properties ?? {}).every(([name, member]) => value[name] === undefined || matches(member, value[name]));
}

/** Returns the members that the rules forbid, given the others, such as `colour` if the painted field is no colour. */
export function forbidden(schema: Schema, value: Record<string, unknown>): Set<string> {
  const full = resolved(schema);
  const names = new Set<string>();
  for (const rule of [full, ...(full.allOf ?? [])]) {
    if (!rule.if) continue;
    const chosen = matches(rule.if, value) ? rule.then : rule.else;
    for (const [name, member] of Object.entries(chosen?.properties ?? {})) if (member === false) names.add(name);
  }
  return names;
}

/** Returns the members of which exactly one must be set, such as ["plane", "sphere", "height"]; most schemas have none. */
export function alternatives(schema: Schema): string[] {
  const rule = resolved(schema).allOf?.find((one) => one.oneOf?.every((choice) => choice.required?.length === 1));
  return rule?.oneOf?.map((choice) => choice.required![0]!) ?? [];
}

/** Returns the artists' name for a member or choice; else, for "max_stretch", "Max stretch". */
export function words(name: string): string {
  const said = memberNames[name] ?? choiceNames[name];
  if (said) return said;
  const text = name.replaceAll("_", " ").replace(/ degrees$/, "");
  return text.charAt(0).toUpperCase() + text.slice(1);
}

const unit_signs: Record<string, string> = {degrees: "°", sizes: "× size", seconds: "s", milliseconds: "ms", pixels: "px", stops: "stops"};
const size_units: Record<string, string> = {world: "units", pixels: "px"};

/** Returns the unit to show after a number. */
export function unitOf(member: Member, units: unknown): string {
  const unit = member.schema["x-unit"] ?? "";
  return unit === "as `units`" ? size_units[String(units)] ?? "× size" : unit_signs[unit] ?? "";
}

/** Removes the backticks from the contract's text. */
export const plain = (text: string) => text.replaceAll("`", "");
