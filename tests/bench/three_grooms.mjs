// Times three grooms made from scratch in the studio alone: a terrier, a lion and a wet otter. Uses a real Chromium and a real server.
// Run by hand; prints when each step was done, and writes a traced picture of each animal.
// usage: node three_grooms.mjs FOLDER [NAME...]    from tests/bench, with PELAGE_BIN
import {writeFileSync} from "node:fs";
import {join} from "node:path";
import {Server} from "../studio/support/server.mjs";
import {Studio, browser} from "../studio/support/studio.mjs";

const [folder, ...only] = process.argv.slice(2);

/** A user of the studio, working on one animal. */
class Groomer {
  constructor(server, studio, id) {
    Object.assign(this, {server, studio, page: studio.page, id, started: Date.now()});
  }
  static async begin(server, chrome, name) {
    const {id} = await server.creature(name, 8000);
    const studio = await Studio.open(chrome, server.address, {scene: id, context: {viewport: {width: 1440, height: 900}}, kept: {dial: {kind: "tier", tier: "interactive"}}});
    await studio.ready();
    await studio.page.keyboard.press("x");
    return new Groomer(server, studio, id);
  }
  say(what) { console.log(`${String(Math.round((Date.now() - this.started) / 1000)).padStart(4)} s  ${what}`); }
  async look(key) {
    await this.page.locator(".surface").focus();
    await this.page.keyboard.press(key);
    await this.page.waitForTimeout(2500);
    await this.studio.seen("rest");
  }
  async tool(name) { await this.studio.tool(name); await this.studio.panel("Tool"); }
  async preset(name) { await this.page.getByRole("button", {name, exact: true}).click(); }
  async everywhere(side) {
    const button = side ? this.page.getByRole("group", {name: /everywhere$/}).getByRole("button", {name: side}) : this.page.getByRole("button", {name: /everywhere$/});
    await button.click();
    await this.page.waitForTimeout(500);
  }
  async size(steps) {
    await this.page.mouse.move(...await this.studio.at(0.5, 0.5));
    for (let k = 0; k < Math.abs(steps); ++k) await this.page.keyboard.press(steps > 0 ? "]" : "[");
  }
  async strokes(...strokes) { for (const points of strokes) await this.studio.drag(points, {steps: 14}); }
  async number(label, value) {
    const field = this.page.locator(".panel .row", {hasText: label}).first().locator('input[type="number"]');
    await field.fill(String(value));
    await field.press("Enter");
  }
  async colour(hex) {
    await this.page.locator(".panel .colour-button").first().click();
    const field = this.page.locator(".colour-card:popover-open").locator('input[type="text"]');
    await field.fill(hex);
    await field.press("Enter");
    await this.page.keyboard.press("Escape");
  }
  async coatColours() {
    await this.studio.panel("Coat");
    await this.page.getByRole("button", {name: "Show the coat's colours"}).click();
  }
  async finish(name) {
    await this.look("Home");
    this.say("done");
    const body = {width: 900, height: 900, camera: {auto: "three_quarter"}, background: "studio", quality: {method: "strands", trace: {passes: 32}}};
    const answer = await fetch(`${this.server.address}/v1/scenes/${this.id}/frames`, {method: "POST", headers: {"Content-Type": "application/json"}, body: JSON.stringify(body)});
    writeFileSync(join(folder, `${name}.png`), Buffer.from(await answer.arrayBuffer()));
    this.say("traced");
    this.studio.quiet();
    await this.studio.context.close();
  }
}

/** Long hair that hangs, a parting along the back, bangs and a beard. */
async function terrier(hand) {
  await hand.coatColours();
  await hand.number("Width root", 0.0006);
  await hand.number("Length spread", 0.15);
  await hand.tool("length");
  await hand.preset("Short"), await hand.everywhere(), await hand.preset("Long");
  await hand.look("4"), await hand.size(5);
  await hand.strokes([[0.34, 0.5], [0.45, 0.5], [0.58, 0.5], [0.66, 0.52]], [[0.34, 0.6], [0.45, 0.6], [0.58, 0.6], [0.66, 0.6]],
    [[0.36, 0.64], [0.37, 0.78]], [[0.62, 0.64], [0.61, 0.78]], [[0.72, 0.58], [0.83, 0.42], [0.83, 0.32]]);
  await hand.size(-4);
  await hand.strokes([[0.16, 0.43], [0.19, 0.44], [0.24, 0.42]]);
  hand.say("lengths");
  await hand.tool("comb"), await hand.everywhere("Down");
  hand.say("hangs");
  await hand.look("5"), await hand.tool("part"), await hand.size(3);
  await hand.strokes([[0.5, 0.7], [0.5, 0.5], [0.5, 0.3]]);
  hand.say("parting");
  await hand.look("1"), await hand.tool("length"), await hand.preset("Long");
  await hand.strokes([[0.5, 0.235], [0.46, 0.24]]);
  await hand.tool("comb");
  await hand.strokes([[0.49, 0.2], [0.475, 0.27], [0.46, 0.36]], [[0.46, 0.2], [0.445, 0.27], [0.43, 0.36]]);
  hand.say("bangs");
}

/** A short coat with a long dark mane, and a tuft at the tail. */
async function lion(hand) {
  await hand.coatColours();
  await hand.tool("length"), await hand.preset("Short"), await hand.everywhere();
  await hand.tool("comb"), await hand.everywhere("Back");
  hand.say("short, combed back");
  const mane = [[[0.315, 0.22], [0.33, 0.3], [0.33, 0.4], [0.3, 0.5], [0.3, 0.58]], [[0.37, 0.4], [0.36, 0.48], [0.36, 0.58]]], tuft = [[0.77, 0.3], [0.82, 0.29]];
  await hand.look("4"), await hand.tool("length"), await hand.preset("Long"), await hand.size(2);
  await hand.strokes(...mane, [[0.275, 0.46], [0.28, 0.56]], tuft);
  await hand.look("1");
  await hand.strokes([[0.5, 0.19], [0.45, 0.2]], [[0.5, 0.56], [0.45, 0.54]]);
  hand.say("mane and tuft");
  await hand.look("4"), await hand.tool("comb");
  await hand.strokes([[0.29, 0.24], [0.34, 0.27], [0.37, 0.36]], [[0.3, 0.36], [0.35, 0.42], [0.38, 0.52]], [[0.28, 0.46], [0.31, 0.54], [0.33, 0.64]], [[0.25, 0.5], [0.26, 0.58], [0.28, 0.66]]);
  hand.say("mane combed");
  await hand.tool("paint");
  for (const [preset, hex] of [["Colour", "#6b3f1c"], ["Root colour", "#2c1a0e"]]) {
    await hand.preset(preset), await hand.colour(hex);
    await hand.strokes(...mane, tuft);
  }
  hand.say("mane dark");
}

/** Short wet fur in fine points, with a pale throat. */
async function otter(hand) {
  await hand.studio.panel("Coat");
  await hand.page.getByRole("button", {name: "Wet dog"}).first().click();
  await hand.page.locator("summary", {hasText: "Clumps and tufts"}).click();
  await hand.number("Count", 12000), await hand.number("Clump size", 0.006), await hand.number("Fine clump size", 0.003);
  hand.say("wet");
  await hand.tool("length"), await hand.preset("Short"), await hand.everywhere();
  await hand.tool("comb"), await hand.everywhere("Back");
  hand.say("short, combed back");
  await hand.look("1"), await hand.tool("paint"), await hand.preset("Colour"), await hand.colour("#e2d2b8"), await hand.size(1);
  await hand.strokes([[0.5, 0.47], [0.49, 0.55], [0.48, 0.64]]);
  hand.say("pale throat");
}

const server = await Server.start();
const chrome = await browser();
try {
  for (const animal of [terrier, lion, otter]) {
    if (only.length > 0 && !only.includes(animal.name)) continue;
    console.log(animal.name);
    const hand = await Groomer.begin(server, chrome, animal.name);
    await animal(hand);
    await hand.finish(animal.name);
  }
} finally {
  await chrome.close();
  await server.stop();
}
