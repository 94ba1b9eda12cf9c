// Our own rules for the contract: everything has a description that is a whole sentence or phrase, each request an example, and
// each number a unit.

/** First words of a fragment that needs something before it, such as "Of the file." */
const hanging = /^(of|that|which|whose|and|or|but|with|beside|at|over|to|as in|from the|from one)\b/i;
/** How a description may begin: a capital, a digit, a quote or a name; or enumeration values and a colon, as in "png and png16: ...". */
const begins = /^([A-Z0-9`"]|\w+(,? (and )?\w+)*: )/;

/** What is wrong with a description, or nothing. */
export function fault(text) {
  const words = text.trim();
  if (words === "") return "is empty";
  if (!begins.test(words)) return "does not begin with a capital, a number or a name";
  if (!/[.!?]$/.test(words)) return "does not end with a full stop";
  if (hanging.test(words)) return "begins in the middle of a sentence";
  if (words.split(/\s+/).length < 2) return "is a single word";
  if ((words.match(/`/g) ?? []).length % 2 === 1 || count(words, "(") !== count(words, ")")) return "has a mark without its partner";
  return undefined;
}
const count = (text, mark) => text.split(mark).length - 1;

/** Returns a schema and the objects that it is one of (oneOf), without the rules between its members. */
const forms = (schema) => [schema, ...(schema.oneOf ?? []).filter((one) => one.type === "object")];

/** Calls `check` for each member of each named schema, with the pointer to it. */
function each_member(root, check) {
  for (const [name, schema] of Object.entries(root.components.schemas)) {
    for (const form of forms(schema)) {
      const at = form === schema ? [name] : [name, "oneOf", schema.oneOf.indexOf(form)];
      for (const [member, own] of Object.entries(form.properties ?? {})) {
        if (typeof own === "object") check(own, ["components", "schemas", ...at, "properties", member]);
      }
    }
  }
}

function described() {
  const need = (node, names, {report, location}) => {
    for (const name of names) {
      if (!node[name]) report({message: `There is no ${name}.`, location: location.child([name]).key()});
    }
  };
  return {
    Operation: (node, context) => need(node, ["summary", "description"], context),
    Parameter: (node, context) => need(node, ["description"], context),
    Header: (node, context) => need(node, ["description"], context),
    Response: (node, context) => need(node, ["description"], context),
    Tag: (node, context) => need(node, ["description"], context),
    NamedSchemas: (node, {report, location}) => {
      for (const [name, schema] of Object.entries(node)) {
        if (!schema.description) report({message: `The schema ${name} has no description.`, location: location.child([name]).key()});
      }
    },
    Root: (root, {report, location, resolve}) => each_member(root, (member, at) => {
      const target = member.$ref ? resolve(member).node : member;
      if (!member.description && !target?.description) report({message: "The member has no description.", location: location.child(at).key()});
    }),
  };
}

function whole_sentences() {
  const visit = (name) => (node, {report, location}) => {
    const wrong = typeof node[name] === "string" && fault(node[name]);
    if (wrong) report({message: `The ${name} ${wrong}: ${node[name].trim().slice(0, 80)}`, location: location.child([name])});
  };
  const of = Object.fromEntries(["Info", "Tag", "Parameter", "Header", "Response", "Schema", "SecurityScheme"].map((type) => [type, visit("description")]));
  const both = (node, context) => { visit("summary")(node, context); visit("description")(node, context); };
  return {...of, Operation: both, Example: visit("summary")};
}

function exampled() {
  const has_one = (node) => node.example !== undefined || Object.keys(node.examples ?? {}).length > 0;
  return {
    RequestBody: (node, {report, location, resolve}) => {
      for (const [type, media] of Object.entries(resolve(node).node.content)) {
        if (!has_one(media)) report({message: `The request has no example as ${type}.`, location: location.child(["content", type])});
      }
    },
    Parameter: (node, {report, location}) => {
      if (node.required && !has_one(node)) report({message: `The parameter ${node.name} is required and has no example.`, location});
    },
  };
}

function measured() {
  const numbers = (schema) => [schema, schema.items, ...(schema.oneOf ?? [])].filter((one) => one?.type === "number");
  return {
    Root: (root, {report, location}) => each_member(root, (member, at) => {
      for (const number of numbers(member)) {
        if (!number["x-unit"]) report({message: "The number has no x-unit.", location: location.child(at)});
      }
    }),
  };
}

export const plugin = {id: "pelage", rules: {oas3: {described, "whole-sentences": whole_sentences, exampled, measured}}};
