// What axe-core finds wrong with a page, in words.
import {readFileSync} from "node:fs";
import {createRequire} from "node:module";

const axe = readFileSync(createRequire(import.meta.url).resolve("axe-core/axe.min.js"), "utf8");

/** What is wrong in the dark and in the light; the rules that no colours matter to are tried in the dark. */
export async function violations(page) {
  if (!await page.evaluate(() => "axe" in window)) await page.evaluate(axe);
  const all = [];
  for (const [colorScheme, rules] of [["dark", {}], ["light", {runOnly: ["color-contrast", "link-in-text-block"]}]]) {
    await page.emulateMedia({colorScheme});
    const run = async (options) => (await window.axe.run(document, options)).violations;
    for (const {id: rule, help, nodes} of await page.evaluate(run, {resultTypes: ["violations"], ...rules})) {
      all.push(`${colorScheme}: ${rule}: ${help}: ${nodes.slice(0, 3).map(({target}) => target.join(" ")).join("; ")}`);
    }
  }
  return all;
}
