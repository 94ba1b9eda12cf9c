// Care: labels, contrast and keyboard in both colours of the page, small windows, and a page that is light.
import assert from "node:assert/strict";
import {readFileSync} from "node:fs";
import {createRequire} from "node:module";
import {after, before, test} from "node:test";
import {Server} from "./support/server.mjs";
import {Studio, browser} from "./support/studio.mjs";

const axe = readFileSync(createRequire(import.meta.url).resolve("axe-core/axe.min.js"), "utf8");
const max_page_bytes = 150000;  // compressed, as the browser gets it

let server, chrome, id;

before(async () => {
  server = await Server.start();
  chrome = await browser();
  id = (await server.creature("care")).id;
});
after(async () => {
  await chrome?.close();
  await server?.stop();
});

/** What axe-core finds wrong, in words. */
async function violations(studio) {
  const found = await studio.page.evaluate(async () => (await window.axe.run(document, {resultTypes: ["violations"]})).violations);
  return found.map(({id: rule, help, nodes}) => `${rule}: ${help}: ${nodes.slice(0, 3).map(({target}) => target.join(" ")).join("; ")}`);
}

for (const colorScheme of ["dark", "light"]) {
  test(`axe finds nothing in any panel, ${colorScheme}`, async () => {
    // The page's policy forbids scripts that are put in; the test needs one.
    const studio = await Studio.open(chrome, server.address, {scene: id, context: {colorScheme, bypassCSP: true}});
    await studio.ready();
    await studio.page.addScriptTag({content: axe});
    const all = {};
    for (const tab of await studio.page.getByRole("tab").all()) {
      await tab.click();
      await studio.page.waitForTimeout(200);
      await studio.page.evaluate(() => { for (const group of document.querySelectorAll("details")) group.open = true; });
      await studio.page.waitForTimeout(200);
      all[await tab.getAttribute("aria-label")] = await violations(studio);
    }
    await studio.page.keyboard.press("?");
    all.shortcuts = await violations(studio);
    await studio.page.keyboard.press("Escape");
    assert.deepEqual(Object.entries(all).filter(([, list]) => list.length), []);
    studio.quiet();
    await studio.close();
  });
}

test("everything is reached by the keyboard, and a key sheet tells the keys", async () => {
  const studio = await Studio.open(chrome, server.address, {scene: id});
  await studio.ready();
  const seen = new Set();
  await studio.page.locator("body").press("Tab");
  for (let k = 0; k < 120; ++k) {
    const name = await studio.page.evaluate(() => document.activeElement?.getAttribute("aria-label") ?? document.activeElement?.textContent?.trim().slice(0, 30) ?? "");
    seen.add(name);
    await studio.page.keyboard.press("Tab");
  }
  for (const name of ["Comb", "Paint", "Shortcuts", "Front view", "Tool"]) assert.ok(seen.has(name), `${name} among ${[...seen].join(", ")}`);
  await studio.page.keyboard.press("?");
  await studio.page.getByRole("dialog", {name: "Shortcuts"}).waitFor();
  await studio.page.keyboard.press("Escape");
  await studio.page.getByRole("dialog", {name: "Shortcuts"}).waitFor({state: "detached"});
  studio.quiet();
  await studio.close();
});

test("at 1024 x 700 nothing is cut off and the picture is the largest part", async () => {
  const studio = await Studio.open(chrome, server.address, {scene: id, context: {viewport: {width: 1024, height: 700}}});
  await studio.ready();
  for (const tab of await studio.page.getByRole("tab").all()) {
    await tab.click();
    const wide = await studio.page.evaluate(() => [...document.querySelectorAll(".panel, .top-bar")].filter((one) => one.scrollWidth > one.clientWidth + 1).map((one) => `${one.className} ${one.scrollWidth} > ${one.clientWidth}`));
    assert.deepEqual(wide, [], await tab.getAttribute("aria-label"));
  }
  const {width} = await studio.page.locator(".viewport").boundingBox();
  assert.ok(width > 1024 * 0.6, `${width}`);
  studio.quiet();
  await studio.close();
});

test("the page is light, and what it needs comes from the server alone", async () => {
  const studio = await Studio.open(chrome, server.address, {scene: id});
  await studio.ready();
  const loads = await studio.page.evaluate(() => [...performance.getEntriesByType("navigation"), ...performance.getEntriesByType("resource")]
    .map(({name, encodedBodySize}) => ({name, encodedBodySize})));
  const own = loads.filter(({name}) => !name.includes("/v1/") && !name.startsWith("blob:") && !name.startsWith("data:"));
  const bytes = own.reduce((sum, {encodedBodySize}) => sum + encodedBodySize, 0);
  assert.ok(bytes > 10000 && bytes <= max_page_bytes, `${bytes} bytes: ${own.map(({name, encodedBodySize}) => `${name} ${encodedBodySize}`).join(", ")}`);
  assert.deepEqual(loads.filter(({name}) => name.startsWith("http") && !name.startsWith(server.address)), []);
  studio.quiet();
  await studio.close();
});
