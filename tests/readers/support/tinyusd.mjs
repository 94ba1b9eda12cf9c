// TinyUSDZ, a reader of USD by others, in node. Its package is WebAssembly for browsers, built to refuse node; it asks as
// it starts, and from then on needs no browser. Nor does the package say that it is a module, without which node 18 does
// not import it: it goes in as text.
import {readFileSync} from "node:fs";
import {createRequire} from "node:module";

const file = (name) => readFileSync(createRequire(import.meta.url).resolve(`tinyusdz/${name}`));
const {default: init} = await import(`data:text/javascript;base64,${file("tinyusdz.js").toString("base64")}`);

async function started() {
  process.type = "renderer";  // as in a page of Electron, which has node too
  globalThis.window = globalThis;
  try {
    return await init({wasmBinary: file("tinyusdz.wasm"), locateFile: (name) => name});
  } finally {
    delete process.type;
    delete globalThis.window;
  }
}
const tiny = await started();

/** Calls `use` with a file that was read, as a whole scene or as a layer. Throws where the reader refuses it. */
function read(bytes, method, use) {
  const usd = new tiny.TinyUSDZLoaderNative();
  try {
    if (!usd[method](bytes, "fur.usda")) throw new Error(`TinyUSDZ: ${usd.error()}`);
    return use(usd);
  } finally {
    usd.delete();
  }
}

/** The tree of what can be drawn, each with name, type, matrices and children; and the number of its meshes. The reader
 * checks the types of all attributes of curves here, but its nodes have none of their data. */
export const scene_of = (bytes) => read(bytes, "loadFromBinary", (usd) => ({root: usd.getDefaultRootNode(), meshes: usd.numMeshes()}));

/** All that the layer holds, as text that the reader writes from what it has read. */
export const layer_of = (bytes) => read(bytes, "loadAsLayerFromBinary", (usd) => usd.layerToString());

/** The numbers of an array of such a text, flat. declaration: Such as "point3f[] points". */
export function numbers_of(text, declaration) {
  const start = text.indexOf(`${declaration} = [`);
  if (start < 0) return undefined;
  const inside = text.slice(start + declaration.length + 4, text.indexOf("]", start + declaration.length + 4));
  return Float32Array.from(inside.match(/-?[\d.]+(?:e[-+]?\d+)?/g) ?? [], Number);
}
