// The scene's eyes. The two eyes of a pair move, grow and turn together.
import type {Settings, Symmetry, Vector} from "../api/types";
import {storedSignal} from "../api/identity";
import {hand_symmetry, middle_plane} from "../tools/state";
import {dot, norm, subtract} from "../view/vector";
import {planesOf, reflected, reflectedDirection} from "../view/mirror";
import {scene} from "./session";

export type Eye = Settings["eyes"][number];

/** True if a change of one eye applies to all. */
export const edit_all_eyes = storedSignal("eyes-alike", true);
/** Depth of an eye's centre below the skin, in radii of the eye. */
export const sunk_share = 0.35;
const pair_distance = 0.03;  // sizes; two eyes are a pair if one is nearer than this to the other's mirror image

/** Returns the mirror plane of pairs: the first symmetry plane of strokes, else the one through the model's middle. */
export const pairSymmetry = (): Symmetry => ({planes: [hand_symmetry.value.planes[0] ?? middle_plane.value]});
const plane = () => planesOf(pairSymmetry())[0]!;

/** Returns the index of the other eye of a pair; -1 if there is none. */
export function partnerOf(all: readonly Eye[], index: number): number {
  const size = scene.value?.size ?? 1, image = reflected(all[index]!.position as Vector, plane());
  return all.findIndex((eye, k) => k !== index && norm(subtract(eye.position as Vector, image)) < pair_distance * size);
}

/** Returns the eyes after a change of one eye; the other eye of its pair gets the mirrored change. */
export function movedEye(all: readonly Eye[], index: number, change: Partial<Eye>): Eye[] {
  const partner = partnerOf(all, index);
  const image = {...change};
  if (change.position) image.position = reflected(change.position as Vector, plane());
  if (change.gaze) image.gaze = reflectedDirection(change.gaze as Vector, plane());
  return all.map((eye, k) => (k === index ? {...eye, ...change} : k === partner ? {...eye, ...image} : eye) as Eye);
}

/** Returns true if an eye of this radius at `point` intersects the mirror plane, so that it needs no partner. */
export const isOnMirrorPlane = (point: Vector, radius: number) => Math.abs(dot(subtract(point, plane().point), plane().normal)) < radius;
