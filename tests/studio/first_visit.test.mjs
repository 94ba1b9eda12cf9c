// The first visit, a server that wants a token, a lost connection, the dial, and no violation that axe finds in any of it.
import assert from "node:assert/strict";
import {test} from "node:test";
import {violations} from "./support/axe.mjs";
import {chrome, openStudio, server, serverWith, start} from "./support/own.mjs";
import {Studio} from "./support/studio.mjs";

start();

const accessible = async (page) => assert.deepEqual(await violations(page), []);

test("a first visit finds a fox and three hints, which go for good", async () => {
  const server = await serverWith();
  const studio = await Studio.open(chrome, server.address);
  await studio.page.evaluate(() => localStorage.removeItem("pelage.welcomed"));
  await studio.page.getByText(/Growing the creature's fur|Drawing the first picture/).waitFor();
  await studio.seen("rest");
  const scenes = async () => (await server.get("/v1/scenes")).scenes.filter(({name}) => !name.startsWith("studio: "));  // copies that it tries tools on
  assert.deepEqual((await scenes()).map(({name, model}) => [name, model]), [["Fox", "creature"]]);
  await studio.close();
  const second = await chrome.newContext({viewport: {width: 1440, height: 900}});  // Studio.open welcomes nobody
  const page = await second.newPage();
  await page.goto(server.address);
  await page.getByRole("region", {name: "First steps"}).waitFor();
  await accessible(page);
  await page.getByRole("button", {name: "Begin"}).click();
  await page.reload();
  await page.locator(".badge .dot").waitFor();
  assert.equal(await page.getByRole("region", {name: "First steps"}).count(), 0);
  assert.equal((await scenes()).length, 1);
  await second.close();
});

test("a server with a token is asked again once the token is given", async () => {
  const server = await serverWith("--token", "secret");
  const {id} = await server.post("/v1/scenes", {name: "sphere", model: {builtin: "sphere", triangles: 2000}}, {Authorization: "Bearer secret"});
  const studio = await Studio.open(chrome, server.address, {scene: id});
  studio.expected.push(/401/);
  const {page} = studio;
  const box = page.getByRole("dialog", {name: "The server's token"});
  await box.waitFor();
  await accessible(page);
  await box.getByLabel("Token").fill("wrong");
  await page.keyboard.press("Enter");
  await box.getByText("does not accept this token").waitFor();
  await box.getByLabel("Token").fill("secret");
  await page.keyboard.press("Enter");
  await studio.seen();
  assert.equal(await box.count(), 0);
  await page.reload();
  await studio.seen();
  assert.equal(await box.count(), 0);
  await studio.finish();
});

test("a lost connection and the stored changes are reported until it is back", async () => {
  const {id} = await server.creature("lost");
  const studio = await openStudio({scene: id});
  studio.expected.push(/Failed to load resource/, /ERR_/);
  await studio.ready();
  await server.kill();
  await studio.drag([[0.45, 0.5], [0.6, 0.45]]);
  await studio.page.locator(".offline", {hasText: "kept in this browser"}).waitFor();
  await accessible(studio.page);
  await server.run();
  await studio.settled(server, id, 1);
  await studio.page.locator(".offline").waitFor({state: "detached", timeout: 30000});
  await studio.finish();
});

test("the dial is chosen by keys, shows the time of its stops, and compares with the reference", async () => {
  const {id} = await server.creature("dial");
  const studio = await openStudio({scene: id, kept: {dial: {kind: "tier", tier: "interactive"}}});
  const {page} = studio;
  await page.setViewportSize({width: 1024, height: 480});  // fewer pixels to trace
  await studio.seen("rest");
  await page.getByRole("button", {name: /^Quality/}).focus();
  await page.keyboard.press("Enter");
  const stop = (name) => page.locator(".dial-stop", {hasText: name});
  await stop("Groom").getByText(/about \d/).waitFor();
  for (const name of ["Sketch", "Groom", "Beauty", "Final"]) await stop(name).locator("img").waitFor({timeout: 120000});
  await page.getByText("Limits and measurements").click();
  await page.locator(".dial-errors div", {hasText: "Groom"}).getByText(/error \.?\d/).waitFor();
  await accessible(page);
  await page.getByRole("radio", {name: /Groom/}).focus();
  await page.keyboard.press("ArrowUp");
  assert.ok(await page.getByRole("radio", {name: /Sketch/}).isChecked());
  await page.getByLabel("Milliseconds per picture").fill("800");
  await page.keyboard.press("Enter");
  await page.getByRole("button", {name: "Quality: 800 ms"}).waitFor();
  await stop("Time limit").getByText(/about \d/).waitFor({timeout: 120000});
  assert.deepEqual(await page.evaluate(() => JSON.parse(localStorage.getItem("pelage.dial"))), {kind: "budget", milliseconds: 800});
  await page.getByRole("button", {name: "Compare with Final"}).click();
  await page.getByRole("slider", {name: /Divider/}).waitFor({timeout: 400000});
  const divider = page.getByRole("slider", {name: /Divider/});
  await divider.focus();
  await page.keyboard.press("Shift+ArrowLeft");
  assert.equal(await divider.getAttribute("aria-valuenow"), "40");
  const mean = Number((await page.locator(".versus-report dd").first().textContent()).split(" ")[0]);
  assert.ok(mean > 0.001 && mean < 0.5, String(mean));
  for (const mode of ["Wipe", "Side by side", "Difference"]) {
    await page.getByRole("button", {name: mode}).click();
    await accessible(page);
  }
  await page.keyboard.press("Escape");
  assert.equal(await page.getByRole("dialog").count(), 0);
  await studio.finish();
});

test("the panel of files has no violation", async () => {
  const {id} = await server.creature("axe");
  const studio = await openStudio({scene: id});
  await studio.seen();
  await studio.panel("Files");
  for (const group of ["New scene from a built-in model", "Maps of the groom"]) await studio.page.getByText(group).click();
  await accessible(studio.page);
  await studio.page.getByRole("button", {name: "Remove axe", exact: true}).click();
  await accessible(studio.page);
  await studio.finish();
});

test("a browser that keeps nothing gets the studio all the same", async () => {
  const blocked = () => Object.defineProperty(window, "localStorage", {get() { throw new DOMException("denied", "SecurityError"); }});
  const {id} = await server.creature("blocked");
  const studio = await openStudio({scene: id, before: blocked});
  await studio.seen();
  assert.equal(await studio.page.locator(".message-error").count(), 0);
  await studio.finish();
});

test("an answer without a problem document is reported with its status and reason", async () => {
  const {id} = await server.creature("proxied");
  const studio = await openStudio({scene: id});
  studio.expected.push(/Failed to load resource/);
  await studio.seen();
  await studio.page.route("**/commands", (route) => route.fulfill({status: 403, contentType: "text/html", body: "<html>Forbidden</html>"}));
  await studio.page.keyboard.press("Control+i");
  await studio.page.getByText("The request was answered with 403: it is forbidden.").waitFor();
  await studio.finish();
});
