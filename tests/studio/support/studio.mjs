// A real Chromium with the studio in it, and the moves of a user's hand.
import assert from "node:assert/strict";
import {chromium} from "playwright-core";

const executablePath = process.env.PELAGE_CHROMIUM ?? "/usr/bin/chromium";

export async function browser(options = {}) {
  // Chromium's own sandbox does not work for root, which CI is.
  const args = process.getuid() === 0 ? ["--no-sandbox"] : [];
  return chromium.launch({executablePath, args: [...args, "--disable-dev-shm-usage"], ...options});
}

const blank = "/blank-for-tests";  // a page of the server's origin without the studio; the server is not asked for it
const viewport = {width: 1024, height: 700};

// Pictures that two busy cores draw soon, unless the test is about others.
const settings = {welcomed: true, dial: {kind: "tier", tier: "draft"}, "trace-at-rest": false};

/** Runs in the page: collects the studio's events for tests. */
function collectEvents() {
  window.marks = {frame: [], part: [], ring: [], palette: [], proxy: []};
  for (const name of Object.keys(window.marks)) addEventListener(`pelage:${name}`, ({detail}) => window.marks[name].push(detail));
}

/** Runs in a page of the server: the browser has stored these settings and nothing else. */
function store(values) {
  try {
    localStorage.clear();
    sessionStorage.clear();
    for (const [name, value] of Object.entries(values)) localStorage.setItem(`pelage.${name}`, JSON.stringify(value));
  } catch { /* this browser stores nothing */ }
}

/** One window on a scene. Everything that the console says is recorded, and is to be nothing at the end. */
export class Studio {
  /** Opens a new window. */
  static async open(chrome, address, {context = {}, ...shown} = {}) {
    const studio = new Studio();
    studio.address = address;
    studio.context = await chrome.newContext({viewport, acceptDownloads: true, reducedMotion: "reduce", ...context});
    await studio.context.addInitScript(collectEvents);
    studio.page = await studio.context.newPage();
    await studio.goBlank();
    await studio.show(shown);
    return studio;
  }

  /** Goes to the blank page. No route stays after it: with one the browser caches nothing. */
  async goBlank() {
    await this.page.route(`**${blank}`, (route) => route.fulfill({contentType: "text/html", body: '<link rel="icon" href="data:,">'}));
    await this.page.goto(this.address + blank);
    await this.page.unrouteAll({behavior: "ignoreErrors"});
  }

  /** Shows a scene in this window, where the blank page is, with the default settings and those of `kept`.
   * `before` runs in the page before the studio does. */
  async show({scene = "", kept = {}, before = () => {}} = {}) {
    this.before = await this.page.addInitScript(before);
    await this.page.evaluate(store, {...settings, ...kept});
    this.said = [];
    this.expected = [];
    this.page.on("console", (message) => { if (["error", "warning"].includes(message.type())) this.said.push(`${message.type()}: ${message.text()} ${message.location().url ?? ""}`.trim()); });
    this.page.on("pageerror", (error) => this.said.push(`thrown: ${error.message}`));
    await this.page.goto(`${this.address}/${scene ? `?scene=${scene}` : ""}`);
  }

  /** Leaves the studio's page, so that another test can use the window. */
  async leave() {
    this.page.removeAllListeners();
    await this.before.dispose();
    await this.page.setViewportSize(viewport);
    await this.page.emulateMedia({colorScheme: null});
    await this.page.mouse.move(0, 0);
    await this.goBlank();
  }

  /** Waits until a picture of the stage is seen ("draft" counts as any). */
  async seen(stage = "draft") {
    const classes = {draft: ".dot", rest: ".dot-rest, .dot-traced", traced: ".dot-traced"}[stage];
    await this.page.locator(`.badge :is(${classes})`).waitFor({timeout: 90000});
  }

  /** Waits until the brush can find the model: a press in the middle would groom. */
  async ready() {
    await this.seen();
    const [x, y] = await this.at(0.5, 0.5);
    await this.page.waitForFunction(() => window.marks.proxy.length > 0, null, {timeout: 60000});
    await this.page.mouse.move(x, y);
  }

  /** A position in the picture, as shares of its width and height, in the page's pixels. */
  async at(x, y) {
    const box = await this.page.locator(".surface").boundingBox();
    return [box.x + x * box.width, box.y + y * box.height];
  }

  /** Drags through positions given as shares of the picture. */
  async drag(positions, {button = "left", steps = 12} = {}) {
    const points = [];
    for (const [x, y] of positions) points.push(await this.at(x, y));
    await this.page.mouse.move(...points[0]);
    await this.page.mouse.down({button});
    for (const point of points.slice(1)) await this.page.mouse.move(...point, {steps});
    await this.page.mouse.up({button});
  }

  async tool(name) { await this.page.locator(`.palette [data-tool="${name}"]`).click(); }
  async panel(name) { await this.page.getByRole("tab", {name, exact: true}).click(); }

  /** Waits until the server's scene is at least at this revision and all changes are answered. */
  async settled(server, id, revision) {
    for (let tries = 0; tries < 600; ++tries) {
      const scene = await server.get(`/v1/scenes/${id}`);
      if (scene.revision >= revision) return scene;
      await this.page.waitForTimeout(50);
    }
    throw new Error(`the scene never came to revision ${revision}`);
  }

  /** The log of the console is empty, but for what the test says it expects. */
  quiet() {
    const unexpected = this.said.filter((line) => !this.expected.some((pattern) => pattern.test(line)));
    assert.deepEqual(unexpected, []);
  }

  async close() {
    await this.context.close();
  }

  /** The end of a test. */
  async finish() {
    this.quiet();
    await this.close();
  }
}
