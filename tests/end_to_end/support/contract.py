"""The contract that the build makes, and validators of its schemas."""

import functools
import json

import jsonschema

from support.server import BIN

CONTRACT = json.loads((BIN / "openapi.json").read_text())
SCHEMAS = CONTRACT["components"]["schemas"]
# The names of the commands' schemas, by their ops.
COMMANDS = {SCHEMAS[one["$ref"].rsplit("/", 1)[1]]["properties"]["op"]["const"]: one["$ref"].rsplit("/", 1)[1] for one in SCHEMAS["Command"]["oneOf"]}


def validator(schema):
    return jsonschema.Draft202012Validator({**schema, "components": CONTRACT["components"]})


@functools.cache  # a new one resolves all references again, which takes longer than to validate
def named(name):
    return validator({"$ref": f"#/components/schemas/{name}"})
