"""Converts the contract's schemas to Python types and docstrings."""

import json
import pathlib
import textwrap

WIDTH = 118
# New names for schemas whose own names are those of handwritten classes of the package.
RENAMED = {"Scene": "SceneInfo", "Problem": "ProblemDocument", "Batch": "CommandBatch"}
# Class names for the alternatives of a `oneOf` schema, in the contract's order.
VARIANTS = {"Camera": ("AutoCamera", "PinholeCamera"), "Pick": ("PickMiss", "PickHit")}
PLAIN = {"string": "str", "integer": "int", "number": "float", "boolean": "bool", "object": "Dict[str, Any]",
         "array": "Sequence[Any]"}


class Contract:
    def __init__(self, document):
        self.schemas = document["components"]["schemas"]
        self.operations = {operation["operationId"]: operation for path in document["paths"].values()
                           for method, operation in path.items() if method != "parameters"}

    @staticmethod
    def read(path):
        return Contract(json.loads(pathlib.Path(path).read_text(encoding="utf-8")))

    def commands(self):
        """Returns pairs of an op and its schema, in the contract's order."""
        mapping = self.schemas["Command"]["discriminator"]["mapping"]
        return [(op, self.schemas[last_of(reference)]) for op, reference in mapping.items()]

    def resolved(self, schema):
        """Returns the schema with its $ref resolved; its own members take precedence."""
        if "$ref" not in schema:
            return schema
        target = self.resolved(self.schemas[last_of(schema["$ref"])])
        return {**target, **{key: value for key, value in schema.items() if key != "$ref"}}

    def words(self, schema):
        """Describes a member: description, range, default."""
        whole = self.resolved(schema)
        items = self.resolved(whole.get("items", {}))
        words = [sentence(whole.get("description") or items.get("description", "")), with_capital(sentence(range_of(whole)))]
        if "default" in whole:
            words.append(f"Default {json.dumps(whole['default'])}.")
        return " ".join(" ".join(words).split())


def last_of(reference):
    return reference.rsplit("/", 1)[1]


def named(name):
    return RENAMED.get(name, name)


def type_of(schema):
    """Returns the Python type of a schema that is not an object with members."""
    if "$ref" in schema:
        return named(last_of(schema["$ref"]))
    if "const" in schema or "enum" in schema:
        values = [schema["const"]] if "const" in schema else schema["enum"]
        return f"Literal[{', '.join(map(literal, values))}]"
    if "oneOf" in schema:
        return union([type_of(one) for one in schema["oneOf"]])
    if isinstance(schema.get("type"), list):
        return union([PLAIN[one] for one in schema["type"]])
    if "items" in schema:
        return f"Sequence[{type_of(schema['items'])}]"
    return PLAIN[schema["type"]]


def union(types):
    return types[0] if len(types) == 1 else f"Union[{', '.join(dict.fromkeys(types))}]"


def literal(value):
    return json.dumps(value) if isinstance(value, str) else repr(value)


def range_of(schema):
    """Describes the range of a number with its unit, or of the number of an array's items; "" if there is none."""
    unit = schema.get("x-unit", schema.get("items", {}).get("x-unit"))
    unit = (" items" if "items" in schema else "") + (f" ({unit})" if unit else "")
    low = schema.get("minItems", schema.get("minimum"))
    high = schema.get("maxItems", schema.get("maximum"))
    if low is None and high is None:
        return ""
    if low == high:
        return f"{json.dumps(low)}{unit}"
    if high is None:
        return f"at least {json.dumps(low)}{unit}"
    return f"{json.dumps(low)} to {json.dumps(high)}{unit}" if low is not None else f"at most {json.dumps(high)}{unit}"


def with_capital(text):
    return text[:1].upper() + text[1:]


def sentence(text):
    text = " ".join(text.split())
    if not text:
        return ""
    return text + ("" if text[-1] in ".!?" else ".")


def member_lines(contract, members, indent):
    """Returns lines of a docstring, one paragraph for each member with a description."""
    lines = []
    for name, schema in members.items():
        words = contract.words(schema)
        if words:
            lines += textwrap.wrap(f"{name}: {words}", WIDTH, initial_indent=indent, subsequent_indent=indent + "    ")
    return lines


def docstring(summary, lines, indent):
    """Returns the lines of a docstring with a summary and `lines`, which are indented already."""
    summary_lines = textwrap.wrap(summary, WIDTH - 3, initial_indent=indent + '"""', subsequent_indent=indent)
    if not lines and len(summary_lines) == 1:
        return [summary_lines[0] + '"""']
    return [*summary_lines, *([""] if lines else []), *lines, indent + '"""']


def filled(words, width):
    """Wraps the words to lines of at most `width` characters."""
    lines = []
    for word in words:
        if lines and len(lines[-1]) + 1 + len(word) <= width:
            lines[-1] += f" {word}"
        else:
            lines.append(word)
    return lines


def on_lines(line):
    """Returns the line; if it is too long, wraps the values of its Literal or Union."""
    if len(line) <= WIDTH:
        return line
    start, end = line.rindex("[", 0, line.index(", ")) + 1, line.index("]")
    indent = " " * (len(line) - len(line.lstrip()))
    values = filled(line[start:end].split(" "), WIDTH - len(indent) - 4)
    return "\n".join([line[:start], *(f"{indent}    {one}" for one in values), indent + line[end:]])
