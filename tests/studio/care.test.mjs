// Care: labels, contrast and keyboard in both colours of the page, small windows, and a page that is light.
import assert from "node:assert/strict";
import {test} from "node:test";
import {violations} from "./support/axe.mjs";
import {openStudio, server, start} from "./support/own.mjs";

const max_page_bytes = 150000;  // compressed, as the browser gets it

let id;
start({prepare: async () => { id = (await server.creature("care")).id; }});

test("axe finds nothing in any panel, dark or light", async () => {
  const studio = await openStudio({scene: id});
  await studio.ready();
  const all = {};
  for (const tab of await studio.page.getByRole("tab").all()) {
    await tab.click();
    await studio.page.waitForTimeout(200);
    await studio.page.evaluate(() => { for (const group of document.querySelectorAll("details")) group.open = true; });
    await studio.page.waitForTimeout(200);
    all[await tab.getAttribute("aria-label")] = await violations(studio.page);
  }
  await studio.page.locator(".surface").focus();  // a field that is typed in would take the key
  await studio.page.keyboard.press("?");
  all.shortcuts = await violations(studio.page);
  await studio.page.keyboard.press("Escape");
  assert.deepEqual(Object.entries(all).filter(([, list]) => list.length), []);
  await studio.finish();
});

test("everything is reached by the keyboard, and a key sheet lists the keys", async () => {
  const studio = await openStudio({scene: id});
  await studio.ready();
  const wanted = ["Comb", "Paint", "Shortcuts", "Front view", "Tool"], seen = new Set();
  await studio.page.locator("body").press("Tab");
  for (let k = 0; k < 120 && !wanted.every((name) => seen.has(name)); ++k) {
    const name = await studio.page.evaluate(() => document.activeElement?.getAttribute("aria-label") ?? document.activeElement?.textContent?.trim().slice(0, 30) ?? "");
    seen.add(name);
    await studio.page.keyboard.press("Tab");
  }
  for (const name of wanted) assert.ok(seen.has(name), `${name} among ${[...seen].join(", ")}`);
  await studio.page.locator(".surface").focus();  // a field that is typed in would take the key
  await studio.page.keyboard.press("?");
  await studio.page.getByRole("dialog", {name: "Shortcuts"}).waitFor();
  await studio.page.keyboard.press("Escape");
  await studio.page.getByRole("dialog", {name: "Shortcuts"}).waitFor({state: "detached"});
  await studio.finish();
});

test("at 1024 x 700 nothing is cut off and the picture is the largest part", async () => {
  const studio = await openStudio({scene: id});
  await studio.ready();
  for (const tab of await studio.page.getByRole("tab").all()) {
    await tab.click();
    const wide = await studio.page.evaluate(() => [...document.querySelectorAll(".panel, .top-bar")].filter((one) => one.scrollWidth > one.clientWidth + 1).map((one) => `${one.className} ${one.scrollWidth} > ${one.clientWidth}`));
    assert.deepEqual(wide, [], await tab.getAttribute("aria-label"));
  }
  const {width} = await studio.page.locator(".viewport").boundingBox();
  assert.ok(width > 1024 * 0.6, `${width}`);
  await studio.finish();
});

test("the page is light, and what it needs comes from the server alone", async () => {
  const studio = await openStudio({scene: id, alone: true});
  await studio.ready();
  const loads = await studio.page.evaluate(() => [...performance.getEntriesByType("navigation"), ...performance.getEntriesByType("resource")]
    .map(({name, encodedBodySize}) => ({name, encodedBodySize})));
  const own = loads.filter(({name}) => !name.includes("/v1/") && !name.startsWith("blob:") && !name.startsWith("data:"));
  const bytes = own.reduce((sum, {encodedBodySize}) => sum + encodedBodySize, 0);
  assert.ok(bytes > 10000 && bytes <= max_page_bytes, `${bytes} bytes: ${own.map(({name, encodedBodySize}) => `${name} ${encodedBodySize}`).join(", ")}`);
  assert.deepEqual(loads.filter(({name}) => name.startsWith("http") && !name.startsWith(server.address)), []);
  await studio.finish();
});

test("a number field holds what is allowed and gives the keyboard back", async () => {
  const studio = await openStudio({scene: id});
  await studio.ready();
  await studio.panel("Tool");
  const brush = (name) => studio.page.evaluate((name) => JSON.parse(localStorage.getItem("pelage.brush"))[name], name);
  const strength = studio.page.getByRole("spinbutton", {name: "Strength, as a number"}).first();
  await strength.fill("131");
  await strength.press("Enter");
  assert.equal(await brush("strength"), 1);
  assert.equal(await strength.inputValue(), "1");
  await studio.page.getByText("1 is the nearest allowed number.").waitFor();
  const radius = await brush("radius");
  await studio.page.keyboard.press("]");
  assert.ok(await brush("radius") > radius, "a key after Enter is a shortcut");
  await strength.fill("0.25");
  await strength.press("Escape");
  assert.equal(await brush("strength"), 1);
  assert.equal(await strength.inputValue(), "1");
  await studio.page.keyboard.press("[");
  assert.ok(Math.abs(await brush("radius") - radius) < 1e-3, "a key after Escape is a shortcut");
  await studio.finish();
});
