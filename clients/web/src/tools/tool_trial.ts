// Tries a tool on a temporary copy of the scene and draws it before and after.
import {signal} from "@preact/signals";
import * as api from "../api/client";
import {page_id} from "../api/identity";
import type {Command, FrameRequest, Op, Pinhole, Vector} from "../api/types";
import {trialName} from "../scene/scratch";
import {scene} from "../scene/session";
import {framed, pinholeOf, zoomed} from "../view/camera";
import {add, scale, subtract, unit} from "../view/vector";

/** Object URLs of two pictures. */
export interface Pair { before: string; after: string }
/** Pairs by scene id and command. */
export const pairs = signal<ReadonlyMap<string, Pair>>(new Map());

const size = {width: 144, height: 120};
const max_pairs = 40;
/** Pixels of the stroke's samples; the stroke goes against the fur of most animals. */
const path = [0.8, 0.65, 0.5, 0.35, 0.2].map((x) => [x * size.width, (0.4 + 0.2 * x) * size.height] as const);
const brush = {radius: 0.07, strength: 1};
const distance_factor = 0.36;  // factor on the camera's distance at which the whole animal is visible
/** Tools that have no visible effect on tidy fur, so that the fur is tousled first. */
const needs_tousling: Op[] = ["smooth", "unify", "erase"];

let serial = 0;
const copies = new Set<string>();  // ids of copies that are not removed yet

interface TrialView { camera: Pinhole; width: number; height: number }

/** Returns a view close to the flank, or to whatever is in the middle of the picture. */
async function viewOf(id: string): Promise<TrialView> {
  const full_view = framed(scene.value!, "three_quarter", size.width / size.height);
  const middle = await api.pick(id, {view: {camera: pinholeOf(full_view), ...size}, pixel: [0.55 * size.width, 0.55 * size.height], reach: "skin"});
  const target = middle.hit ? middle.position as Vector : full_view.target;
  return {camera: pinholeOf({...zoomed(full_view, distance_factor, scene.value!.size), target, yaw: full_view.yaw + 0.4}), ...size};
}

/** Returns the points of the path that lie on the skin. */
async function positionsOf(id: string, view: TrialView): Promise<Vector[]> {
  const picks = await Promise.all(path.map((pixel) => api.pick(id, {view, pixel, reach: "skin"})));
  return picks.flatMap((pick) => (pick.hit ? [pick.position as Vector] : []));
}

/** Returns the command with a stroke along the path, as pointer input would make it. */
function strokeOf(op: Op, command: Command, view: TrialView, points: Vector[]): Command {
  const first = points[0]!, last = points[points.length - 1]!, model_size = scene.value!.size;
  if (op === "flow") return {...command, curves: [points]};
  if (op === "interpolate") return {...command, keys: [{position: first, direction: subtract(last, first)}]};
  const out = unit(subtract(view.camera.position as Vector, first));
  const middle = points[Math.floor(points.length / 2)]!;
  if (op === "attract") return {...command, point: add(middle, scale(out, 0.12 * model_size)), radius: 0.25 * model_size, units: "world"};
  const stroke = {view, samples: path.map((screen, k) => ({screen, time: 0.05 * k}))};
  const wind = op === "blow" ? {source: add(middle, scale(out, 0.4 * model_size)), direction: subtract(middle, add(middle, out))} : {};
  return {...command, ...wind, brush, stroke};
}

async function draw(id: string, view: TrialView, signal: AbortSignal): Promise<string> {
  const request: FrameRequest = {...size, width: 2 * size.width, height: 2 * size.height, camera: view.camera, format: "jpeg", view: `${page_id}-tool`};
  const picture = await api.drawFrame(id, request, null, signal);
  return URL.createObjectURL(picture!.bytes);
}

function store(key: string, pair: Pair) {
  const next = new Map(pairs.value).set(key, pair);
  for (const [oldest, {before, after}] of next) {
    if (next.size <= max_pairs) break;
    next.delete(oldest);
    [before, after].forEach((address) => URL.revokeObjectURL(address));
  }
  pairs.value = next;
}

export async function drawPair(key: string, of: string, op: Op, command: Command, signal: AbortSignal) {
  const view = await viewOf(of);
  if (signal.aborted) return;
  const {id} = await api.branchScene(of, {name: trialName()});
  copies.add(id);
  try {
    const change = (body: Command) => api.change(id, "commands", body, `${page_id}-tool-${++serial}`);
    if (needs_tousling.includes(op)) await change({op: "noise", flood: true, amount: 0.9, feature_size: 0.06, fields: ["direction", "length"]});
    const positions = await positionsOf(id, view);
    if (positions.length < 2 || signal.aborted) return;
    const before = await draw(id, view, signal);
    await change(strokeOf(op, command, view, positions));
    store(key, {before, after: await draw(id, view, signal)});
  } finally {
    copies.delete(id);
    await api.removeScene(id);
  }
}

/** Removes the copies without waiting when the page is closed. */
addEventListener("pagehide", () => copies.forEach((id) => void api.removeScene(id).catch(() => undefined)));
