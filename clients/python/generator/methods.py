"""commands.py: a method for each command. requests.py: methods whose parameters are members of a schema."""

from generator.contract import WIDTH, docstring, filled, last_of, member_lines, named, on_lines, sentence, type_of
from generator.tables import OPTIONS, REQUESTS

COMMANDS_HEAD = '''"""A method for each command of the contract. Made by generate.py."""

from __future__ import annotations

from typing import Any, Dict, Generic, Literal, Optional, Sequence, TypeVar, Union

from .options import Options
from .schemas import (
{names}
)

R = TypeVar("R")


class Commands(Generic[R]):
    """Commands as methods. A parameter that is left out is not sent, and takes its default.

    author: Who makes the change, for the log and for those who follow the scene; at most 200 bytes of UTF-8.
    dry_run: Says what the command would do and changes nothing.
    if_match: A revision. At another one nothing is done, and `Conflict` is raised.

    A value that breaks the contract raises `Refused` with a pointer to it; nothing is changed then.
    """

    def _run(self, command: Dict[str, Any], options: Options) -> R:
        """`command`: with None for what is not to be sent."""
        raise NotImplementedError
'''
REQUESTS_HEAD = '''"""Requests that have many parameters, as methods. Made by generate.py."""

from __future__ import annotations

import os
from typing import TYPE_CHECKING, Any, Dict, Iterator, Literal, Optional, Sequence, Union

from .frame import FieldMap, Frame
from .options import Options
from .progress import ReportProgress
from .schemas import (
{names}
)

if TYPE_CHECKING:
    import numpy
    from numpy.typing import NDArray

Path = Union[str, "os.PathLike[str]"]


class Requests:
    """Pictures, models and maps. A parameter that is left out is not sent, and takes its default.

    `members` of the methods that do the work have None for what is not to be sent.
    """
'''


def commands_module(contract):
    lines, used = [], set()
    for op, schema in contract.commands():
        members = {name: one for name, one in schema["properties"].items() if name != "op"}
        order = in_order(members, schema.get("required", []))
        lines += ["", f"    def {op}(", "        self,", "        *,"]
        lines += [parameter(name, members[name], name in schema.get("required", []), used) for name in order]
        lines += [*OPTIONS.values(), "    ) -> R:"]
        summary = sentence(schema.get("description", "")) or f"Sets what the scene has of `{order[0]}`."
        lines += docstring(summary, member_lines(contract, members, "        "), "        ")
        pairs = [f'"op": "{op}"', *(f'"{name}": {name}' for name in order)]
        lines += ["        return self._run(", *members_of(pairs), "            Options(author, dry_run, if_match),", "        )"]
    return COMMANDS_HEAD.replace("{names}", imports(used)) + "\n".join(lines) + "\n"


def requests_module(contract):
    used = {"CommandAnswer", "ExportAbout", "Field", "FrameCost", "SceneInfo", "Pick"}
    lines = []
    for request in REQUESTS:
        lines += request_lines(contract, request, used)
    for request in REQUESTS:
        lines += work_lines(request)
    return REQUESTS_HEAD.replace("{names}", imports(used)) + "\n".join(lines) + "\n"


def request_lines(contract, request, used):
    schema = contract.schemas[request.schema]
    members = {name: one for name, one in schema["properties"].items() if name not in request.without}
    positional = [one for one in request.parameters if one[2] is None]
    keyword = [one for one in request.parameters if one[2] is not None]
    required = [name for name in schema.get("required", []) if name in members and name not in request.optional]
    order = in_order(members, required)
    lines = ["", f"    def {request.name}(", "        self,"]
    lines += [f"        {name}: {kind}," for name, kind, _, _ in positional]
    lines += ["        *,"]
    lines += [parameter(name, members[name], name in required, used) for name in order]
    lines += [f"        {name}: {kind} = {default}," for name, kind, default, _ in keyword]
    lines += [f"    ) -> {request.returns}:"]
    words = member_lines(contract, members, "        ")
    own = {name: {"description": text} for name, _, _, text in request.parameters}
    words = member_lines(contract, {name: own[name] for name, *_ in positional}, "        ") + words
    words += member_lines(contract, {name: own[name] for name, *_ in keyword}, "        ")
    lines += docstring(request.summary, words, "        ")
    lines += [f"        return self._{request.name}(", *members_of([f'"{name}": {name}' for name in order])]
    return lines + [f"            {name}," for name, *_ in request.parameters] + ["        )"]


def work_lines(request):
    """Returns the declaration of the method that does a request's work, which a subclass implements."""
    extra = [f"        {name}: {kind}," for name, kind, *_ in request.parameters]
    return ["", f"    def _{request.name}(", "        self,", "        members: Dict[str, Any],", *extra,
            f"    ) -> {request.returns}:", "        raise NotImplementedError"]


def in_order(members, required):
    """Returns the members, required ones first."""
    return [*(name for name in members if name in required), *(name for name in members if name not in required)]


def parameter(name, schema, required, used):
    kind = type_of(schema)
    collect(schema, used)
    if name == "camera":  # an automatic camera can be given by its name alone
        used.add("AutoView")
        kind = f"Union[AutoView, {kind}]"
    return on_lines(f"        {name}: {kind}," if required else f"        {name}: Optional[{kind}] = None,")


def collect(schema, used):
    if "$ref" in schema:
        used.add(named(last_of(schema["$ref"])))
    for one in (*schema.get("oneOf", []), *([schema["items"]] if "items" in schema else [])):
        collect(one, used)


def members_of(pairs):
    """Returns the lines of a dict with these pairs."""
    line = "{" + ", ".join(pairs) + "}"
    if len(line) + 13 <= WIDTH:
        return [f"            {line},"]
    return ["            {", *(f"                {one}" for one in filled([f"{pair}," for pair in pairs], WIDTH - 16)), "            },"]


def imports(used):
    return "\n".join(f"    {name}," for name in sorted(used))
