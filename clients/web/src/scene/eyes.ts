// Eyes of the scene: pairs move, grow and turn together.
import type {Settings, Symmetry, Vector} from "../api/types";
import {kept} from "../api/identity";
import {hand_symmetry, middle_plane} from "../tools/state";
import {dot, norm, subtract} from "../view/vector";
import {planesOf, reflected, reflectedDirection} from "../view/mirror";
import {scene} from "./session";

export type Eye = Settings["eyes"][number];

/** Whether a change of one eye is a change of all. */
export const alike = kept("eyes-alike", true);
/** Radii of the ball that lie under the skin. */
export const sunk = 0.35;
const near = 0.03;  // sizes: eyes that are a mirror image of each other up to this are a pair

/** What pairs are mirrored by: the hand's first plane, or the one through the middle of the model. */
export const pairSymmetry = (): Symmetry => ({planes: [hand_symmetry.value.planes[0] ?? middle_plane.value]});
const plane = () => planesOf(pairSymmetry())[0]!;

/** The other eye of a pair; -1 where there is none. */
export function partnerOf(all: readonly Eye[], index: number): number {
  const size = scene.value?.size ?? 1, image = reflected(all[index]!.position as Vector, plane());
  return all.findIndex((eye, k) => k !== index && norm(subtract(eye.position as Vector, image)) < near * size);
}

/** All eyes once one has a part of its own changed: the other one of its pair follows in the mirror. */
export function movedEye(all: readonly Eye[], index: number, change: Partial<Eye>): Eye[] {
  const partner = partnerOf(all, index);
  const image = {...change};
  if (change.position) image.position = reflected(change.position as Vector, plane());
  if (change.gaze) image.gaze = reflectedDirection(change.gaze as Vector, plane());
  return all.map((eye, k) => (k === index ? {...eye, ...change} : k === partner ? {...eye, ...image} : eye) as Eye);
}

/** Whether a place lies on the plane, so that an eye there has no partner. */
export const inTheMiddle = (point: Vector, radius: number) => Math.abs(dot(subtract(point, plane().point), plane().normal)) < radius;
