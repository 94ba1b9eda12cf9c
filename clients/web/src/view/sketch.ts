// Draws lines over the picture: the user's line, and the planes of symmetry.
import type {Scene, Symmetry, Vector} from "../api/types";
import type {Projection} from "./camera";
import {planesOf} from "./mirror";
import {add, scale, subtract, dot, tangents, unit} from "./vector";

export function drawLine(pen: CanvasRenderingContext2D, projection: Projection, points: Vector[], colour = "#ffd28a") {
  for (const [width, stroke] of [[4, "rgba(0,0,0,.5)"], [2, colour]] as const) {
    pen.lineWidth = width;
    pen.strokeStyle = stroke;
    pen.beginPath();
    points.map((point) => projection.project(point)).forEach((pixel, k) => {
      if (pixel) pen[k === 0 ? "moveTo" : "lineTo"](...pixel);
    });
    pen.stroke();
  }
}

/** Draws a faint frame for each symmetry plane, as large as the model. */
export function drawPlanes(pen: CanvasRenderingContext2D, projection: Projection, symmetry: Symmetry, scene: Scene | null) {
  if (!scene) return;
  const {min, max} = scene.bounds as {min: Vector; max: Vector};
  const middle = scale(add(min, max), 0.5);
  for (const plane of planesOf(symmetry)) {
    const normal = unit(plane.normal);
    const centre = subtract(middle, scale(normal, dot(subtract(middle, plane.point), normal)));
    const [u, v] = tangents(normal);
    const corner = (a: number, b: number) => add(centre, add(scale(u, a * scene.size * 0.45), scale(v, b * scene.size * 0.45)));
    pen.globalAlpha = 0.5;
    pen.setLineDash([6, 5]);
    pen.lineWidth = 1.2;
    pen.strokeStyle = "#8fd0c0";
    pen.beginPath();
    [corner(-1, -1), corner(1, -1), corner(1, 1), corner(-1, 1), corner(-1, -1)].forEach((point, k) => {
      const pixel = projection.project(point);
      if (pixel) pen[k === 0 ? "moveTo" : "lineTo"](...pixel);
    });
    pen.stroke();
    pen.setLineDash([]);
    pen.globalAlpha = 1;
  }
}
