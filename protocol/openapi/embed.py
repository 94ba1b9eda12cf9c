"""Puts the schemas of requests and answers into the contract, as JSON and as a C++ source that holds it:
embed.py CONTRACT.yaml SCHEMAS.json OUTPUT.cpp OUTPUT.json"""

import json
import sys

import yaml

PIECE = 8000  # compilers bound the length of one string literal


def merged(contract, schemas):
    """What the contract says of a made schema is added to it, and may repeat nothing."""
    written = contract["components"]["schemas"]
    for name, schema in schemas.items():
        twice = schema.keys() & written.get(name, {}).keys()
        if twice:
            sys.exit(f"openapi.yaml repeats {sorted(twice)} of {name}, which protocol/json/schema.cpp makes")
        written[name] = {**schema, **written.get(name, {})}
    return contract


def parameters_of(contract, entry):
    """Query parameters for the members of a schema: {members: NAME, but: [those that the address has elsewhere]}."""
    schema = contract["components"]["schemas"][entry["members"]]
    for name in schema["properties"]:
        if name not in entry.get("but", []):
            required = {"required": True} if name in schema.get("required", []) else {}
            to = f"#/components/schemas/{entry['members']}/properties/{name}"
            yield {"name": name, "in": "query", **required, "schema": {"$ref": to}}


def with_parameters(contract):
    for methods in contract["paths"].values():
        for method in methods.values():
            if "parameters" in method:
                method["parameters"] = [one for entry in method["parameters"] for one in
                                        (parameters_of(contract, entry) if "members" in entry else [entry])]
    return contract


def main(source, schemas, target, document):
    with open(source, encoding="utf-8") as file:
        contract = yaml.safe_load(file)
    with open(schemas, encoding="utf-8") as file:
        text = json.dumps(with_parameters(merged(contract, json.load(file))), ensure_ascii=True, separators=(",", ":"))
    with open(document, "w", encoding="utf-8") as file:
        file.write(text)
    pieces = [text[i:i + PIECE] for i in range(0, len(text), PIECE)]
    lines = [f'    R"json~({piece})json~"' for piece in pieces]
    with open(target, "w", encoding="utf-8") as file:
        file.write('#include "protocol/openapi/openapi.h"\n\n#include <string>\n\nnamespace pelage {\n\n')
        file.write("namespace {\n\nconstexpr std::string_view pieces[] = {\n" + ",\n".join(lines) + "};\n\n")
        file.write("}  // namespace\n\nstd::string_view openapi_json() {\n  static const std::string text = [] {\n")
        file.write("    std::string joined;\n    for (const std::string_view piece : pieces) joined += piece;\n")
        file.write("    return joined;\n  }();\n  return text;\n}\n\n}  // namespace pelage\n")


if __name__ == "__main__":
    main(*sys.argv[1:])
