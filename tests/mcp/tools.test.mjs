// Tools as clients see them: each command of the contract, with a schema that stands by itself and is kept to.
import assert from "node:assert/strict";
import {test} from "node:test";
import {agent, server, start} from "./support/agent.mjs";
import {Ajv} from "./support/packages.mjs";

const ajv = new Ajv({strict: false});
let contract;
start(async () => {
  contract = await server.get("/openapi.json");
  await agent.call("create_scene", {name: "fox", model: {builtin: "sphere", triangles: 500}});
});

const commandNames = () => Object.keys(contract.components.schemas.Command.discriminator.mapping);

test("each command of the contract is a tool", () => {
  assert.ok(commandNames().length > 30);
  for (const name of commandNames()) {
    const {inputSchema} = agent.tools.get(name) ?? assert.fail(`no tool ${name}`);
    assert.ok("dry_run" in inputSchema.properties && inputSchema.required.includes("scene"), name);
  }
});

test("schemas are plain objects on top, hold all that they refer to, and say what they are for", () => {
  for (const {name, description, inputSchema, annotations} of agent.tools.values()) {
    assert.ok(description.length > 20, name);
    assert.equal(typeof annotations.readOnlyHint, "boolean", name);
    for (const keyword of ["oneOf", "anyOf", "allOf", "not", "if", "then", "else", "$ref"]) assert.ok(!(keyword in inputSchema), `${name} has ${keyword} on top`);
    assert.doesNotMatch(JSON.stringify(inputSchema) + description, /#\/components/, `${name} refers to the contract`);
    ajv.compile(inputSchema);
  }
});

/** The least that a schema asks for, with no knowledge of what it means. */
function filled(schema, root) {
  if (schema.$ref) return filled(schema.$ref.slice(2).split("/").reduce((at, step) => at[step], root), root);
  if ("const" in schema) return schema.const;
  if ("default" in schema) return schema.default;
  if (schema.enum) return schema.enum[0];
  if (schema.type === "object") return filledObject(schema, root);
  if (schema.oneOf) return filled(schema.oneOf[0], root);
  if (schema.type === "array") return Array.from({length: schema.minItems ?? 0}, () => filled(schema.items, root));
  if (schema.type === "string") return "x".repeat(schema.minLength ?? 0);
  if (schema.type === "boolean") return false;
  return Math.max(schema.minimum ?? 0, 0);
}

function filledObject(schema, root) {
  const choice = schema.oneOf?.[0] ?? schema.anyOf?.[0] ?? {};
  const names = [...(schema.required ?? []), ...(choice.required ?? [])];
  return Object.fromEntries(names.map((name) => [name, filled(schema.properties[name], root)]));
}

/** The rules between members that a description ends with, put back where they come from. */
function withRules({description, inputSchema}) {
  const [, rules] = /Rules between members, as JSON Schema: (.*)$/s.exec(description) ?? [];
  return {...inputSchema, ...JSON.parse(rules ?? "{}")};
}

test("what a schema and its rules allow, filled in blindly, is done or refused for a reason", async () => {
  let done = 0;
  for (const name of commandNames()) {
    const schema = withRules(agent.tools.get(name));
    const input = {...filled(schema, schema), scene: "fox", dry_run: true};
    const {isError, data, text} = await agent.send(name, input);
    if (!isError) ++done;
    else assert.ok([404, 422].includes(data.problem.status), `${name} ${JSON.stringify(input)}: ${text}`);
  }
  assert.ok(done > 25, `only ${done} were done`);
});
