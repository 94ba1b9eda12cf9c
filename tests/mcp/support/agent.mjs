// A scripted agent: it knows the Model Context Protocol and what the tools say of themselves, and nothing of Pelage.
import assert from "node:assert/strict";
import {after, before} from "node:test";
import {Server} from "../../studio/support/server.mjs";
import {Ajv, Client, StdioClientTransport, decode} from "./packages.mjs";

export const program = process.env.PELAGE_MCP ?? new URL("../../../build/release/clients/mcp/dist/pelage-mcp.js", import.meta.url).pathname;

const ajv = new Ajv({strict: false});  // one for all: each new one takes longer to start than to check

export class Agent {
  static async start(...words) {
    const agent = new Agent();
    agent.client = new Client({name: "scripted agent", version: "1.0.0"});
    await agent.client.connect(new StdioClientTransport({command: process.execPath, args: [program, ...words], stderr: "ignore"}));
    agent.tools = new Map((await agent.client.listTools()).tools.map((tool) => [tool.name, tool]));
    return agent;
  }

  stop() { return this.client.close(); }

  /** A call whose input its schema allows, as careful clients check before they send. */
  async call(name, input = {}) {
    assert.ok(ajv.validate(this.tools.get(name).inputSchema, input), `${name}: ${ajv.errorsText()}`);
    const answer = await this.send(name, input);
    assert.ok(!answer.isError, `${name}: ${answer.text}`);
    return answer;
  }

  /** A call that has to be refused. */
  async refused(name, input) {
    const answer = await this.send(name, input);
    assert.ok(answer.isError, `${name} was not refused: ${answer.text}`);
    return {text: answer.text, ...answer.data.problem};
  }

  async send(name, input) {
    const {content, structuredContent: data, isError = false} = await this.client.callTool({name, arguments: input});
    const image = content.find(({type}) => type === "image");
    return {isError, data, image, text: content.filter(({type}) => type === "text").map(({text}) => text).join("\n")};
  }
}

export const pixelsOf = ({mimeType, data}) => {
  assert.equal(mimeType, "image/png");
  return decode(Buffer.from(data, "base64"));
};

export let server, agent;

/** Called once, at the top of a test file: a server and an agent of its own. `prepare` runs when both are there. */
export function start(prepare = async () => {}, words = ["--toolsets", "all"]) {
  before(async () => {
    server = await Server.start(["--gl", "none"]);
    agent = await Agent.start("--server", server.address, ...words);
    await prepare();
  });
  after(async () => {
    await agent?.stop();
    await server?.stop();
  });
}

/** Makes a scene of a small model. Its one step is a coat of so few strands that pictures of it take no time. */
export async function thinScene(name, builtin, triangles) {
  await agent.call("create_scene", {name, model: {builtin, triangles}});
  await agent.call("run_commands", {scene: name, commands: [{op: "set_coat", coat: {count: 500}}]});
}
