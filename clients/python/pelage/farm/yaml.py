"""Writes objects, lists, strings, numbers and booleans as YAML. Strings are quoted as in JSON, so that none is misread."""

from __future__ import annotations

import json
from typing import Any, List


def to_yaml(value: Any) -> str:
    return "\n".join(lines_of(value)) + "\n"


def lines_of(value: Any) -> List[str]:
    if isinstance(value, dict) and value:
        return [line for key, member in value.items() for line in member_lines(f"{key}:", member)]
    if isinstance(value, list) and value:
        return [line for entry in value for line in entry_lines(lines_of(entry))]
    return [json.dumps(value, ensure_ascii=False)]


def member_lines(key: str, value: Any) -> List[str]:
    lines = lines_of(value)
    if isinstance(value, (dict, list)) and value:
        return [key, *(f"  {line}" for line in lines)]
    return [f"{key} {lines[0]}"]


def entry_lines(lines: List[str]) -> List[str]:
    return [f"- {lines[0]}", *(f"  {line}" for line in lines[1:])]
