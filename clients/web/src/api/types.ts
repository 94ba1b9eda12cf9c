// Short names for the contract's types, which are generated from openapi.json.
import type {components} from "contract";

type Schemas = components["schemas"];

export type Scene = Schemas["Scene"];
export type SceneList = Schemas["SceneList"];
export type LogEntry = Schemas["LogEntry"];
export type CommandAnswer = Schemas["CommandAnswer"];
export type Problem = Schemas["Problem"];
export type EditLayer = Schemas["EditLayer"];
export type Knobs = Schemas["Knobs"];
export type Tier = Schemas["Tier"];
export type FrameRequest = Partial<Schemas["FrameRequest"]>;
export type FrameEstimate = Schemas["FrameEstimate"];
export type FrameCounters = Schemas["FrameCounters"];
export type TraceReport = Schemas["TraceReport"];
export type Pick = Schemas["Pick"];
export type TurnModel = Schemas["TurnModel"];
export type RecipeRequest = Schemas["RecipeRequest"];
export type RecipeStep = Schemas["RecipeStep"];
export type Comparison = Schemas["Comparison"];
export type Field = Schemas["Field"];
export type ChangeEvent = Schemas["ChangeEvent"];
export type SceneEvent = Schemas["SceneEvent"];
export type Settings = Schemas["Settings"];
export type Coat = Schemas["Coat"];
export type Symmetry = Partial<Schemas["Symmetry"]> & {planes: Partial<Schemas["Plane"]>[]};
export type Bounds = Schemas["Bounds"];
export type Repair = Schemas["Repair"];
export type NewScene = Schemas["NewScene"];
export type ModelFormat = Schemas["ImportOptions"]["format"];
export type Tracing = Schemas["Tracing"];
export type AutoView = Schemas["AutoView"];
export type Op = Schemas["Command"]["op"];

export type Vector = [number, number, number];
/** A pinhole camera in the model's coordinates; fov_degrees is vertical. */
export interface Pinhole { position: Vector; target: Vector; up: Vector; fov_degrees: number }
/** A command: `op` and the members of its schema. Only the server checks the members. */
export type Command = {op: Op} & Record<string, unknown>;
