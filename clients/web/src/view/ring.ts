// The brush under the pointer: a ring that lies on the surface, and a glow on what a dab would touch.
import type {Vector} from "../api/types";
import type {Projection} from "./camera";
import type {Hit, Proxy} from "./proxy";
import {add, dot, norm, scale, subtract, tangents, unit} from "./vector";

export interface RingStyle { radius: number; inner: number; colour: string; symmetric: Hit[] }

const points = 48;
const max_drop = 0.45;  // radii: what lies deeper or higher is another part of the model
const min_facing = 0.35; // cosine to the hit's normal: what is turned farther away is the other side of a fold
const max_glow = 400;  // triangles
const max_depth = 0.35;  // radii: what lies deeper behind the surface that the camera sees is hidden

/** How far the surface lies above the tangent plane around the hit, in points of a circle; what lies too far is another part. */
function heightsOf(proxy: Proxy, normal: Vector, flat: Vector[], radius: number): number[] {
  const heights = flat.map((point) => {
    const down = proxy.cast(add(point, scale(normal, radius)), scale(normal, -1));
    if (!down || dot(down.normal, normal) < min_facing) return 0;
    const height = radius - down.distance;
    return Math.abs(height) < max_drop * radius ? height : 0;
  });
  const near = (k: number) => heights[(k + heights.length) % heights.length]!;
  return heights.map((_, k) => (near(k - 2) + 2 * near(k - 1) + 3 * near(k) + 2 * near(k + 1) + near(k + 2)) / 9);  // no jump at folds
}

/** Points of a circle about the hit, laid down on the surface along the hit's normal. */
function ringPoints(proxy: Proxy, hit: Hit, radius: number): Vector[] {
  const [u, v] = tangents(hit.normal);
  const flat = Array.from({length: points}, (_, k) => {
    const angle = (2 * Math.PI * k) / points;
    return add(hit.point, add(scale(u, radius * Math.cos(angle)), scale(v, radius * Math.sin(angle))));
  });
  const heights = heightsOf(proxy, hit.normal, flat, radius);
  return flat.map((point, k) => add(point, scale(hit.normal, heights[k]!)));
}

function trace(context: CanvasRenderingContext2D, projection: Projection, ring: Vector[]) {
  context.beginPath();
  ring.forEach((point, k) => {
    const pixel = projection.project(point);
    if (!pixel) return;
    if (k === 0) context.moveTo(...pixel);
    else context.lineTo(...pixel);
  });
  context.closePath();
}

/** Which points the camera sees: where the body lies before one, it is hidden. */
function visibleOf(proxy: Proxy, ring: Vector[], radius: number, eye: Vector): boolean[] {
  return ring.map((point) => {
    const away = subtract(point, eye);
    const first = proxy.cast(eye, unit(away));
    return !first || first.distance > norm(away) - max_depth * radius;
  });
}

/** The closed line through the ring's points without its hidden parts. */
function traceVisible(context: CanvasRenderingContext2D, projection: Projection, ring: Vector[], visible: boolean[]) {
  context.beginPath();
  for (let k = 0; k < ring.length; ++k) {
    const next = (k + 1) % ring.length;
    const [from, to] = [projection.project(ring[k]!), projection.project(ring[next]!)];
    if (!from || !to || !visible[k] || !visible[next]) continue;
    if (k === 0 || !visible[k - 1]) context.moveTo(...from);
    context.lineTo(...to);
  }
}

/** A dark line under a light one, seen on any fur. */
function strokeTwice(context: CanvasRenderingContext2D, colour: string) {
  for (const [width, stroke] of [[3.5, "rgba(0,0,0,.55)"], [1.6, colour]] as const) {
    context.lineWidth = width;
    context.strokeStyle = stroke;
    context.stroke();
  }
}

function glow(context: CanvasRenderingContext2D, projection: Projection, proxy: Proxy, hit: Hit, style: RingStyle, towards: Vector) {
  context.fillStyle = style.colour;
  for (const corners of proxy.trianglesNear(hit.point, style.radius, max_glow)) {
    const middle = scale(add(add(corners[0], corners[1]), corners[2]), 1 / 3);
    const weight = 1 - Math.min(1, norm(subtract(middle, hit.point)) / style.radius);
    const facing = dot(hit.normal, unit(subtract(towards, middle)));
    if (weight <= 0 || facing <= 0) continue;
    context.globalAlpha = 0.22 * weight;
    trace(context, projection, corners);
    context.fill();
  }
  context.globalAlpha = 1;
}

/** Draws on a cleared canvas. `eye` is the camera's position. */
export function drawRing(context: CanvasRenderingContext2D, projection: Projection, proxy: Proxy, hit: Hit, style: RingStyle, eye: Vector) {
  glow(context, projection, proxy, hit, style, eye);
  context.setLineDash([3, 4]);
  for (const at of style.symmetric) {
    const ring = ringPoints(proxy, at, style.radius);
    traceVisible(context, projection, ring, visibleOf(proxy, ring, style.radius, eye));
    strokeTwice(context, style.colour);
  }
  context.setLineDash([]);
  trace(context, projection, ringPoints(proxy, hit, style.radius));
  strokeTwice(context, style.colour);
  context.lineWidth = 1;
  context.globalAlpha = 0.7;
  trace(context, projection, ringPoints(proxy, hit, style.radius * style.inner));
  context.stroke();
  context.globalAlpha = 1;
}
