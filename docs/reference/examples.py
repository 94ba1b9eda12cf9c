"""Writes examples of the contract as JSON, as shell commands, as Python and as curl calls."""

from __future__ import annotations

import json
import shlex
import urllib.parse
from typing import Any, Dict, Optional

from contract import Operation

WIDTH = 88
OPEN = 'import pelage\n\nserver = pelage.Server("http://127.0.0.1:8080")\n'
FOX = 'fox = server.open("fox")\n\n'


def as_json(value: Any, indent: int = 0, used: int = 0) -> str:
    """Formats JSON; whatever fits on a line stays on one. `used`: columns that are taken before it on its line."""
    flat = json.dumps(value, ensure_ascii=False)
    if indent + used + len(flat) <= WIDTH or not isinstance(value, (dict, list)) or not value:
        return flat
    inner = indent + 2
    if isinstance(value, list):
        parts = [as_json(one, inner) for one in value]
    else:
        parts = [f"{json.dumps(key)}: {as_json(one, inner, len(key) + 4)}" for key, one in value.items()]
    marks = "[]" if isinstance(value, list) else "{}"
    return marks[0] + "\n" + ",\n".join(" " * inner + part for part in parts) + "\n" + " " * indent + marks[1]


def as_python(value: Any, indent: int = 0, used: int = 0) -> str:
    """Formats a Python literal, with the layout of as_json."""
    flat = repr(value).replace("'", '"')
    if indent + used + len(flat) <= WIDTH or not isinstance(value, (dict, list)) or not value:
        return flat
    inner = indent + 4
    if isinstance(value, list):
        parts = [as_python(one, inner) for one in value]
    else:
        parts = [f'"{key}": {as_python(one, inner, len(key) + 4)}' for key, one in value.items()]
    marks = "[]" if isinstance(value, list) else "{}"
    return marks[0] + "\n" + ",\n".join(" " * inner + part for part in parts) + ",\n" + " " * indent + marks[1]


def command_python(command: Dict[str, Any]) -> str:
    """Returns Python code that calls the command's typed method of the package."""
    members = {name: value for name, value in command.items() if name != "op"}
    flat = ", ".join(f"{name}={as_python(value)}" for name, value in members.items())
    call = f"fox.{command['op']}({flat})"
    if "\n" in call or len(call) > WIDTH:
        lines = [f"    {name}={as_python(value, 4, len(name) + 1)},\n" for name, value in members.items()]
        call = f"fox.{command['op']}(\n{''.join(lines)})"
    return OPEN + FOX + call


def command_cli(command: Dict[str, Any]) -> str:
    return f"pelage run fox - <<'END'\n{as_json(command)}\nEND"


def operation_python(python: str) -> str:
    return OPEN + (FOX if "fox." in python else "") + python


def curl(operation: Operation) -> str:
    """Returns a curl command. Path and query parameters that have an example go into the URL; headers are left out."""
    path, query = operation.path, {}
    for one in operation.parameters:
        if one["in"] == "path":
            path = path.replace("{" + one["name"] + "}", urllib.parse.quote(str(one["example"])))
        elif one["in"] == "query" and "example" in one:
            query[one["name"]] = one["example"]
    words = ["curl"] + ([] if operation.method == "GET" else ["-X", operation.method])
    if operation.id == "events":
        words.append("-N")
    address = f"http://127.0.0.1:8080{path}" + (f"?{urllib.parse.urlencode(query)}" if query else "")
    lines = [" ".join([*words, shlex.quote(address)])]
    body = body_example(operation)
    if body is not None:
        lines += ["-H 'Content-Type: application/json'", f"-d {shlex.quote(as_json(body))}"]
    elif operation.body_types():
        lines += ["-H 'Content-Type: application/octet-stream'", f"--data-binary @{file_example(operation)}"]
    if is_binary(operation):
        lines.append("-o answer")
    return " \\\n  ".join(lines)


def is_binary(operation: Operation) -> bool:
    """Returns whether the response is binary, so that it goes to a file instead of the terminal."""
    answer = operation.about["responses"].get("200", {})
    kind = next(iter(answer.get("content", {})), "image/png" if "$ref" in answer and operation.method == "GET" else "")
    return kind.startswith(("image/", "model/", "application/x-npy")) or operation.id == "drawFrame"


def body_example(operation: Operation) -> Optional[Any]:
    media = operation.body_types().get("application/json")
    if media is None:
        return None
    return media["example"] if "example" in media else next(iter(media["examples"].values()))["value"]


def file_example(operation: Operation) -> str:
    media = operation.body_types()["application/octet-stream"]
    return str(media["examples"]["file"]["x-file"]).rsplit("/", 1)[1]
