// What axe-core finds wrong with a page, in words.
import {readFileSync} from "node:fs";
import {createRequire} from "node:module";

const axe = readFileSync(createRequire(import.meta.url).resolve("axe-core/axe.min.js"), "utf8");

export async function violations(page) {
  if (!await page.evaluate(() => "axe" in window)) await page.evaluate(axe);
  const found = await page.evaluate(async () => (await window.axe.run(document, {resultTypes: ["violations"]})).violations);
  return found.map(({id: rule, help, nodes}) => `${rule}: ${help}: ${nodes.slice(0, 3).map(({target}) => target.join(" ")).join("; ")}`);
}
