// The official client and what checks its answers, from the packages of the program under test: one lock file for both.
const from = (path) => import(new URL(`../../../clients/mcp/node_modules/${path}`, import.meta.url).href);

export const {Client} = await from("@modelcontextprotocol/sdk/dist/esm/client/index.js");
export const {StdioClientTransport} = await from("@modelcontextprotocol/sdk/dist/esm/client/stdio.js");
export const {decode} = await from("fast-png/lib/index.js");
export const Ajv = (await from("ajv/dist/2020.js")).default.default;
