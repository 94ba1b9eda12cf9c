// The user's camera, which orbits a target. It is not part of the scene.
import {signal} from "@preact/signals";
import type {AutoView, Pinhole, Scene, Vector} from "../api/types";
import {add, cross, dot, norm, scale, subtract, unit} from "./vector";

/** Yaw about +y from +z and pitch above the horizon, in radians; distance to the target in model units. */
export interface Orbit { target: Vector; yaw: number; pitch: number; distance: number }

export const fov_degrees = 35;
const max_pitch = Math.PI / 2 - 0.001;
const views: Record<AutoView, [number, number]> = {
  front: [0, 0], back: [Math.PI, 0], left: [Math.PI / 2, 0], right: [-Math.PI / 2, 0], top: [0, max_pitch],
  three_quarter: [0.6, 0.3],
};

export const orbit = signal<Orbit>({target: [0, 0, 0], yaw: 0.6, pitch: 0.3, distance: 3});

/** Returns an orbit that shows the whole model with a margin, for any aspect ratio. */
export function framed(scene: Scene, view: AutoView, aspect: number): Orbit {
  const {min, max} = scene.bounds as {min: Vector; max: Vector};
  const target = scale(add(min, max), 0.5);
  const half = Math.tan(((fov_degrees / 2) * Math.PI) / 180) * Math.min(1, aspect);
  const [yaw, pitch] = views[view];
  return {target, yaw, pitch, distance: (scene.size * 0.5 * 0.86) / half + scene.size * 0.12};
}

/** Interpolates two orbits at t in [0, 1], turning the shorter way. */
export function between(from: Orbit, to: Orbit, t: number): Orbit {
  const yaw_delta = Math.atan2(Math.sin(to.yaw - from.yaw), Math.cos(to.yaw - from.yaw));
  return {
    target: add(from.target, scale(subtract(to.target, from.target), t)),
    yaw: from.yaw + yaw_delta * t,
    pitch: from.pitch + (to.pitch - from.pitch) * t,
    distance: from.distance * Math.pow(to.distance / from.distance, t),
  };
}

export function backward({yaw, pitch}: Orbit): Vector {
  return [Math.sin(yaw) * Math.cos(pitch), Math.sin(pitch), Math.cos(yaw) * Math.cos(pitch)];
}

export function pinholeOf(o: Orbit): Pinhole {
  return {position: add(o.target, scale(backward(o), o.distance)), target: o.target, up: [0, 1, 0], fov_degrees};
}

export function turned(o: Orbit, yaw: number, pitch: number): Orbit {
  return {...o, yaw: o.yaw + yaw, pitch: Math.max(-max_pitch, Math.min(max_pitch, o.pitch + pitch))};
}

export function zoomed(o: Orbit, factor: number, size: number): Orbit {
  return {...o, distance: Math.max(size * 0.02, Math.min(size * 20, o.distance * factor))};
}

/** Returns the camera's unit vectors right, up and forward. */
export function axes(o: Orbit): {right: Vector; up: Vector; forward: Vector} {
  const forward = scale(backward(o), -1);
  const right = unit(cross(forward, [0, 1, 0]));
  return {right, up: cross(right, forward), forward};
}

/** Pans by pixels of a picture `height` pixels high, so that a point at the target's depth stays under the pointer. */
export function panned(o: Orbit, dx: number, dy: number, height: number): Orbit {
  const pixel = (2 * o.distance * Math.tan((fov_degrees * Math.PI) / 360)) / height;
  const {right, up} = axes(o);
  return {...o, target: add(o.target, add(scale(right, -dx * pixel), scale(up, dy * pixel)))};
}

/** Converts between points and pixels of a picture of this size. */
export class Projection {
  private readonly position: Vector;
  private readonly frame: {right: Vector; up: Vector; forward: Vector};
  private readonly focal: number;  // pixels

  constructor(o: Orbit, readonly width: number, readonly height: number) {
    this.position = pinholeOf(o).position;
    this.frame = axes(o);
    this.focal = height / (2 * Math.tan((fov_degrees * Math.PI) / 360));
  }

  /** Returns the pixel of a point, from the top left; null if the point is behind the camera. */
  project(point: Vector): [number, number] | null {
    const offset = subtract(point, this.position);
    const depth = dot(offset, this.frame.forward);
    if (!(depth > 0)) return null;
    const per = this.focal / depth;
    return [this.width / 2 + dot(offset, this.frame.right) * per, this.height / 2 - dot(offset, this.frame.up) * per];
  }

  ray(x: number, y: number): {origin: Vector; direction: Vector} {
    const {right, up, forward} = this.frame;
    const along = add(scale(right, (x - this.width / 2) / this.focal), scale(up, (this.height / 2 - y) / this.focal));
    return {origin: this.position, direction: unit(add(forward, along))};
  }

  /** Returns the size of a pixel at a point's depth, in model units. */
  unitsPerPixel(point: Vector): number {
    return Math.max(dot(subtract(point, this.position), this.frame.forward), 0) / this.focal;
  }

  distanceTo(point: Vector): number { return norm(subtract(point, this.position)); }
}
