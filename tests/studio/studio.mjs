// All tests of the studio in one program, with one server and one browser. usage: node studio.mjs [SUBJECT...]
import {readdirSync} from "node:fs";
import {endAll, endFile} from "./support/own.mjs";

const asked = process.argv.slice(2);
const subjects = readdirSync(new URL(".", import.meta.url)).filter((name) => name.endsWith(".test.mjs")).map((name) => name.replace(".test.mjs", ""));
for (const subject of subjects.sort()) {
  if (asked.length && !asked.includes(subject)) continue;
  await import(`./${subject}.test.mjs`);
  endFile(subject);
}
endAll();
