"""The contract as the pages need it: commands, operations by group, types, and which of them refer to which."""

from __future__ import annotations

import json
import pathlib
import re
from dataclasses import dataclass
from typing import Any, Dict, Iterator, List

from schema_rows import Schema, Schemas

METHODS = ("get", "post", "put", "delete")


@dataclass(frozen=True)
class Command:
    op: str
    schema_name: str
    schema: Schema
    example: Dict[str, Any]


@dataclass(frozen=True)
class Operation:
    id: str
    method: str
    path: str
    about: Dict[str, Any]
    parameters: List[Dict[str, Any]]

    @property
    def group(self) -> str:
        return str(self.about["tags"][0])

    def body_types(self) -> Dict[str, Any]:
        """Media types of the request body, each with its schema and examples."""
        return dict(self.about.get("requestBody", {}).get("content", {}))


class Contract:
    def __init__(self, path: pathlib.Path) -> None:
        self.document = json.loads(path.read_text(encoding="utf-8"))
        self.components = self.document["components"]
        self.schemas = Schemas(self.components["schemas"])
        self.operations = list(self._operations())
        self.groups: Dict[str, str] = {tag["name"]: tag["description"] for tag in self.document["tags"]}
        self.commands = list(self._commands())
        self._ops = {command.schema_name: command.op for command in self.commands}

    def component(self, node: Dict[str, Any]) -> Dict[str, Any]:
        """Resolves a reference to a parameter, a response or a header; returns any other node as it is."""
        if "$ref" not in node:
            return node
        _, _, kind, name = node["$ref"].split("/")
        return dict(self.components[kind][name])

    def _operations(self) -> Iterator[Operation]:
        for path, item in self.document["paths"].items():
            for method in METHODS:
                if method in item:
                    given = [*item.get("parameters", []), *item[method].get("parameters", [])]
                    yield Operation(item[method]["operationId"], method.upper(), path, item[method], [self.component(one) for one in given])

    def _commands(self) -> Iterator[Command]:
        run = next(operation for operation in self.operations if operation.id == "runCommands")
        examples = run.body_types()["application/json"]["examples"]
        for op, reference in self.schemas.all["Command"]["discriminator"]["mapping"].items():
            name = reference.split("/")[-1]
            yield Command(op, name, self.schemas.all[name], examples[op]["value"])

    def types(self) -> Dict[str, Schema]:
        """All schemas except those of commands, which have pages of their own."""
        return {name: schema for name, schema in self.schemas.all.items() if name not in self._ops}

    def page_of(self, name: str) -> str:
        """Returns the file name of a schema's page."""
        return f"{self._ops[name]}.html" if name in self._ops else f"type-{name.lower()}.html"

    def users_of(self, name: str) -> Dict[str, str]:
        """Commands, operations and types that name a schema, with their pages."""
        pattern = re.compile(rf'"#/components/schemas/{name}["/]')
        found = {command.op: f"{command.op}.html" for command in self.commands if pattern.search(json.dumps(command.schema))}
        for operation in self.operations:
            about = {key: value for key, value in operation.about.items() if key != "parameters"}
            responses = [self.component(one) for one in operation.about["responses"].values()] if name != "Problem" else []
            if pattern.search(json.dumps([about, operation.parameters, responses])):
                found[operation.id] = f"{group_page(operation.group)}#{operation.id}"
        found.update({other: self.page_of(other) for other, schema in self.types().items()
                      if other != name and pattern.search(json.dumps(schema))})
        return found


def group_page(group: str) -> str:
    return f"group-{group}.html"
