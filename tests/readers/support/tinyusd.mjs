// Runs TinyUSDZ, a third-party reader of USD, in node. Its package is WebAssembly built for browsers; it checks for node only
// when it starts, and needs no browser after that. The package does not declare itself a module, so node 18 does not import
// it, and it is loaded as text.
import {readFileSync} from "node:fs";
import {createRequire} from "node:module";

const file = (name) => readFileSync(createRequire(import.meta.url).resolve(`tinyusdz/${name}`));
const {default: init} = await import(`data:text/javascript;base64,${file("tinyusdz.js").toString("base64")}`);

async function started() {
  process.type = "renderer";  // poses as a page of Electron, which has node too
  globalThis.window = globalThis;
  try {
    return await init({wasmBinary: file("tinyusdz.wasm"), locateFile: (name) => name});
  } finally {
    delete process.type;
    delete globalThis.window;
  }
}
const tiny = await started();

/** Reads a file as a whole scene or as a layer, and calls `use` with it. Throws if the reader refuses it. */
function read(bytes, method, use) {
  const usd = new tiny.TinyUSDZLoaderNative();
  try {
    if (!usd[method](bytes, "fur.usda")) throw new Error(`TinyUSDZ: ${usd.error()}`);
    return use(usd);
  } finally {
    usd.delete();
  }
}

/** Returns the tree of drawable nodes, each with name, type, matrices and children, and the number of meshes. The reader checks
 * the types of all attributes of curves here, but its nodes do not contain their data. */
export const scene_of = (bytes) => read(bytes, "loadFromBinary", (usd) => ({root: usd.getDefaultRootNode(), meshes: usd.numMeshes()}));

/** Returns the contents of the layer, as text that the reader writes from what it has read. */
export const layer_of = (bytes) => read(bytes, "loadAsLayerFromBinary", (usd) => usd.layerToString());

/** Returns the numbers of an array in such a text, flat. `declaration` is for example "point3f[] points". */
export function numbers_of(text, declaration) {
  const start = text.indexOf(`${declaration} = [`);
  if (start < 0) return undefined;
  const inside = text.slice(start + declaration.length + 4, text.indexOf("]", start + declaration.length + 4));
  return Float32Array.from(inside.match(/-?[\d.]+(?:e[-+]?\d+)?/g) ?? [], Number);
}
