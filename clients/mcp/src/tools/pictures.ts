// Tools for pictures: one frame, a montage of numbered views, and a pick of what lies under a pixel.
import type {CallToolResult} from "@modelcontextprotocol/sdk/types.js";
import type {Schema} from "../contract";
import {montage} from "../montage";
import {Refusal} from "../refusal";
import type {Caller, Service} from "../service";
import {arrayIn, camera_member, integerIn, reads, result, scene_member, scenePath, textIn, without, type Answers, type Context, type Input, type Tool} from "./tool";

/** Members of FrameRequest that are common to all views of a montage, and those that each view sets. */
const shared_members = ["budget_ms", "max_error", "max_seconds", "background", "exposure", "tone_map"];
const view_members = ["overlay", "overlay_from", "revision"];
/** Maximum size of a picture in bytes; many MCP clients reject larger ones. */
const max_bytes = 1_000_000;
const quality_rule = "Give at most one of quality, budget_ms and max_error.";

export const pictureTools = (context: Context): Tool[] => [look(context), views(context), pick(context)];

function withImage({bytes, type: mimeType}: Pick<Frame, "bytes" | "type">, {width, height}: Size, text: string, data: object): CallToolResult {
  const size_line = `Picture: ${width} x ${height}, ${mimeType}, ${Math.ceil(bytes.length / 1000)} kB.`;
  const {content, structuredContent} = result(`${text}\n${size_line}`, {...data, picture: {width, height, type: mimeType, bytes: bytes.length}});
  return {content: [{type: "image", data: Buffer.from(bytes).toString("base64"), mimeType}, ...content], structuredContent};
}

interface Size { width: number; height: number }
interface Frame { bytes: Uint8Array; type: string; revision: number; quality: unknown; estimate: {error?: number} | null }

async function draw(service: Service, path: string, request: object, caller: Caller): Promise<Frame> {
  const answer = await service.send("POST", `${path}/frames`, {json: request}, caller);
  const header = (name: string) => JSON.parse(answer.headers.get(name) ?? "null") as unknown;
  return {
    bytes: new Uint8Array(await answer.arrayBuffer()), type: answer.headers.get("Content-Type") ?? "image/png",
    revision: Number(answer.headers.get("Pelage-Revision")), quality: header("Pelage-Quality"), estimate: header("Pelage-Error") as Frame["estimate"],
  };
}

/** Draws a frame in the requested format; if it exceeds `max_bytes`, as JPEG of lower and lower quality. */
async function drawSmall(service: Service, path: string, request: object, caller: Caller): Promise<Frame> {
  const formats = [{}, {format: "jpeg", lossy_quality: 88}, {format: "jpeg", lossy_quality: 60}];
  let frame: Frame | undefined;
  for (const format of formats) {
    frame = await draw(service, path, {...request, ...format}, caller);
    if (frame.bytes.length <= max_bytes) return frame;
  }
  throw new Refusal({status: 413, detail: `The picture has ${frame!.bytes.length} bytes.`, pointer: "/width", limit: `at most ${max_bytes} bytes: fewer pixels`});
}

function look(context: Context): Tool {
  const {service, schemas} = context;
  const {width, height, quality, ...members} = schemas.members("FrameRequest", ["width", "height", "quality", "lossy_quality", ...shared_members, ...view_members]);
  const format = {enum: ["png", "jpeg"], default: "png", description: `A picture above ${max_bytes / 1e6} MB comes as JPEG.`};
  const knobs = {type: "object", description: 'Knobs, such as {"method": "strands", "trace": {"passes": 8}}.'};
  const qualities = {...quality, oneOf: [schemas.named("Tier"), knobs]};
  return {
    name: "look", annotations: reads,
    description: `Draws the scene and returns the picture. ${quality_rule} overlay_from is for the overlay difference only.`,
    inputSchema: schemas.input({scene: scene_member, camera: camera_member(context), width: width!, height: height!, quality: qualities, format, ...members}, ["scene"]),
    run: async (input, caller) => {
      const {format: asked = "png"} = input;
      if (asked !== "png" && asked !== "jpeg") throw new Refusal({detail: `The format ${JSON.stringify(asked)} is not offered here.`, pointer: "/format", limit: "png | jpeg"});
      const request = without(input, "scene");
      const {bytes, type, ...frame} = await drawSmall(service, await scenePath(service, textIn(input, "scene"), caller), request, caller);
      const size = {width: Number(request["width"] ?? width!["default"]), height: Number(request["height"] ?? height!["default"])};
      const error = frame.estimate?.error === undefined ? "" : `, estimated error ${frame.estimate.error.toPrecision(2)} of 1`;
      const text = `Revision ${frame.revision}${error}. To work on what a pixel shows, call \`pick\` with its x and y and this camera, width and height as \`view\`.`;
      return withImage({bytes, type}, size, text, {...frame, request});
    },
  };
}

const all_sides = ["three_quarter", "front", "left", "right", "back", "top"].map((auto) => ({camera: {auto}}));
const max_views = 16;
const max_side = 1024;
const default_side = 256;

function views(context: Context): Tool {
  const {service, schemas} = context;
  const side: Schema = {type: "integer", minimum: 16, maximum: max_side, default: default_side, description: "Pixels of each view."};
  const view = {type: "object", properties: {camera: camera_member(context), ...schemas.members("FrameRequest", view_members)}, additionalProperties: false};
  const list = {type: "array", items: view, minItems: 1, maxItems: max_views, default: all_sides,
    description: "Camera, revision and overlay of each. Two revisions from one camera show before and after."};
  return {
    name: "views", annotations: reads,
    description: `Draws several views in one picture, numbered in the corner; all sides unless \`views\` lists others. ${quality_rule}`,
    inputSchema: schemas.input({scene: scene_member, views: list, width: side, height: side, quality: {...schemas.named("Tier"), default: "interactive"}, ...schemas.members("FrameRequest", shared_members)}, ["scene"]),
    run: async (input, caller) => drawViews(service, await scenePath(service, textIn(input, "scene"), caller), input, caller),
  };
}

/** Draws a montage of `input.views`. `names` label the numbers in the text; without them the views are described. */
export async function drawViews(service: Service, path: string, input: Input, caller: Caller, names: string[] = []): Promise<CallToolResult> {
  const width = integerIn(input, "width", default_side, 16, max_side), height = integerIn(input, "height", default_side, 16, max_side);
  const wanted = input["views"] === undefined ? all_sides : arrayIn(input, "views");
  if (wanted.length < 1 || wanted.length > max_views)
    throw new Refusal({detail: `${wanted.length} views are asked for.`, pointer: "/views", limit: `1 to ${max_views}`});
  const shared = {...without(input, "scene", "views"), width, height};
  const frames: Frame[] = [];
  for (const [k, view] of wanted.entries()) {
    frames.push(await drawView(service, path, {shared, view, k}, caller));
    await caller.progress(k + 1, wanted.length);
  }
  const {png, size, corners} = montage(frames.map(({bytes}) => bytes), width, height);
  const fits = Math.sqrt(max_bytes / png.length) * 0.95;  // factor for a side; bytes grow with the pixels
  if (fits < 0.95) return drawViews(service, path, {...input, width: Math.floor(width * fits), height: Math.floor(height * fits)}, caller, names);
  const list = wanted.map((view, k) => ({number: k + 1, ...view as object, revision: frames[k]!.revision, width, height, ...corners[k]!}));
  const lines = wanted.map((view, k) => `${k + 1}: ${names[k] ?? viewInWords(view as Input)}, revision ${frames[k]!.revision}`);
  const hint = `Each view is ${width} x ${height} pixels. In \`pick\` and strokes give its camera, width and height as \`view\`, and count pixels from its upper left corner.`;
  return withImage({bytes: png, type: "image/png"}, size, [...lines, hint].join("\n"), {views: list});
}

async function drawView(service: Service, path: string, {shared, view, k}: {shared: object; view: unknown; k: number}, caller: Caller): Promise<Frame> {
  if (typeof view !== "object" || view === null || Array.isArray(view))
    throw new Refusal({detail: "A view is an object.", pointer: `/views/${k}`, limit: '{"camera": "front"}'});
  try {
    return await draw(service, path, {...shared, ...view, format: "png"}, caller);
  } catch (error) {
    const isOwn = (pointer: string) => (pointer.split("/")[1] ?? "") in view;
    throw error instanceof Refusal ? error.at((pointer) => isOwn(pointer) ? `/views/${k}${pointer}` : pointer) : error;
  }
}

function viewInWords({camera = {auto: "three_quarter"}, overlay}: Input): string {
  const {auto} = camera as {auto?: string};
  return `${auto ?? `camera ${JSON.stringify(camera)}`}${overlay === undefined ? "" : `, overlay ${String(overlay)}`}`;
}

export function nameCamera(context: Context): Tool {
  const name = {type: "string", minLength: 1, description: "The camera's name in this session."};
  return {
    name: "name_camera", annotations: reads,
    description: "Names a camera; `look`, `views`, `pick`, `preview_change` and the views of strokes then take the name as `camera`.",
    inputSchema: context.schemas.input({name, camera: camera_member(context)}, ["name", "camera"]),
    run: async (input) => {
      context.cameras.keep(textIn(input, "name"), input["camera"]);
      return result(`The cameras are ${context.cameras.names().join(", ")}.`, {cameras: context.cameras.names()});
    },
  };
}

function pick(context: Context): Tool {
  const {service, schemas} = context;
  const view = {type: "object", properties: {camera: camera_member(context), ...schemas.members("View", ["width", "height"])}, additionalProperties: false};
  const {pixel} = (schemas.named("PickRequest")["oneOf"] as {properties: Record<string, Schema>}[])[0]!.properties;
  return {
    name: "pick", annotations: reads,
    description: "Says what lies under a pixel of a view: position, normal and fur, and the position in each form that a stroke's samples take.",
    inputSchema: schemas.input({scene: scene_member, view, pixel: pixel!}, ["scene", "pixel"]),
    run: async (input, caller) => {
      const request = without(input, "scene");
      const picked = await service.post<Answers["Pick"]>(`${await scenePath(service, textIn(input, "scene"), caller)}/pick`, request, caller);
      const {strand} = picked;
      const seen = strand ? `The pixel shows strand ${strand.id} at ${strand.along.toPrecision(2)} of its length, whose root is at ${JSON.stringify(strand.root)}.` : "";
      if (!picked.hit) return result(seen || "The pixel shows the background. Pick one that shows the model.", picked);
      const samples = [{position: picked.position}, {triangle: picked.triangle, barycentric: picked.barycentric}, {screen: request["pixel"]}];
      const words = samples.map((sample) => JSON.stringify(sample));
      const text = [
        `Position ${JSON.stringify(picked.position)}.`,
        `Fur length ${picked.length.toPrecision(3)} sizes, inclination ${picked.inclination.toPrecision(3)}, leaning to ${JSON.stringify(picked.direction)}.`,
        `As a sample of a stroke: ${words[0]}, or ${words[1]}, or ${words[2]} with "view": ${JSON.stringify(request["view"] ?? {})} beside "samples".`,
        ...(seen ? [seen] : []),
      ].join("\n");
      return result(text, {...picked, samples, view: request["view"] ?? {}});
    },
  };
}
