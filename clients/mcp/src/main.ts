// pelage-mcp: reads the server's contract once, then answers MCP requests from standard input.
import {StdioServerTransport} from "@modelcontextprotocol/sdk/server/stdio.js";
import {version} from "../package.json";
import {Cameras} from "./cameras";
import {Schemas, type Contract} from "./contract";
import {readOptions, usage, type Options} from "./options";
import {mcpServer} from "./server";
import {Refusal} from "./refusal";
import {Service} from "./service";
import {toolsOf} from "./tools/index";

async function serve({server, token, toolsets, tools}: Options) {
  const service = new Service(server, token);
  const contract = await service.get<Contract>("/openapi.json", {signal: AbortSignal.timeout(30_000), author: "pelage-mcp", progress: async () => {}});
  const schemas = new Schemas(contract);
  const known = await toolsOf({service, schemas, cameras: new Cameras(schemas.words("AutoView"))}, toolsets, tools);
  await mcpServer(version, known).connect(new StdioServerTransport());
}

try {
  const options = readOptions(process.argv.slice(2), process.env);
  if (options.help) console.log(usage);
  else await serve(options);
} catch (error) {
  // Standard output is reserved for the protocol.
  console.error(`pelage-mcp: ${error instanceof Refusal ? error.text() : (error as Error).message}`);
  process.exitCode = 1;
}
