// Builds the studio: generates types from the contract, checks types, bundles with hashed names, compresses each file.
// usage: node build.mjs CONTRACT_JSON OUT     writes OUT/contract.d.ts and OUT/dist/
import {execFileSync} from "node:child_process";
import {mkdirSync, readFileSync, rmSync, writeFileSync} from "node:fs";
import {basename, dirname, join, resolve} from "node:path";
import {fileURLToPath} from "node:url";
import * as esbuild from "esbuild";
import {compress} from "../../cmake/compress.mjs";

const here = dirname(fileURLToPath(import.meta.url));
const [contract, out] = process.argv.slice(2).map((path) => resolve(path));
if (!contract || !out) {
  console.error("usage: node build.mjs CONTRACT_JSON OUT");
  process.exit(2);
}
const dist = join(out, "dist");
const run = (program, ...words) => execFileSync(process.execPath, [join(here, "node_modules", program), ...words], {cwd: here, stdio: ["ignore", "ignore", "inherit"]});

/** Generates the contract's types and runs the type check, which fails if the studio does not fit the contract. */
function checkTypes() {
  try {
    run("openapi-typescript/bin/cli.js", contract, "--output", join(out, "contract.d.ts"), "--default-non-nullable=false");
  } catch {
    throw new Error("the contract cannot be turned into types");
  }
  const config = join(out, "tsconfig.json");
  writeFileSync(config, JSON.stringify({
    extends: join(here, "tsconfig.json"),
    compilerOptions: {paths: {contract: [join(out, "contract.d.ts")]}, typeRoots: [join(here, "node_modules/@types")]},
    include: [join(here, "src")],
  }));
  execFileSync(process.execPath, [join(here, "node_modules/typescript/bin/tsc"), "--project", config], {stdio: "inherit"});
}

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
  checkTypes();
  const {metafile} = await bundle();
  writePage(metafile.outputs);
} catch (error) {
  console.error(`studio: ${error.message}`);
  process.exit(1);
}
compress(dist);
