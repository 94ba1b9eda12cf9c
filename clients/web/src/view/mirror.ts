// Mirror images of a point under the symmetry of strokes.
import type {Symmetry, Vector} from "../api/types";
import {add, dot, scale, subtract, unit} from "./vector";
import type {Hit, Proxy} from "./proxy";

export interface Plane { point: Vector; normal: Vector }

export function reflected(point: Vector, plane: Plane): Vector {
  const normal = unit(plane.normal);
  return subtract(point, scale(normal, 2 * dot(subtract(point, plane.point), normal)));
}

/** Mirrors a direction, which does not depend on the plane's position. */
export const reflectedDirection = (direction: Vector, {normal}: Plane): Vector => reflected(direction, {point: [0, 0, 0], normal});

export const planesOf = (symmetry: Symmetry): Plane[] =>
  symmetry.planes.map((plane) => ({point: (plane.point ?? [0, 0, 0]) as Vector, normal: (plane.normal ?? [1, 0, 0]) as Vector}));

/** Returns the image under each mirror plane. Combinations of planes and rotations are left to the server. */
export const imagesOf = (hit: Hit, symmetry: Symmetry): Hit[] =>
  planesOf(symmetry).map((plane) => {
    const point = reflected(hit.point, plane);
    return {point, normal: unit(subtract(reflected(add(hit.point, hit.normal), plane), point)), distance: hit.distance};
  });

/** Returns the images that lie on the skin, moved onto it. */
export function imagesOnSkin(hit: Hit, symmetry: Symmetry, proxy: Proxy): Hit[] {
  return imagesOf(hit, symmetry).flatMap(({point, normal}) => {
    const lift = hit.distance * 0.05;
    const found = proxy.cast(add(point, scale(normal, lift)), scale(normal, -1));
    return found && found.distance < 2 * lift ? [found] : [];
  });
}
