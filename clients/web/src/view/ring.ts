// The brush cursor: a ring of the brush's radius, and the strands in it that the brush would touch.
import type {Vector} from "../api/types";
import type {Projection} from "./camera";
import type {Hit, Proxy} from "./proxy";
import {add, dot, norm, scale, subtract, tangents, unit} from "./vector";

export interface RingStyle {
  radius: number;  // in model units
  inner: number;   // radius of the inner ring as a fraction, given by the brush's strength
  colour: string;
  /** True if the brush measures distance along the skin, not through space. */
  flat: boolean;
}

const points = 64;
const max_strands = 260;
const hidden_depth = 0.5;  // in radii; a mirrored ring deeper than this behind visible fur is not drawn

/** Returns the points of a circle around a hit, perpendicular to `normal`. */
function ringPoints(hit: Hit, radius: number, normal: Vector): Vector[] {
  const [u, v] = tangents(normal);
  return Array.from({length: points}, (_, k) => {
    const angle = (2 * Math.PI * k) / points;
    return add(hit.point, add(scale(u, radius * Math.cos(angle)), scale(v, radius * Math.sin(angle))));
  });
}

function trace(pen: CanvasRenderingContext2D, projection: Projection, ring: Vector[]) {
  pen.beginPath();
  ring.forEach((point, k) => {
    const pixel = projection.project(point);
    if (pixel) pen[k === 0 ? "moveTo" : "lineTo"](...pixel);
  });
  pen.closePath();
}

/** Strokes the path with a light line on a wider dark one, so that it is visible on any fur. */
function strokeTwice(pen: CanvasRenderingContext2D, colour: string, width = 1.6, rim = 2) {
  for (const [wide, stroke] of [[width + rim, "rgba(0,0,0,.55)"], [width, colour]] as const) {
    pen.lineWidth = wide;
    pen.strokeStyle = stroke;
    pen.stroke();
  }
}

/** Draws the front-facing strands within the radius of a point; nearer ones are more opaque. */
export function drawStrands(pen: CanvasRenderingContext2D, projection: Projection, proxy: Proxy, at: Vector, style: Pick<RingStyle, "radius" | "colour">, camera: Vector, max_count = max_strands) {
  for (const {root, middle, tip, normal} of proxy.strandsNear(at, style.radius, max_count)) {
    if (dot(normal, subtract(camera, middle)) <= 0) continue;
    const nearest = Math.min(...[root, middle, tip].map((knot) => norm(subtract(knot, at))));
    const [a, b, c] = [root, middle, tip].map((knot) => projection.project(knot));
    if (!a || !b || !c) continue;
    pen.globalAlpha = 0.75 * Math.max(0.15, 1 - nearest / style.radius);
    pen.beginPath();
    pen.moveTo(...a);
    pen.quadraticCurveTo(2 * b[0] - (a[0] + c[0]) / 2, 2 * b[1] - (a[1] + c[1]) / 2, ...c);
    strokeTwice(pen, style.colour, 1.1, 0.9);
  }
  pen.globalAlpha = 1;
}

const isHidden = (proxy: Proxy, hit: Hit, radius: number, camera: Vector) => {
  const away = subtract(hit.point, camera);
  const first = proxy.touch(camera, unit(away));
  return first !== null && first.distance < norm(away) - hidden_depth * radius;
};

/** Draws the ring and its strands on a cleared canvas, and dashed rings at those `mirrored` hits that are visible. */
export function drawRing(pen: CanvasRenderingContext2D, projection: Projection, proxy: Proxy, hit: Hit, mirrored: Hit[], style: RingStyle, camera: Vector) {
  const facing = (at: Hit) => (style.flat ? at.normal : unit(subtract(camera, at.point)));
  drawStrands(pen, projection, proxy, hit.point, style, camera);
  pen.setLineDash([3, 4]);
  for (const at of mirrored) {
    if (isHidden(proxy, at, style.radius, camera)) continue;
    trace(pen, projection, ringPoints(at, style.radius, facing(at)));
    strokeTwice(pen, style.colour);
  }
  pen.setLineDash([]);
  trace(pen, projection, ringPoints(hit, style.radius, facing(hit)));
  strokeTwice(pen, style.colour);
  pen.globalAlpha = 0.7;
  trace(pen, projection, ringPoints(hit, style.radius * style.inner, facing(hit)));
  pen.lineWidth = 1;
  pen.stroke();
  pen.globalAlpha = 1;
}
