// Bundles the page, three.js and the exported files into one HTML file.
// usage: node build.mjs PACKAGES FOLDER     reads FOLDER/{shells,cards,fields}.glb and scene.json, writes FOLDER/index.html
import {readFileSync, renameSync, writeFileSync} from "node:fs";
import {createRequire} from "node:module";
import {dirname, join, resolve} from "node:path";
import {fileURLToPath} from "node:url";

const [packages, folder] = process.argv.slice(2).map((path) => resolve(path));
if (!packages || !folder) {
  console.error("usage: node build.mjs PACKAGES FOLDER");
  process.exit(2);
}
const here = dirname(fileURLToPath(import.meta.url));
const esbuild = createRequire(join(packages, "esbuild/package.json"))("esbuild");
const {outputFiles: [script]} = await esbuild.build({
  entryPoints: [join(here, "page.js")], bundle: true, write: false, minify: true, format: "iife", target: "es2022",
  nodePaths: [packages], alias: {exported: folder}, legalComments: "none", logLevel: "warning",
  loader: {".glb": "binary", ".glsl": "text"},
});
// HTML ends a script at the first </script, even inside a string. The replacement is a function because $& in a
// replacement string would be special.
const page = readFileSync(join(here, "page.html"), "utf8").replace("SCRIPT", () => script.text.replaceAll("</script", "<\\/script"));
writeFileSync(join(folder, "index.html.part"), page);
renameSync(join(folder, "index.html.part"), join(folder, "index.html"));
