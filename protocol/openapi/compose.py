"""Adds the schemas of requests and answers and the examples to the contract, and writes it as one line of JSON to each folder:
compose.py CONTRACT.yaml EXAMPLES.yaml SCHEMAS.json FOLDER..."""

import json
import pathlib
import sys

import yaml


def merged(contract, schemas):
    """Merges the generated schemas into those of the contract, which may not repeat any of their keys."""
    written = contract["components"]["schemas"]
    for name, schema in schemas.items():
        twice = schema.keys() & written.get(name, {}).keys()
        if twice:
            sys.exit(f"openapi.yaml repeats {sorted(twice)} of {name}, which protocol/json/schema.cpp makes")
        written[name] = {**schema, **written.get(name, {})}
    return contract


def parameters_of(contract, entry):
    """Query parameters for the members of a schema. `entry`: {members: NAME, but: [members to leave out]}."""
    schema = contract["components"]["schemas"][entry["members"]]
    for name in schema["properties"]:
        if name not in entry.get("but", []):
            required = {"required": True} if name in schema.get("required", []) else {}
            to = f"#/components/schemas/{entry['members']}/properties/{name}"
            words = description_of(contract, schema["properties"][name])
            yield {"name": name, "in": "query", **required, "description": words, "schema": {"$ref": to}}


def description_of(contract, schema):
    if "description" in schema:
        return schema["description"]
    return contract["components"]["schemas"][schema["$ref"].rsplit("/", 1)[1]]["description"]


def with_parameters(contract):
    for methods in contract["paths"].values():
        for method in methods.values():
            if "parameters" in method:
                method["parameters"] = [one for entry in method["parameters"] for one in
                                        (parameters_of(contract, entry) if "members" in entry else [entry])]
    return contract


def first_sentence(text):
    return text.split(". ")[0].rstrip(".") + "."


def with_examples(contract, examples):
    """Adds the examples: of commands to the request that runs them, of other schemas and requests to these themselves."""
    schemas, operations = contract["components"]["schemas"], examples["operations"]
    commands = {name.rsplit("/", 1)[1]: op for op, name in schemas["Command"]["discriminator"]["mapping"].items()}
    operations["runCommands"]["commands"] = {}
    for name, value in examples["schemas"].items():
        if name in commands:
            about = {"summary": first_sentence(schemas[name]["description"]), "value": value}
            operations["runCommands"]["commands"][commands.pop(name)] = about
        else:
            schemas[name]["examples"] = [value]
    if commands:
        sys.exit(f"examples.yaml has none of {sorted(commands)}")
    for path in contract["paths"].values():
        for method, operation in path.items():
            if method != "parameters":
                parameters = path.get("parameters", []) + operation.get("parameters", [])
                add_example(operation, parameters, operations.pop(operation["operationId"], {}))
    if operations:
        sys.exit(f"examples.yaml has {sorted(operations)}, which are no operations")
    return contract


def add_example(operation, parameters, example):
    for name, value in example.get("query", {}).items():
        next(one for one in parameters if one.get("name") == name)["example"] = value
    for media in operation.get("requestBody", {}).get("content", {}).values():
        if "commands" in example:
            batch = {"summary": "Several commands as one undo step.", "value": example["body"]}
            media["examples"] = {"batch": batch, **example["commands"]}
        elif "body" in example:
            media["example"] = example["body"]
        elif "file" in example:
            # Not `externalValue`: programs that bundle contracts would look for that file in their own file system.
            address = f"/docs/{example['file']}"
            media["examples"] = {"file": {"summary": f"A small file that the server has at {address}.", "value": f"(the bytes of {address})", "x-file": address}}


def read_yaml(path):
    with open(path, encoding="utf-8") as file:
        return yaml.safe_load(file)


def main(source, examples, schemas, *folders):
    with open(schemas, encoding="utf-8") as file:
        contract = with_parameters(merged(read_yaml(source), json.load(file)))
    text = json.dumps(with_examples(contract, read_yaml(examples)), ensure_ascii=True, separators=(",", ":"))
    for folder in folders:
        pathlib.Path(folder, "openapi.json").write_text(text, encoding="utf-8")


if __name__ == "__main__":
    main(*sys.argv[1:])
