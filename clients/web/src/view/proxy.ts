// A simplified copy of the model and its fur for ray casting, so that the brush follows the pointer without waiting for the
// server. three.js and its BVH are loaded with the first model, after the page.
import {BufferAttribute, BufferGeometry, DoubleSide, Ray} from "three";
import {MeshBVH} from "three-mesh-bvh";
import {call, scenePath} from "../api/client";
import type {Vector} from "../api/types";
import {readGlb, type MeshArrays} from "./glb";
import {add, norm, subtract, unit} from "./vector";

export interface Hit { point: Vector; normal: Vector; distance: number }
/** A strand's root, middle and tip, and the normal at its root. */
export interface StrandLine { root: Vector; middle: Vector; tip: Vector; normal: Vector }

const proxy_triangles = 20000;

const cornerOf = (array: Float32Array, vertex: number): Vector => [array[3 * vertex]!, array[3 * vertex + 1]!, array[3 * vertex + 2]!];

/** Returns three surfaces, concatenated: the skin, and those through the middles and the tips of the strands. */
function hullOf({positions, middles, tips, indices}: MeshArrays) {
  const vertices = positions.length / 3;
  const hull = new Float32Array(3 * positions.length);
  const faces = new Uint32Array(3 * indices.length);
  hull.set(positions);
  for (let k = 0; k < positions.length; ++k) {
    hull[positions.length + k] = positions[k]! + middles[k]!;
    hull[2 * positions.length + k] = positions[k]! + tips[k]!;
  }
  for (let layer = 0; layer < 3; ++layer)
    for (let k = 0; k < indices.length; ++k) faces[layer * indices.length + k] = indices[k]! + layer * vertices;
  return {hull, faces};
}

function bvhOf(positions: Float32Array, indices: Uint16Array | Uint32Array): MeshBVH {
  const geometry = new BufferGeometry();
  geometry.setAttribute("position", new BufferAttribute(positions, 3));
  geometry.setIndex(new BufferAttribute(indices, 1));
  return new MeshBVH(geometry, {indirect: true});
}

/** Returns the triangles with at least one vertex that the mask leaves editable, the same ones as in masked pictures. */
function maskedTriangles({indices, mask}: MeshArrays): Uint32Array {
  const left: number[] = [];
  for (let k = 0; k < indices.length; k += 3) {
    const corners = [indices[k]!, indices[k + 1]!, indices[k + 2]!];
    if (corners.some((vertex) => mask[vertex]! > 0.5)) left.push(...corners);
  }
  return Uint32Array.from(left);
}

/** The model at one revision; immutable. */
export class Proxy {
  private readonly skin: MeshBVH;
  private readonly fur: MeshBVH;
  private readonly ray = new Ray();

  private constructor(private readonly mesh: MeshArrays, readonly revision: number, readonly masked: boolean) {
    const {hull, faces} = hullOf(mesh);
    this.skin = bvhOf(mesh.positions, mesh.indices);
    this.fur = bvhOf(hull, faces);
  }

  /** Loads the model. `masked`: leaves out what the mask protects. */
  static async load(scene: string, masked: boolean): Promise<Proxy> {
    const answer = await call(`${scenePath(scene)}/mesh?triangles=${proxy_triangles}&fur=true`);
    const mesh = readGlb(await answer.arrayBuffer());
    if (masked) mesh.indices = maskedTriangles(mesh);
    return new Proxy(mesh, Number(answer.headers.get("Pelage-Revision")), masked);
  }

  /** Intersects a ray with the skin. */
  cast(origin: Vector, direction: Vector): Hit | null { return this.castOn(this.skin, origin, direction); }

  /** Intersects a ray with the fur, or with bald skin. The normal is that of the skin below. */
  touch(origin: Vector, direction: Vector): Hit | null { return this.castOn(this.fur, origin, direction); }

  private castOn(bvh: MeshBVH, origin: Vector, direction: Vector): Hit | null {
    this.ray.origin.fromArray(subtract(origin, this.mesh.origin));
    this.ray.direction.fromArray(direction);
    const found = bvh.raycastFirst(this.ray, DoubleSide);
    if (!found || found.faceIndex == null) return null;
    const local: Vector = [found.point.x, found.point.y, found.point.z];
    return {point: add(local, this.mesh.origin), normal: this.smoothNormal(found.faceIndex % (this.mesh.indices.length / 3), local), distance: found.distance};
  }

  /** Returns strands whose root, middle or tip lies within `radius` of `centre`, evenly thinned to at most `max_count`. */
  strandsNear(centre: Vector, radius: number, max_count: number): StrandLine[] {
    const {positions, normals, middles, tips, mask, origin} = this.mesh;
    const local = subtract(centre, origin);
    const near: number[] = [];
    const within = (x: number, y: number, z: number) => (x - local[0]) ** 2 + (y - local[1]) ** 2 + (z - local[2]) ** 2 <= radius * radius;
    for (let k = 0; k < positions.length; k += 3) {
      if (this.masked && mask[k / 3]! <= 0.5) continue;
      const [x, y, z] = [positions[k]!, positions[k + 1]!, positions[k + 2]!];
      if (within(x, y, z) || within(x + middles[k]!, y + middles[k + 1]!, z + middles[k + 2]!) || within(x + tips[k]!, y + tips[k + 1]!, z + tips[k + 2]!)) near.push(k / 3);
    }
    const step = Math.max(1, Math.ceil(near.length / max_count));
    return near.filter((_, at) => at % step === 0).map((vertex) => {
      const root = add(cornerOf(positions, vertex), origin);
      return {root, middle: add(root, cornerOf(middles, vertex)), tip: add(root, cornerOf(tips, vertex)), normal: cornerOf(normals, vertex)};
    });
  }

  /** Interpolates the vertex normals of a triangle, weighted by the inverse distance to its vertices. */
  private smoothNormal(face: number, point: Vector): Vector {
    let sum: Vector = [0, 0, 0];
    for (let k = 0; k < 3; ++k) {
      const vertex = this.mesh.indices[3 * face + k]!;
      const near = 1 / (norm(subtract(point, cornerOf(this.mesh.positions, vertex))) + 1e-30);
      const normal = cornerOf(this.mesh.normals, vertex);
      sum = add(sum, [normal[0] * near, normal[1] * near, normal[2] * near]);
    }
    return unit(sum);
  }
}
