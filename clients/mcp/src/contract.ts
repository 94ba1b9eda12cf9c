// The contract as the server gives it: schemas that stand by themselves, and the commands.

/** JSON Schema, as far as it is looked into. */
export interface Schema { [keyword: string]: unknown; description?: string; properties?: Record<string, Schema>; required?: string[] }
/** The input of a tool: clients want a plain object on the top level. */
export interface InputSchema extends Schema { type: "object"; properties: Record<string, Schema> }

export interface Contract { components: {schemas: Record<string, Schema>} }

const schema_prefix = "#/components/schemas/";
/** Rules between members. Many clients refuse them on the top level of a tool's input, so they go into its description. */
const rule_keywords = ["oneOf", "anyOf", "allOf", "not", "if", "then", "else", "dependentRequired"];

export class Schemas {
  constructor(private readonly contract: Contract) {}

  named(name: string): Schema {
    const schema = this.contract.components.schemas[name];
    if (!schema) throw new Error(`The server's contract has no "${name}": it is of another version than pelage-mcp.`);
    return schema;
  }

  /** The words of an enumeration. */
  words(name: string): string[] {
    return this.named(name)["enum"] as string[];
  }

  /** Schemas of all commands, by their `op`. */
  commands(): Map<string, Schema> {
    const {mapping} = this.named("Command")["discriminator"] as {mapping: Record<string, string>};
    return new Map(Object.entries(mapping).map(([op, reference]) => [op, this.named(nameIn(reference))]));
  }

  /** The members of `name` that a tool takes over. */
  members(name: string, wanted: string[]): Record<string, Schema> {
    const all = this.named(name).properties ?? {};
    return Object.fromEntries(Object.entries(all).filter(([member]) => wanted.includes(member)));
  }

  /** An object with these members, and all that they refer to under $defs. */
  input(properties: Record<string, Schema>, required: string[]): InputSchema {
    const definitions = new Map<string, Schema>();
    const own = this.withLocalReferences(properties, definitions) as Record<string, Schema>;
    return {
      type: "object", properties: own, required, additionalProperties: false,
      ...(definitions.size > 0 ? {$defs: Object.fromEntries(definitions)} : {}),
    };
  }

  /** A copy that refers to $defs, which takes up what is referred to. */
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
    definitions.set(name, {});  // before its own references, which may come back to it
    definitions.set(name, this.withLocalReferences(this.named(name), definitions) as Schema);
  }
}

/** "Brush" of "#/components/schemas/Brush/properties/radius". */
const nameIn = (reference: string) => reference.slice(schema_prefix.length).split("/")[0]!;

/** The rules between members of a schema, in words for its description; "" where it has none. */
export function rulesOf(schema: Schema): string {
  const rules = Object.fromEntries(rule_keywords.filter((keyword) => keyword in schema).map((keyword) => [keyword, schema[keyword]]));
  return Object.keys(rules).length === 0 ? "" : `Rules between members, as JSON Schema: ${JSON.stringify(rules)}`;
}
