// The violations that axe-core finds on a page, as text.
import {readFileSync} from "node:fs";
import {createRequire} from "node:module";

const axe = readFileSync(createRequire(import.meta.url).resolve("axe-core/axe.min.js"), "utf8");

/** Returns the violations in the dark and in the light theme; rules that do not depend on colours run in the dark one. */
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
