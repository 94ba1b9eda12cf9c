// Parses the program's command line and environment.
import {parseArgs} from "node:util";

export const usage = `usage: pelage-mcp [--server URL] [--token SECRET] [--toolsets NAMES | --tools NAMES]

A Model Context Protocol server on standard input and output, for agents that groom fur on a Pelage server.

  --server URL     address of pelaged [PELAGE_SERVER, else http://127.0.0.1:8080]
  --token SECRET   its token [PELAGE_TOKEN, which other users of the machine cannot read]
  --toolsets NAMES sets of tools, with commas [scenes,pictures,changes,history]; commands has a tool for each command, all
                   has everything
  --tools NAMES    only these tools, of any set, for clients that take few: comb,look,views,undo
  --help           this text`;

export interface Options {
  server: string;
  token: string | undefined;
  toolsets: string[] | undefined;
  /** If undefined, all tools of the toolsets. */
  tools: string[] | undefined;
  help: boolean;
}

/** Throws an Error if an option is wrong. */
export function readOptions(words: string[], environment: NodeJS.ProcessEnv): Options {
  const text = {type: "string"} as const;
  const {values} = parseArgs({args: words, options: {server: text, token: text, toolsets: text, tools: text, help: {type: "boolean"}}});
  const server = values.server ?? environment["PELAGE_SERVER"] ?? "http://127.0.0.1:8080";
  if (!/^https?:\/\/./.test(server)) throw new Error(`The server "${server}" is no address; write it as http://127.0.0.1:8080.`);
  return {
    server: server.replace(/\/+$/, ""),
    token: values.token ?? environment["PELAGE_TOKEN"],
    toolsets: namesIn(values.toolsets), tools: namesIn(values.tools),
    help: values.help ?? false,
  };
}

const namesIn = (list: string | undefined) => list?.split(",").map((name) => name.trim()).filter(Boolean);
