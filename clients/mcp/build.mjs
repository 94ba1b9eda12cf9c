// Builds the MCP server: bundles one program without dependencies, and copies the looks and recipes beside it. Types are
// checked by cmake/check_types.mjs.
// usage: node build.mjs OUT     writes OUT/pelage-mcp.js, OUT/looks/ and OUT/recipes/
import {chmodSync, cpSync, mkdirSync, rmSync} from "node:fs";
import {dirname, join, resolve} from "node:path";
import {fileURLToPath} from "node:url";
import * as esbuild from "esbuild";

const here = dirname(fileURLToPath(import.meta.url));
if (!process.argv[2]) {
  console.error("usage: node build.mjs OUT");
  process.exit(2);
}
const out = resolve(process.argv[2]);
const program = join(out, "pelage-mcp.js");

async function bundle() {
  await esbuild.build({
    entryPoints: [join(here, "src/main.ts")], outfile: program, bundle: true, platform: "node", format: "esm", target: "node18",
    banner: {js: "#!/usr/bin/env node"}, legalComments: "eof", logLevel: "warning",
  });
  chmodSync(program, 0o755);
}

try {
  mkdirSync(out, {recursive: true});
  await bundle();
  for (const folder of ["looks", "recipes"]) {
    rmSync(join(out, folder), {recursive: true, force: true});
    cpSync(join(here, "..", folder), join(out, folder), {recursive: true, filter: (path) => !/\.[^/]*$/.test(path) || path.endsWith(".json")});
  }
} catch (error) {
  console.error(`pelage-mcp: ${error.message}`);
  process.exit(1);
}
