// A pelaged of its own for each test file, on a free port, that can be killed and started again on the same port.
import {spawn} from "node:child_process";
import {existsSync, mkdtempSync, openSync, readFileSync, rmSync} from "node:fs";
import {tmpdir} from "node:os";
import {join} from "node:path";
import {setTimeout as sleep} from "node:timers/promises";

export const bin = process.env.PELAGE_BIN ?? new URL("../../../build/release/bin", import.meta.url).pathname;
const start_seconds = 120;  // a loaded machine

export class Server {
  static async start(arguments_ = []) {
    const server = new Server();
    server.folder = mkdtempSync(join(tmpdir(), "pelage-studio-"));
    server.arguments = arguments_;
    server.port = 0;
    await server.run();
    return server;
  }

  /** Starts the program; after a kill on the same port. */
  async run() {
    const port_file = join(this.folder, "port");
    rmSync(port_file, {force: true});
    const log = openSync(join(this.folder, "log"), "a");
    this.process = spawn(join(bin, "pelaged"), ["--listen", `127.0.0.1:${this.port}`, "--port-file", port_file,
      "--data", join(this.folder, "data"), "--threads", "2", ...this.arguments], {stdio: ["ignore", log, log]});
    for (let waited = 0; !existsSync(port_file); waited += 0.05) {
      if (this.process.exitCode !== null || waited > start_seconds) throw new Error(`pelaged did not start: ${readFileSync(join(this.folder, "log"))}`);
      await sleep(50);
    }
    this.port = Number(readFileSync(port_file, "utf8"));
    this.address = `http://127.0.0.1:${this.port}`;
  }

  async kill() {
    const gone = new Promise((done) => this.process.once("exit", done));
    this.process.kill("SIGKILL");
    await gone;
  }

  async stop() {
    if (this.process.exitCode === null && this.process.signalCode === null) {
      const gone = new Promise((done) => this.process.once("exit", done));
      this.process.kill("SIGTERM");
      await gone;
    }
    rmSync(this.folder, {recursive: true, force: true});
  }

  async get(path) {
    const answer = await fetch(this.address + path);
    return answer.json();
  }

  async post(path, body, headers = {}) {
    const answer = await fetch(this.address + path, {method: "POST", body: JSON.stringify(body), headers: {"Content-Type": "application/json", ...headers}});
    if (!answer.ok) throw new Error(`${path}: ${answer.status} ${await answer.text()}`);
    return answer.json();
  }

  /** The same model for all tests: the server makes it once. */
  creature(name) {
    return this.post("/v1/scenes", {name, model: {builtin: "creature", triangles: 3000}});
  }
}
