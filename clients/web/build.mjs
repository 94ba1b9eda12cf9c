// Builds the studio: bundles with hashed names, compresses each file. Types are checked by cmake/check_types.mjs.
// usage: node build.mjs OUT     writes OUT/dist/
import {mkdirSync, readFileSync, rmSync, writeFileSync} from "node:fs";
import {basename, dirname, join, resolve} from "node:path";
import {fileURLToPath} from "node:url";
import * as esbuild from "esbuild";
import {compress} from "../../cmake/compress.mjs";

const here = dirname(fileURLToPath(import.meta.url));
if (!process.argv[2]) {
  console.error("usage: node build.mjs OUT");
  process.exit(2);
}
const dist = join(resolve(process.argv[2]), "dist");

async function bundle() {
  return esbuild.build({
    entryPoints: {studio: join(here, "src/main.tsx"), style: join(here, "src/style/index.css")},
    outdir: join(dist, "assets"), publicPath: "/assets/",
    entryNames: "[name]-[hash]", chunkNames: "[name]-[hash]", assetNames: "[name]-[hash]",
    bundle: true, splitting: true, format: "esm", minify: true, metafile: true, target: "es2022",
    jsx: "automatic", jsxImportSource: "preact",
    // Imports three.js's source modules, so that unused ones are dropped: a third of the size.
    alias: {three: join(here, "node_modules/three/src/Three.js")},
    loader: {".jpg": "file", ".webp": "file", ".svg": "file", ".json": "json"},
    legalComments: "none", logLevel: "warning",
  });
}

function writePage(outputs) {
  const entry = (of) => "/assets/" + basename(Object.keys(outputs).find((path) => outputs[path].entryPoint?.endsWith(of)));
  const page = readFileSync(join(here, "src/index.html"), "utf8")
    .replace("STYLE", entry("index.css")).replace("SCRIPT", entry("main.tsx"))
    .replace("PROXY", entry("view/proxy.ts"));  // preloaded, because the brush needs it soon
  writeFileSync(join(dist, "index.html"), page);
}

rmSync(dist, {recursive: true, force: true});
mkdirSync(join(dist, "assets"), {recursive: true});
try {
  const {metafile} = await bundle();
  writePage(metafile.outputs);
} catch (error) {
  console.error(`studio: ${error.message}`);
  process.exit(1);
}
compress(dist);
