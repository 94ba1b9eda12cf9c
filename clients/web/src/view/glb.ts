// Reads the single mesh of a GLB that the server sends, as plain arrays.
import type {Vector} from "../api/types";

export interface MeshArrays {
  positions: Float32Array;  // relative to the origin
  normals: Float32Array;
  indices: Uint16Array | Uint32Array;
  /** Offsets from each position to the middle and to the tip of its strand. */
  middles: Float32Array;
  tips: Float32Array;
  /** 1 where tools work, 0 where the fur is protected. */
  mask: Float32Array;
  origin: Vector;
}

const glb_magic = 0x46546c67, chunk_json = 0x4e4f534a, short_indices = 5123;

interface Accessor { bufferView: number; componentType: number; count: number }
interface Gltf {
  nodes: {translation?: Vector}[];
  meshes: {primitives: {attributes: Record<string, number>; indices: number}[]}[];
  accessors: Accessor[];
  bufferViews: {byteOffset?: number}[];
}

export function readGlb(bytes: ArrayBuffer): MeshArrays {
  const view = new DataView(bytes);
  if (view.getUint32(0, true) !== glb_magic || view.getUint32(16, true) !== chunk_json) throw new Error("The mesh of the model is not a GLB.");
  const json_bytes = view.getUint32(12, true);
  const gltf = JSON.parse(new TextDecoder().decode(new Uint8Array(bytes, 20, json_bytes))) as Gltf;
  const data = 20 + json_bytes + 8;
  const {attributes, indices: index} = gltf.meshes[0]!.primitives[0]!;
  const start = (accessor: number) => data + (gltf.bufferViews[gltf.accessors[accessor]!.bufferView]!.byteOffset ?? 0);
  const floats = (name: string, channels = 3) => {
    const accessor = attributes[name]!;
    return new Float32Array(bytes.slice(start(accessor), start(accessor) + gltf.accessors[accessor]!.count * 4 * channels));
  };
  const {count, componentType} = gltf.accessors[index]!, begin = start(index);
  const indices = componentType === short_indices ? new Uint16Array(bytes.slice(begin, begin + count * 2)) : new Uint32Array(bytes.slice(begin, begin + count * 4));
  return {positions: floats("POSITION"), normals: floats("NORMAL"), indices, middles: floats("_FUR_MIDDLE"), tips: floats("_FUR_TIP"),
          mask: floats("_MASK", 1), origin: gltf.nodes[0]!.translation ?? [0, 0, 0]};
}
