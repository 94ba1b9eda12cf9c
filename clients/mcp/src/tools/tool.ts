// The Tool interface, and helpers that all tools share.
import type {CallToolResult, ToolAnnotations} from "@modelcontextprotocol/sdk/types.js";
import type {components} from "contract";
import type {Cameras} from "../cameras";
import type {InputSchema, Schema, Schemas} from "../contract";
import {nearestOf} from "../nearest";
import {Refusal} from "../refusal";
import type {Caller, Service} from "../service";

export type Answers = components["schemas"];
export type Input = Record<string, unknown>;
/** What tools work with: the server, its contract's schemas, and the named cameras. */
export interface Context { service: Service; schemas: Schemas; cameras: Cameras }

export interface Tool {
  name: string;
  description: string;
  inputSchema: InputSchema;
  annotations: ToolAnnotations;
  run(input: Input, caller: Caller): Promise<CallToolResult>;
}

export const reads: ToolAnnotations = {readOnlyHint: true, openWorldHint: false};
/** For tools that change a scene; not destructive, since every change can be undone. */
export const changes: ToolAnnotations = {readOnlyHint: false, destructiveHint: false, openWorldHint: false};
export const destroys: ToolAnnotations = {readOnlyHint: false, destructiveHint: true, openWorldHint: false};

export const scene_member: Schema = {type: "string", description: "Id or name of the scene."};
/** A short schema of a camera; the contract's full schema in each tool would fill an agent's context. */
export const camera_member = ({cameras}: Context): Schema => ({
  type: ["string", "object"], default: "three_quarter",
  description: `A name: ${cameras.names().join(", ")}, or one from name_camera. Or {"position": [x, y, z], "target": [x, y, z], "up": [0, 1, 0], "fov_degrees": 35}.`,
});
export const dry_run_member: Schema = {type: "boolean", default: false, description: "Say what would change; change nothing."};

/** Builds a tool's result from text for the agent and the same content as data. */
export const result = (text: string, structuredContent: object): CallToolResult =>
  ({content: [{type: "text", text}], structuredContent: structuredContent as Record<string, unknown>});

export function textIn(input: Input, name: string): string {
  const value = input[name];
  if (typeof value === "string" && value !== "") return value;
  throw new Refusal({detail: value === undefined ? `"${name}" is missing.` : `"${name}" is not text.`, pointer: `/${name}`, limit: "text of 1 or more characters"});
}

export function arrayIn(input: Input, name: string): unknown[] {
  const value = input[name];
  if (Array.isArray(value)) return value;
  throw new Refusal({detail: value === undefined ? `"${name}" is missing.` : `"${name}" is not a list.`, pointer: `/${name}`, limit: "a list"});
}

export function integerIn(input: Input, name: string, fallback: number, min: number, max: number): number {
  const value = input[name] ?? fallback;
  if (typeof value === "number" && Number.isInteger(value) && value >= min && value <= max) return value;
  throw new Refusal({detail: `${JSON.stringify(value)} is out of range.`, pointer: `/${name}`, limit: `a whole number in [${min}, ${max}]`});
}

export const pathMember = (more = ""): Schema => ({type: "string", description: `Path of the file on the machine where pelage-mcp runs.${more}`});

export const queryOf = (members: Input) => new URLSearchParams(Object.entries(members).map(([name, value]): [string, string] => [name, String(value)])).toString();

/** Returns `input` without these members. */
export const without = (input: Input, ...names: string[]): Input =>
  Object.fromEntries(Object.entries(input).filter(([name]) => !names.includes(name)));

/** Returns the URL path of the scene that an agent gives by id or name. */
export async function scenePath(service: Service, wanted: string, caller: Caller): Promise<string> {
  return pathOf(await findScene(service, wanted, caller));
}

export const pathOf = ({id}: {id: string}) => `/v1/scenes/${id}`;

/** Finds a scene by id or unique name. `pointer` is the JSON pointer of the input that names it. */
export async function findScene(service: Service, wanted: string, caller: Caller, pointer = "/scene"): Promise<Answers["Scene"]> {
  const {scenes} = await service.get<Answers["SceneList"]>("/v1/scenes", caller);
  const named = scenes.filter(({id}) => id === wanted).concat(scenes.filter(({name}) => name === wanted));
  if (named[0] && (named.length === 1 || named[0].id === wanted)) return named[0];
  const detail = named.length > 1 ? `${named.length} scenes are named "${wanted}"; use an id.` : `There is no scene "${wanted}".`;
  const known = scenes.map(({id, name}) => `${name} (${id})`).join(", ");
  const nearest = nearestOf(wanted, scenes.map(({name}) => name));
  throw new Refusal({status: 404, detail, pointer, ...(nearest === undefined ? {} : {nearest}), limit: known ? `one of ${known}` : "there are no scenes; `create_scene` makes one"});
}
