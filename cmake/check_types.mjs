// Generates TypeScript types from the contract and checks a client's sources against them.
// usage: node check_types.mjs CONTRACT_JSON CLIENT OUT     CLIENT: folder with tsconfig.json, src and node_modules; writes OUT/contract.d.ts
import {execFileSync} from "node:child_process";
import {writeFileSync} from "node:fs";
import {join, resolve} from "node:path";

const [contract, client, out] = process.argv.slice(2).map((path) => resolve(path));
if (!contract || !client || !out) {
  console.error("usage: node check_types.mjs CONTRACT_JSON CLIENT OUT");
  process.exit(2);
}
const run = (script, words, stdout) =>
  execFileSync(process.execPath, [join(client, "node_modules", script), ...words], {cwd: client, stdio: ["ignore", stdout, "inherit"]});
const types = join(out, "contract.d.ts");
const config = join(out, "tsconfig.json");
writeFileSync(config, JSON.stringify({
  extends: join(client, "tsconfig.json"),
  compilerOptions: {paths: {contract: [types]}, typeRoots: [join(client, "node_modules/@types")]},
  include: [join(client, "src")],
}));
try {
  run("openapi-typescript/bin/cli.js", [contract, "--output", types, "--default-non-nullable=false"], "ignore");
  run("typescript/bin/tsc", ["--project", config], "inherit");
} catch {
  console.error(`${client}: its types do not fit the contract, or the contract cannot be turned into types`);
  process.exit(1);
}
