// Reads schemas and commands from the server's contract, and makes them self-contained for tool inputs.

/** The parts of JSON Schema that this program reads. */
export interface Schema { [keyword: string]: unknown; description?: string; properties?: Record<string, Schema>; required?: string[] }
/** The input schema of a tool; MCP clients want a plain object at the top level. */
export interface InputSchema extends Schema { type: "object"; properties: Record<string, Schema> }

export interface Contract { components: {schemas: Record<string, Schema>} }

const schema_prefix = "#/components/schemas/";
/** Keywords for rules between members. Many clients reject them at the top level of a tool's input, so the rules go into
 * the tool's description. */
const rule_keywords = ["oneOf", "anyOf", "allOf", "not", "if", "then", "else", "dependentRequired"];

export class Schemas {
  constructor(private readonly contract: Contract) {}

  named(name: string): Schema {
    const schema = this.contract.components.schemas[name];
    if (!schema) throw new Error(`The server's contract has no "${name}": it is of another version than pelage-mcp.`);
    return schema;
  }

  /** Returns the values of an enumeration. */
  words(name: string): string[] {
    return this.named(name)["enum"] as string[];
  }

  /** Returns the schemas of all commands by their `op`. */
  commands(): Map<string, Schema> {
    const {mapping} = this.named("Command")["discriminator"] as {mapping: Record<string, string>};
    return new Map(Object.entries(mapping).map(([op, reference]) => [op, this.named(nameIn(reference))]));
  }

  /** Returns the schemas of the `wanted` members of the schema `name`. */
  members(name: string, wanted: string[]): Record<string, Schema> {
    const all = this.named(name).properties ?? {};
    return Object.fromEntries(Object.entries(all).filter(([member]) => wanted.includes(member)));
  }

  /** Returns the schema of an object with these members; all schemas that they reference are under $defs. */
  input(properties: Record<string, Schema>, required: string[]): InputSchema {
    const definitions = new Map<string, Schema>();
    const own = this.withLocalReferences(properties, definitions) as Record<string, Schema>;
    return {
      type: "object", properties: own, required, additionalProperties: false,
      ...(definitions.size > 0 ? {$defs: Object.fromEntries(definitions)} : {}),
    };
  }

  /** Returns a copy whose references point to $defs, and adds the referenced schemas to `definitions`. */
  private withLocalReferences(value: unknown, definitions: Map<string, Schema>): unknown {
    if (Array.isArray(value)) return value.map((one) => this.withLocalReferences(one, definitions));
    if (typeof value !== "object" || value === null) return value;
    return Object.fromEntries(Object.entries(value).map(([key, one]) => {
      if (key !== "$ref" || typeof one !== "string") return [key, this.withLocalReferences(one, definitions)];
      this.define(nameIn(one), definitions);
      return [key, one.replace(schema_prefix, "#/$defs/")];
    }));
  }

  private define(name: string, definitions: Map<string, Schema>) {
    if (definitions.has(name)) return;
    definitions.set(name, {});  // set before resolving its references, which may be cyclic
    definitions.set(name, this.withLocalReferences(this.named(name), definitions) as Schema);
  }
}

/** Returns "Brush" for "#/components/schemas/Brush/properties/radius". */
const nameIn = (reference: string) => reference.slice(schema_prefix.length).split("/")[0]!;

/** Returns the rules between a schema's members as text for a description; "" if there are none. */
export function rulesOf(schema: Schema): string {
  const rules = Object.fromEntries(rule_keywords.filter((keyword) => keyword in schema).map((keyword) => [keyword, schema[keyword]]));
  return Object.keys(rules).length === 0 ? "" : `Rules between members, as JSON Schema: ${JSON.stringify(rules)}`;
}
