// Small models with all that they name, written into a folder: a box with texture coordinates as OBJ and as glTF.
import {mkdirSync, writeFileSync} from "node:fs";
import {join} from "node:path";
import {deflateSync, crc32} from "node:zlib";

function chunk(type, data) {
  const bytes = Buffer.alloc(12 + data.length);
  bytes.writeUInt32BE(data.length, 0);
  bytes.write(type, 4, "latin1");
  data.copy(bytes, 8);
  bytes.writeUInt32BE(crc32(bytes.subarray(4, 8 + data.length)), 8 + data.length);
  return bytes;
}

/** A PNG of one colour. */
export function png(side, [red, green, blue]) {
  const head = Buffer.alloc(13);
  head.writeUInt32BE(side, 0);
  head.writeUInt32BE(side, 4);
  head.set([8, 2, 0, 0, 0], 8);
  const row = Buffer.concat([Buffer.from([0]), Buffer.from(Array.from({length: side}, () => [red, green, blue]).flat())]);
  const rows = Buffer.concat(Array.from({length: side}, () => row));
  return Buffer.concat([Buffer.from([0x89, 0x50, 0x4e, 0x47, 0x0d, 0x0a, 0x1a, 0x0a]), chunk("IHDR", head), chunk("IDAT", deflateSync(rows)), chunk("IEND", Buffer.alloc(0))]);
}

const corners = [[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0], [0, 0, 1], [1, 0, 1], [1, 1, 1], [0, 1, 1]];
const quads = [[0, 3, 2, 1], [4, 5, 6, 7], [0, 1, 5, 4], [2, 3, 7, 6], [1, 2, 6, 5], [3, 0, 4, 7]];
const uvs = [[0, 0], [1, 0], [1, 1], [0, 1]];

/** box.obj, "the box.mtl" and pictures/Skin.PNG, named in other capitals and with options; or an OBJ that names no materials. */
export function objFolder(root, {two = false, materials = true} = {}) {
  const folder = join(root, two ? "two" : materials ? "box" : "plain");
  mkdirSync(join(folder, "pictures"), {recursive: true});
  const faces = quads.map((quad) => `f ${quad.map((corner, k) => `${corner + 1}/${k + 1}`).join(" ")}`);
  writeFileSync(join(folder, "box.obj"), [...(materials ? ["mtllib the box.mtl"] : []), ...corners.map((c) => `v ${c.join(" ")}`), ...uvs.map((uv) => `vt ${uv.join(" ")}`), "usemtl skin", ...faces, ""].join("\n"));
  writeFileSync(join(folder, "the box.mtl"), `newmtl skin\nKd 1 1 1\nmap_Kd -s 1 1 1 -bm 0.5 pictures\\skin.png\n${two ? "newmtl other\nmap_Kd pictures/other.png\n" : ""}`);
  writeFileSync(join(folder, "pictures", "Skin.PNG"), png(4, [255, 0, 0]));
  if (two) writeFileSync(join(folder, "pictures", "other.png"), png(4, [0, 0, 255]));
  return folder;
}

/** A strip with two materials, of which one is named after a hoof. */
export function hoofFile(root) {
  const file = join(root, "strip.obj");
  const corners = Array.from({length: 9}, (_, x) => [`v ${x} 0 0`, `v ${x} 0 1`]).flat();
  const faces = Array.from({length: 8}, (_, x) => `f ${[1, 2, 4, 3].map((k) => 2 * x + k).join(" ")}`);
  writeFileSync(file, [...corners, "usemtl Pelt", ...faces.slice(0, 5), "usemtl Hoof", ...faces.slice(5), ""].join("\n"));
  return file;
}

/** box.gltf with its buffer and its picture as files of their own. */
export function gltfFolder(root) {
  const folder = join(root, "gltf");
  mkdirSync(folder, {recursive: true});
  const positions = quads.flatMap((quad) => quad.map((corner) => corners[corner])).flat();
  const corner_uvs = quads.flatMap(() => uvs).flat();
  const indices = quads.flatMap((_, k) => [0, 1, 2, 0, 2, 3].map((at) => 4 * k + at));
  const binary = Buffer.concat([Buffer.from(new Float32Array(positions).buffer), Buffer.from(new Float32Array(corner_uvs).buffer), Buffer.from(new Uint16Array(indices).buffer)]);
  const views = [[0, 288], [288, 192], [480, 72]].map(([byteOffset, byteLength]) => ({buffer: 0, byteOffset, byteLength}));
  writeFileSync(join(folder, "the box.bin"), binary);
  writeFileSync(join(folder, "skin.png"), png(4, [0, 255, 0]));
  writeFileSync(join(folder, "box.gltf"), JSON.stringify({
    asset: {version: "2.0"}, scene: 0, scenes: [{nodes: [0]}], nodes: [{mesh: 0}],
    meshes: [{primitives: [{attributes: {POSITION: 0, TEXCOORD_0: 1}, indices: 2, material: 0}]}],
    materials: [{pbrMetallicRoughness: {baseColorTexture: {index: 0}}}], textures: [{source: 0}], images: [{uri: "skin.png"}],
    accessors: [{bufferView: 0, componentType: 5126, count: 24, type: "VEC3", min: [0, 0, 0], max: [1, 1, 1]},
      {bufferView: 1, componentType: 5126, count: 24, type: "VEC2"}, {bufferView: 2, componentType: 5123, count: 36, type: "SCALAR"}],
    bufferViews: views, buffers: [{uri: "the%20box.bin", byteLength: binary.length}],
  }));
  return folder;
}
