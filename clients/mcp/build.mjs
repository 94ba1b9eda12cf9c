// Builds the MCP server: generates types from the contract, checks types, bundles one program without dependencies, and
// copies the looks and recipes beside it.
// usage: node build.mjs CONTRACT_JSON OUT     writes OUT/pelage-mcp.js, OUT/looks/, OUT/recipes/ and OUT/contract.d.ts
import {execFileSync} from "node:child_process";
import {chmodSync, cpSync, mkdirSync, rmSync, writeFileSync} from "node:fs";
import {dirname, join, resolve} from "node:path";
import {fileURLToPath} from "node:url";
import * as esbuild from "esbuild";

const here = dirname(fileURLToPath(import.meta.url));
const [contract, out] = process.argv.slice(2).map((path) => resolve(path));
if (!contract || !out) {
  console.error("usage: node build.mjs CONTRACT_JSON OUT");
  process.exit(2);
}
const program = join(out, "pelage-mcp.js");
const run = (script, ...words) => execFileSync(process.execPath, [join(here, "node_modules", script), ...words], {cwd: here, stdio: ["ignore", "ignore", "inherit"]});

/** Generates the contract's types and runs the type check, which fails if this client does not fit the contract. */
function checkTypes() {
  run("openapi-typescript/bin/cli.js", contract, "--output", join(out, "contract.d.ts"), "--default-non-nullable=false");
  const config = join(out, "tsconfig.json");
  writeFileSync(config, JSON.stringify({
    extends: join(here, "tsconfig.json"),
    compilerOptions: {paths: {contract: [join(out, "contract.d.ts")]}, typeRoots: [join(here, "node_modules/@types")]},
    include: [join(here, "src")],
  }));
  execFileSync(process.execPath, [join(here, "node_modules/typescript/bin/tsc"), "--project", config], {stdio: "inherit"});
  rmSync(config);
}

async function bundle() {
  await esbuild.build({
    entryPoints: [join(here, "src/main.ts")], outfile: program, bundle: true, platform: "node", format: "esm", target: "node18",
    banner: {js: "#!/usr/bin/env node"}, legalComments: "eof", logLevel: "warning",
  });
  chmodSync(program, 0o755);
}

try {
  mkdirSync(out, {recursive: true});
  checkTypes();
  await bundle();
  for (const folder of ["looks", "recipes"]) {
    rmSync(join(out, folder), {recursive: true, force: true});
    cpSync(join(here, "..", folder), join(out, folder), {recursive: true, filter: (path) => !/\.[^/]*$/.test(path) || path.endsWith(".json")});
  }
} catch (error) {
  console.error(`pelage-mcp: ${error.message}`);
  process.exit(1);
}
