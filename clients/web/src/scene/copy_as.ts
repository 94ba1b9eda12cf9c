// Converts a step to text that runs it elsewhere: for `pelage`, curl, Python's standard library, or plain JSON.
import type {Command, Scene} from "../api/types";

export type CopyForm = "pelage" | "curl" | "python" | "json";
export const copy_forms: {form: CopyForm; label: string}[] = [
  {form: "pelage", label: "Command line"}, {form: "curl", label: "curl"}, {form: "python", label: "Python"}, {form: "json", label: "JSON"},
];

export interface CopyFrom {
  commands: Command[];
  scene: Pick<Scene, "id" | "name">;
  /** Address of the server: "http://127.0.0.1:8080". */
  origin: string;
  /** True if the server needs a token; the token itself is never copied. */
  needs_token: boolean;
}

/** Returns a request body in one line, so that no line of it can end a here-document. */
const bodyOf = (commands: Command[]) => JSON.stringify(commands.length === 1 ? commands[0] : {commands});
/** Returns a step as one line of JSON, as in the log and for `pelage run`. */
const stepOf = (commands: Command[]) => JSON.stringify(commands.length === 1 ? commands[0] : commands);
/** Quotes text for a POSIX shell. */
export const quoted = (text: string) => (/^[\w@%+=:,./-]+$/.test(text) ? text : `'${text.replaceAll("'", "'\\''")}'`);

function asPelage({commands, scene, origin, needs_token}: CopyFrom): string {
  const token = needs_token ? ` --token "$PELAGE_TOKEN"` : "";
  return `pelage --server ${quoted(origin)}${token} run ${quoted(scene.name)} - <<'END'\n${stepOf(commands)}\nEND\n`;
}

function asCurl({commands, scene, origin, needs_token}: CopyFrom): string {
  const token = needs_token ? `  -H "Authorization: Bearer $PELAGE_TOKEN" \\\n` : "";
  return `curl ${quoted(`${origin}/v1/scenes/${scene.id}/commands`)} \\\n${token}  -H 'Content-Type: application/json' --data-binary @- <<'END'\n${bodyOf(commands)}\nEND\n`;
}

/** Returns a raw Python string literal. This is safe for JSON, which ends in a bracket and never has three quotes in a row. */
const pythonLiteral = (json: string) => `r"""${json}"""`;

function asPython({commands, scene, origin, needs_token}: CopyFrom): string {
  const headers = `{"Content-Type": "application/json"${needs_token ? `, "Authorization": "Bearer " + os.environ["PELAGE_TOKEN"]` : ""}}`;
  return `import json
${needs_token ? "import os\n" : ""}import urllib.request

body = json.loads(${pythonLiteral(bodyOf(commands))})
request = urllib.request.Request(
    ${JSON.stringify(`${origin}/v1/scenes/${scene.id}/commands`)},
    json.dumps(body).encode(), headers=${headers})
with urllib.request.urlopen(request) as answer:
    print(json.load(answer)["revision"])
`;
}

export function copyText(form: CopyForm, from: CopyFrom): string {
  switch (form) {
    case "pelage": return asPelage(from);
    case "curl": return asCurl(from);
    case "python": return asPython(from);
    case "json": return `${JSON.stringify(from.commands.length === 1 ? from.commands[0] : from.commands, null, 2)}\n`;
  }
}
