// Takes GLBs apart and puts them together, to inspect and damage them, and runs the Khronos validator on them.
import {validateBytes} from "gltf-validator";

/** Returns the JSON and the binary chunk; both may be modified. */
export function parts_of(bytes) {
  const view = new DataView(bytes.buffer, bytes.byteOffset);
  const length = view.getUint32(12, true);
  return {json: JSON.parse(new TextDecoder().decode(bytes.subarray(20, 20 + length))), binary: bytes.slice(28 + length)};
}

export function glb_of({json, binary}) {
  const text = new TextEncoder().encode(JSON.stringify(json));
  const padded = Math.ceil(text.length / 4) * 4;
  const bytes = new Uint8Array(28 + padded + binary.length).fill(0x20, 20 + text.length, 20 + padded);
  const view = new DataView(bytes.buffer);
  [0x46546c67, 2, bytes.length, padded, 0x4e4f534a].forEach((number, k) => view.setUint32(4 * k, number, true));
  bytes.set(text, 20);
  view.setUint32(20 + padded, binary.length, true);
  view.setUint32(24 + padded, 0x004e4942, true);
  bytes.set(binary, 28 + padded);
  return bytes;
}

/** Returns the numbers of an accessor, as a view of the binary chunk. */
export function numbers_of({json, binary}, accessor) {
  const {bufferView, byteOffset = 0, componentType, count, type} = json.accessors[accessor];
  const Kind = {5121: Uint8Array, 5123: Uint16Array, 5125: Uint32Array, 5126: Float32Array}[componentType];
  const width = {SCALAR: 1, VEC2: 2, VEC3: 3, VEC4: 4}[type];
  return new Kind(binary.buffer, binary.byteOffset + (json.bufferViews[bufferView].byteOffset ?? 0) + byteOffset, count * width);
}

const severities = ["error", "warning", "info", "hint"];

/** Returns the validator's findings, each as "error CODE at: message", and its counts of the whole file. */
export async function validated(bytes) {
  const {issues, info} = await validateBytes(bytes, {format: "glb", maxIssues: 0, writeTimestamp: false});
  const found = issues.messages.map(({severity, code, pointer, offset, message}) =>
    `${severities[severity]} ${code} ${pointer ?? `byte ${offset}`}: ${message}`);
  return {found, info};
}
