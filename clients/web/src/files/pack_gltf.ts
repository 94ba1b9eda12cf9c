// Packs a .gltf and the files that it references into one GLB: all buffers and pictures follow each other in its binary
// chunk.
import {baseOf, endingOf, findNamed, type InputFile} from "./take";

interface BufferView { buffer: number; byteOffset?: number; byteLength: number; extensions?: Record<string, {buffer?: number; byteOffset?: number}> }
interface Gltf {
  buffers?: {uri?: string; byteLength: number}[];
  bufferViews?: BufferView[];
  images?: {uri?: string; bufferView?: number; mimeType?: string; name?: string}[];
}

const picture_types: Record<string, string> = {png: "image/png", jpg: "image/jpeg", jpeg: "image/jpeg", webp: "image/webp", ktx2: "image/ktx2"};
const glb_magic = 0x46546c67, chunk_json = 0x4e4f534a, chunk_binary = 0x004e4942;

/** Files that the model references are missing. */
export class MissingFiles extends Error {
  constructor(readonly names: string[]) { super(`Files are missing: ${names.join(", ")}.`); }
}

function bytesOfDataUri(uri: string): Uint8Array {
  const comma = uri.indexOf(",");
  const data = uri.slice(comma + 1);
  if (!uri.slice(0, comma).endsWith(";base64")) return new TextEncoder().encode(decodeURIComponent(data));
  return Uint8Array.from(atob(data), (letter) => letter.charCodeAt(0));
}

/** Concatenates blobs, each aligned to 4 bytes. */
class Binary {
  readonly parts: (Uint8Array | Blob)[] = [];
  bytes = 0;

  add(part: Uint8Array | Blob): number {
    const start = this.bytes;
    const size = part instanceof Blob ? part.size : part.byteLength;
    this.parts.push(part);
    this.bytes += size;
    this.pad(0);
    return start;
  }

  private pad(value: number) {
    const missing = (4 - (this.bytes % 4)) % 4;
    if (missing === 0) return;
    this.parts.push(new Uint8Array(missing).fill(value));
    this.bytes += missing;
  }
}

function rebaseViews(gltf: Gltf, offsets: number[]) {
  for (const view of gltf.bufferViews ?? []) {
    for (const reference of [view, ...Object.values(view.extensions ?? {})]) {  // compression extensions have their own buffer
      if (typeof reference.buffer !== "number") continue;
      reference.byteOffset = (reference.byteOffset ?? 0) + (offsets[reference.buffer] ?? 0);
      reference.buffer = 0;
    }
  }
}

function addPictures(gltf: Gltf, binary: Binary, openFile: (uri: string) => Uint8Array | Blob | null) {
  for (const image of gltf.images ?? []) {
    if (image.uri === undefined) continue;
    const bytes = openFile(image.uri);
    if (!bytes) continue;
    image.mimeType ??= /^data:([^;,]+)/.exec(image.uri)?.[1] ?? picture_types[endingOf(image.uri)] ?? "image/png";
    gltf.bufferViews = [...(gltf.bufferViews ?? []), {buffer: 0, byteOffset: binary.add(bytes), byteLength: bytes instanceof Blob ? bytes.size : bytes.byteLength}];
    image.bufferView = gltf.bufferViews.length - 1;
    delete image.uri;
  }
}

function glb(gltf: Gltf, binary: Binary): Blob {
  const json = new TextEncoder().encode(JSON.stringify(gltf));
  const padded = new Uint8Array(Math.ceil(json.length / 4) * 4).fill(0x20);
  padded.set(json);
  const head = new Uint32Array([glb_magic, 2, 28 + padded.length + binary.bytes, padded.length, chunk_json]);
  return new Blob([head, padded, new Uint32Array([binary.bytes, chunk_binary]), ...binary.parts] as BlobPart[]);
}

export async function packGltf(model: InputFile, all: InputFile[]): Promise<Blob> {
  const gltf = JSON.parse(await model.file.text()) as Gltf;
  const missing: string[] = [];
  const openFile = (uri: string): Uint8Array | Blob | null => {
    if (uri.startsWith("data:")) return bytesOfDataUri(uri);
    const found = findNamed(all, model.path, decodeURIComponent(uri));
    if (!found) missing.push(baseOf(decodeURIComponent(uri)));
    return found?.file ?? null;
  };
  const binary = new Binary();
  const offsets = (gltf.buffers ?? []).map(({uri}) => {
    const bytes = uri === undefined ? null : openFile(uri);
    return bytes ? binary.add(bytes) : 0;
  });
  rebaseViews(gltf, offsets);
  addPictures(gltf, binary, openFile);
  if (missing.length) throw new MissingFiles([...new Set(missing)]);
  if (binary.bytes) gltf.buffers = [{byteLength: binary.bytes}];
  return glb(gltf, binary);
}
