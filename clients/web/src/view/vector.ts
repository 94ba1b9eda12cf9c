// Functions for 3-D vectors, which are plain arrays.
import type {Vector} from "../api/types";

export const add = (a: Vector, b: Vector): Vector => [a[0] + b[0], a[1] + b[1], a[2] + b[2]];
export const subtract = (a: Vector, b: Vector): Vector => [a[0] - b[0], a[1] - b[1], a[2] - b[2]];
export const scale = (a: Vector, by: number): Vector => [a[0] * by, a[1] * by, a[2] * by];
export const dot = (a: Vector, b: Vector) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
export const cross = (a: Vector, b: Vector): Vector =>
  [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
export const norm = (a: Vector) => Math.hypot(a[0], a[1], a[2]);
export const mix = (a: Vector, b: Vector, t: number): Vector => add(scale(a, 1 - t), scale(b, t));
/** Normalizes a vector; returns +y for a zero or non-finite vector. */
export function unit(a: Vector): Vector {
  const length = norm(a);
  return length > 0 && Number.isFinite(length) ? scale(a, 1 / length) : [0, 1, 0];
}
/** Returns two vectors that form an orthonormal basis with `normal`. */
export function tangents(normal: Vector): [Vector, Vector] {
  const helper: Vector = Math.abs(normal[1]) < 0.9 ? [0, 1, 0] : [1, 0, 0];
  const u = unit(cross(helper, normal));
  return [u, cross(normal, u)];
}
