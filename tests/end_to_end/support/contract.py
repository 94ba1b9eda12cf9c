"""The contract that the build makes, and validators of its schemas."""

import functools
import json

import jsonschema

from support.server import BIN

CONTRACT = json.loads((BIN / "openapi.json").read_text())
SCHEMAS = CONTRACT["components"]["schemas"]


def validator(schema):
    return jsonschema.Draft202012Validator({**schema, "components": CONTRACT["components"]})


@functools.cache  # a new one resolves all references again, which takes longer than to validate
def named(name):
    return validator({"$ref": f"#/components/schemas/{name}"})
