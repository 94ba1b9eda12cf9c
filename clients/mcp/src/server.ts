// Serves the tools and resources over the Model Context Protocol.
import {Server} from "@modelcontextprotocol/sdk/server/index.js";
import {
  CallToolRequestSchema, ErrorCode, ListResourcesRequestSchema, ListToolsRequestSchema, McpError, ReadResourceRequestSchema, type CallToolResult,
} from "@modelcontextprotocol/sdk/types.js";
import {kinds, namesOf, textOf, type Kind} from "./library";
import {Refusal, unknownName} from "./refusal";
import type {Caller} from "./service";
import type {Input, Tool} from "./tools/tool";

const instructions = `Pelage grooms fur. A scene holds a 3D model and its fur. Commands such as comb, blow, length and paint change the fur; every change is an undo step.
A typical session: \`create_scene\` or \`list_scenes\`; \`views\` to see all sides; \`pick\` at pixels to get positions on the surface; \`describe_commands\` for what commands take;
\`preview_change\` or dry_run to see what a change would do; \`run_commands\`; \`look\`; \`undo\` if it looks wrong.
Lengths are fractions of the model's size (its box's diagonal) unless \`units\` says otherwise. Positions are in the model's own coordinates: y up, the model faces +z.
Brush commands take a stroke, or "flood": true for everywhere.`;

/** Uses the low-level Server, as the schemas come from the contract; McpServer takes only schemas written in code. */
export function mcpServer(version: string, tools: Map<string, Tool>): Server {
  const server = new Server({name: "pelage", version}, {capabilities: {tools: {}, resources: {}}, instructions});
  server.setRequestHandler(ListToolsRequestSchema, () => ({
    tools: [...tools.values()].map(({name, description, inputSchema, annotations}) => ({name, description, inputSchema, annotations})),
  }));
  server.setRequestHandler(CallToolRequestSchema, ({params}, {signal, sendNotification}) => {
    const tool = tools.get(params.name);
    if (!tool) throw new McpError(ErrorCode.InvalidParams, `There is no tool "${params.name}".`);
    const progressToken = params._meta?.progressToken;
    const progress = async (done: number, total: number) => {
      if (progressToken !== undefined) await sendNotification({method: "notifications/progress", params: {progressToken, progress: done, total}});
    };
    return call(tool, params.arguments ?? {}, {signal, progress, author: server.getClientVersion()?.name ?? "agent"});
  });
  server.setRequestHandler(ListResourcesRequestSchema, async () => ({resources: await resources()}));
  server.setRequestHandler(ReadResourceRequestSchema, async ({params}) => ({contents: [await read(params.uri)]}));
  return server;
}

/** Runs a tool. Returns a refusal as a result, not as a protocol error, so that the agent can read it and act on it. */
async function call(tool: Tool, input: Input, caller: Caller): Promise<CallToolResult> {
  try {
    refuseUnknown(tool, input);
    return await tool.run(input, caller);
  } catch (error) {
    const refusal = error instanceof Refusal ? error : new Refusal({detail: `pelage-mcp failed: ${String(error)}`}, "Call again; if it recurs, report it.");
    return {content: [{type: "text", text: refusal.text()}], structuredContent: {problem: refusal.problem}, isError: true};
  }
}

/** Refuses unknown top-level members; the Pelage server checks the nested ones. */
function refuseUnknown({name, inputSchema}: Tool, input: Input) {
  const known = Object.keys(inputSchema.properties);
  const unknown = Object.keys(input).find((member) => !known.includes(member));
  if (unknown !== undefined) throw unknownName(`"${unknown}" is not known to ${name}.`, `/${unknown}`, unknown, known);
}

const scheme = "pelage://";
const mimeType = "application/json";

async function resources() {
  const all = await Promise.all(kinds.map(async (kind) => (await namesOf(kind)).map((name) => ({
    uri: `${scheme}${kind}/${name}`, name, mimeType,
    description: kind === "looks" ? "Commands of the look; apply_look runs them." : "Steps of the recipe; run_recipe runs them.",
  }))));
  return all.flat();
}

async function read(uri: string) {
  const [kind, name] = uri.startsWith(scheme) ? uri.slice(scheme.length).split("/") : [];
  if (!kinds.includes(kind as Kind) || name === undefined)
    throw new McpError(ErrorCode.InvalidParams, `There is no resource "${uri}"; there are pelage://looks/NAME and pelage://recipes/NAME.`);
  try {
    return {uri, mimeType, text: await textOf(kind as Kind, name)};
  } catch (error) {
    if (error instanceof Refusal) throw new McpError(ErrorCode.InvalidParams, `${error.message} There are ${error.problem.limit}.`);
    throw error;
  }
}
