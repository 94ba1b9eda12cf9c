"""Members of the contract's schemas as rows of tables, for the pages of docs/tools and docs/reference."""

from __future__ import annotations

import json
from dataclasses import dataclass
from typing import Any, Dict, List, Optional, Tuple

Schema = Dict[str, Any]

NO_LIMIT = 1e20  # a bound this large only means that the number is finite; the description gives the real one
# Types of members in many tables, given as (type, unit, range) instead of a reference to the schema.
KNOWN = {"Position": ("3 numbers", "model units", ""), "Direction": ("3 numbers", "any length", ""),
         "Colour": ("colour", "", "`#rrggbb` (sRGB) or 3 linear numbers"),
         "Camera": ("camera", "", "`auto`, or `position`, `target`, `up`, `fov_degrees`")}
PLAIN_UNITS = ("share", "factor", "varies", "any length", "model units", "as `units`")  # units that the value column leaves out; the description makes them clear


@dataclass(frozen=True)
class Row:
    """A member. `target`: name of the object schema that it is or, with `many`, that it is a list of."""
    name: str
    kind: str
    unit: str
    range: str
    default: Optional[str]  # as JSON
    required: bool
    words: str
    target: Optional[str]
    many: bool

    @property
    def value(self) -> str:
        """Type, range and unit in one text."""
        unit = "" if self.unit in PLAIN_UNITS else self.unit
        return " ".join(part for part in (self.kind if self.kind != "word" else "", self.range, unit) if part)


def name_of(schema: Schema) -> str:
    """Returns the name of the schema that `$ref` names; empty without one."""
    return str(schema.get("$ref", "")).split("/")[-1]


def required_of(schema: Schema) -> List[str]:
    """Members that are always required, by the schema itself or by a rule in its `allOf`."""
    return [*schema.get("required", []), *(name for rule in schema.get("allOf", []) for name in rule.get("required", []))]


def short(number: float) -> str:
    return str(int(number)) if number == int(number) else f"{number:g}"


def bounds(low: Optional[float], high: Optional[float]) -> str:
    if low is not None and 0 < low < 1 / NO_LIMIT:
        return "above 0"
    low_known, high_known = low is not None and abs(low) < NO_LIMIT, high is not None and abs(high) < NO_LIMIT
    if low_known and high_known:
        return short(low) if low == high else f"{short(low)} to {short(high)}"  # type: ignore[arg-type]
    return f"{short(low)} or more" if low_known else f"up to {short(high)}" if high_known else ""  # type: ignore[arg-type]


class Schemas:
    def __init__(self, schemas: Dict[str, Schema]) -> None:
        self.all = schemas

    def resolved(self, schema: Schema) -> Schema:
        """Follows `$ref`; keywords next to it, such as description and default, override the target's."""
        if "$ref" not in schema:
            return schema
        path = schema["$ref"].split("/")[3:]
        target: Any = self.all
        for step in path:
            target = target[int(step)] if isinstance(target, list) else target[step]
        return {**self.resolved(target), **{key: value for key, value in schema.items() if key != "$ref"}}

    def parts(self, schema: Schema) -> Tuple[str, str, str]:
        """Type, unit and range of a member."""
        if name_of(schema) in KNOWN:
            return KNOWN[name_of(schema)]
        schema = self.resolved(schema)
        unit = schema.get("x-unit", "")
        if "const" in schema:
            return "word" if isinstance(schema["const"], str) else "constant", "", f"`{json.dumps(schema['const']).strip(chr(34))}`"
        if "enum" in schema:
            return "word", "", ", ".join(f"`{one}`" for one in schema["enum"])
        if "oneOf" in schema:
            each = [self.parts(one) for one in schema["oneOf"]]
            return " or ".join(dict.fromkeys(kind for kind, _, _ in each)), next((unit for _, unit, _ in each if unit), ""), \
                " or ".join(range_ for _, _, range_ in each if range_)
        kind = schema.get("type", "any")
        if kind in ("number", "integer"):
            low = schema.get("minimum")
            return kind, unit, "above 0" if "exclusiveMinimum" in schema else bounds(low, schema.get("maximum"))
        if kind == "array":
            return self.list_parts(schema)
        if kind == "string":
            length = bounds(schema.get("minLength", 0), schema.get("maxLength"))
            return "text", "", f"{length} bytes" if "maxLength" in schema else ""
        return ("true or false" if kind == "boolean" else kind if isinstance(kind, str) else " or ".join(kind)), "", ""

    def list_parts(self, schema: Schema) -> Tuple[str, str, str]:
        kind, unit, range_ = self.parts(schema["items"])
        low, high = schema.get("minItems"), schema.get("maxItems")
        if low is not None and low == high:
            return f"{high} {kind}s" if not kind.endswith("s") else f"{high} times {kind}", unit, range_
        count = bounds(low or 0, high) if high is not None else ""
        plural = "words" if kind == "word" else kind if kind.endswith("s") else f"{kind}s"
        return f"list of {count} {plural}".replace("  ", " "), unit, range_

    def target_of(self, schema: Schema) -> Tuple[Optional[str], bool]:
        """Returns the name of the object schema that a member is or is a list of, and whether it is a list."""
        for one in (schema, *schema.get("oneOf", [])):
            many = one.get("type") == "array"
            name = name_of(one.get("items", {}) if many else one)
            if name in self.all and name not in KNOWN and self.has_members(self.all[name]):
                return name, many
        return None, False

    def has_members(self, schema: Schema) -> bool:
        return bool(schema.get("properties")) or any(one.get("type") == "object" for one in schema.get("oneOf", [])) or "discriminator" in schema

    def row(self, name: str, own: Schema, required: bool) -> Row:
        full = self.resolved(own)
        target, many = self.target_of(own)
        kind, unit, range_ = self.parts(own)
        default = json.dumps(full["default"]) if "default" in full else None
        words = str(full.get("description") or self.resolved(full.get("items", {})).get("description", ""))
        return Row(name, kind, unit, range_, default, required, " ".join(words.split()), target, many)

    def rows(self, schema: Schema) -> List[Row]:
        """The members of an object, except the `op` of a command."""
        required = required_of(schema)
        return [self.row(name, own, name in required) for name, own in schema.get("properties", {}).items()
                if name != "op" or "const" not in own]

    def where(self, schema: Schema) -> str:
        """Says whether a tool takes a stroke, a flood or either; empty for types without a stroke."""
        if "stroke" not in schema.get("properties", {}):
            return ""
        if "flood" in schema["properties"]:
            return "Takes either a stroke, or `flood` to work everywhere. The mask holds for both."
        if "stroke" in required_of(schema):
            return "Needs a stroke. The mask holds."
        return "Works everywhere, or under a stroke's brush where one is given. The mask holds."
