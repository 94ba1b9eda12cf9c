"""schemas.py: a type for each schema of the contract."""

from generator.contract import VARIANTS, docstring, member_lines, named, on_lines, sentence, type_of, union

HEAD = '''"""Types of what is sent and answered, a TypedDict for each object of the contract. Made by generate.py.

Members that may be left out are those of classes with `total=False`. Lengths are in sizes, fractions of the diagonal of
the model's box, unless `units` says otherwise; positions are in the model's own coordinates.
"""

from __future__ import annotations

from typing import Any, Dict, Literal, Sequence, TypedDict, Union
'''

def schemas_module(contract):
    plain, objects, unions = [], [], []
    for name, schema in contract.schemas.items():
        if name in VARIANTS:
            for variant, one in zip(VARIANTS[name], schema["oneOf"]):
                objects += object_lines(contract, variant, one)
            unions.append(f"{name} = Union[{', '.join(VARIANTS[name])}]")
        elif "properties" in schema:
            objects += object_lines(contract, named(name), schema)
        elif "oneOf" in schema and any("$ref" in one for one in schema["oneOf"]):
            unions.append(alias(name, schema))
        else:
            plain += [alias(name, schema), *quoted(schema)]
    return "\n".join([HEAD, *plain, *objects, "", "", *unions, ""])


def alias(name, schema):
    if "oneOf" in schema:
        names = [type_of(one) for one in schema["oneOf"]]
        return on_lines(f"{name} = {union(names)}")
    return on_lines(f"{name} = {type_of(schema)}")


def quoted(schema):
    """Returns the description of an alias as a docstring below it."""
    words = sentence(schema.get("description", ""))
    return docstring(words, [], "") if words else []


def object_lines(contract, name, schema):
    """Returns the lines of a TypedDict; if only some members are required, those are in a base class."""
    members, required = schema["properties"], schema.get("required", [])
    needed = {key: value for key, value in members.items() if key in required}
    free = {key: value for key, value in members.items() if key not in required}
    about = docstring(sentence(schema.get("description", "")) or f"The contract's {name}.",
                      member_lines(contract, members, "    "), "    ")
    if "from" in members:  # a Python keyword, which cannot be a class member
        pairs = ", ".join(f'"{key}": {type_of(value)}' for key, value in members.items())
        return ["", "", f'{name} = TypedDict("{name}", {{{pairs}}})']
    if not free:
        return ["", "", f"class {name}(TypedDict):", *about, *fields(needed)]
    if not needed:
        return ["", "", f"class {name}(TypedDict, total=False):", *about, *fields(free)]
    base = f"_{name}Required"
    return ["", "", f"class {base}(TypedDict):", *fields(needed)[1:],
            "", "", f"class {name}({base}, total=False):", *about, *fields(free)]


def fields(members):
    return ["", *(on_lines(f"    {name}: {type_of(schema)}") for name, schema in members.items())] if members else []
