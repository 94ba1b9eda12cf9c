// The light copy of the model that rays are cast on, so that the brush follows the hand whatever the server does.
// three.js and its BVH are loaded with the first model, after the page stands.
import {BufferAttribute, BufferGeometry, DoubleSide, Ray, Vector3} from "three";
import {INTERSECTED, MeshBVH, NOT_INTERSECTED} from "three-mesh-bvh";
import {call, scenePath} from "../api/client";
import type {Vector} from "../api/types";
import {add, norm, subtract, unit} from "./vector";

export interface Hit { point: Vector; normal: Vector; distance: number }

const proxy_triangles = 20000;
const glb_magic = 0x46546c67, chunk_json = 0x4e4f534a;

interface Accessor { bufferView: number; componentType: number; count: number }
interface Gltf {
  nodes: {translation?: Vector}[];
  meshes: {primitives: {attributes: {POSITION: number; NORMAL: number}; indices: number}[]}[];
  accessors: Accessor[];
  bufferViews: {byteOffset?: number; byteLength: number}[];
}

/** The arrays of the one mesh that the server sends. */
function readGlb(bytes: ArrayBuffer) {
  const view = new DataView(bytes);
  if (view.getUint32(0, true) !== glb_magic || view.getUint32(16, true) !== chunk_json) throw new Error("the mesh of the model is no GLB");
  const json_bytes = view.getUint32(12, true);
  const gltf = JSON.parse(new TextDecoder().decode(new Uint8Array(bytes, 20, json_bytes))) as Gltf;
  const data = 20 + json_bytes + 8;
  const primitive = gltf.meshes[0]!.primitives[0]!;
  const start = (index: number) => data + (gltf.bufferViews[gltf.accessors[index]!.bufferView]!.byteOffset ?? 0);
  const floats = (index: number) => new Float32Array(bytes.slice(start(index), start(index) + gltf.accessors[index]!.count * 12));
  const {count, componentType} = gltf.accessors[primitive.indices]!;
  const begin = start(primitive.indices);
  const indices = componentType === 5123 ? new Uint16Array(bytes.slice(begin, begin + count * 2)) : new Uint32Array(bytes.slice(begin, begin + count * 4));
  return {positions: floats(primitive.attributes.POSITION), normals: floats(primitive.attributes.NORMAL), indices,
          origin: gltf.nodes[0]!.translation ?? [0, 0, 0] as Vector};
}

export class Proxy {
  private readonly bvh: MeshBVH;
  private readonly ray = new Ray();
  private constructor(private readonly mesh: ReturnType<typeof readGlb>) {
    const geometry = new BufferGeometry();
    geometry.setAttribute("position", new BufferAttribute(mesh.positions, 3));
    geometry.setIndex(new BufferAttribute(mesh.indices, 1));
    this.bvh = new MeshBVH(geometry, {indirect: true});
  }

  static async load(scene: string): Promise<Proxy> {
    const answer = await call(`${scenePath(scene)}/mesh?triangles=${proxy_triangles}`);
    return new Proxy(readGlb(await answer.arrayBuffer()));
  }

  cast(origin: Vector, direction: Vector): Hit | null {
    this.ray.origin.fromArray(subtract(origin, this.mesh.origin));
    this.ray.direction.fromArray(direction);
    const found = this.bvh.raycastFirst(this.ray, DoubleSide);
    if (!found || found.faceIndex == null) return null;
    const local: Vector = [found.point.x, found.point.y, found.point.z];
    return {point: add(local, this.mesh.origin), normal: this.smoothNormal(found.faceIndex, local), distance: found.distance};
  }

  /** Corners of the triangles within `radius` of `centre`, at most `most`: what a dab would touch. */
  trianglesNear(centre: Vector, radius: number, most: number): [Vector, Vector, Vector][] {
    const local = new Vector3(...subtract(centre, this.mesh.origin));
    const found: [Vector, Vector, Vector][] = [];
    const corner = (v: Vector3): Vector => add([v.x, v.y, v.z], this.mesh.origin);
    this.bvh.shapecast({
      intersectsBounds: (box) => (box.distanceToPoint(local) <= radius ? INTERSECTED : NOT_INTERSECTED),
      intersectsTriangle: (triangle) => {
        if (triangle.closestPointToPoint(local, new Vector3()).distanceTo(local) > radius) return false;
        found.push([corner(triangle.a), corner(triangle.b), corner(triangle.c)]);
        return found.length >= most;
      },
    });
    return found;
  }

  private corner(array: Float32Array, vertex: number): Vector {
    return [array[3 * vertex]!, array[3 * vertex + 1]!, array[3 * vertex + 2]!];
  }

  /** Blended over the triangle by nearness to its corners. */
  private smoothNormal(face: number, point: Vector): Vector {
    let sum: Vector = [0, 0, 0];
    for (let k = 0; k < 3; ++k) {
      const vertex = this.mesh.indices[3 * face + k]!;
      const near = 1 / (norm(subtract(point, this.corner(this.mesh.positions, vertex))) + 1e-30);
      const normal = this.corner(this.mesh.normals, vertex);
      sum = add(sum, [normal[0] * near, normal[1] * near, normal[2] * near]);
    }
    return unit(sum);
  }
}
