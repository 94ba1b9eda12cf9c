"""Writes the constants of a GLSL file as a C++ header. Each line is `const int|float NAME = VALUE;  // comment` or a
comment. A GLSL float becomes a C++ double, or a C++ float if its value ends in f.

usage: shared_constants.py CONSTANTS.glsl HEADER.h
"""
import pathlib
import re
import sys


def type_of(kind, value):
    return "int" if kind == "int" else "float" if value.endswith("f") else "double"


def main():
    source, header = map(pathlib.Path, sys.argv[1:])
    lines = []
    for number, line in enumerate(source.read_text(encoding="utf-8").splitlines(), 1):
        found = re.fullmatch(r"const (int|float) (\w+) = ([-+.\de]+f?);\s*(//.*)?", line)
        if found:
            kind, name, value, comment = found.groups()
            lines.append(f"inline constexpr {type_of(kind, value)} {name} = {value};  {comment or ''}".rstrip())
        elif line and not line.startswith("//"):
            sys.exit(f"{source}:{number}: neither a constant nor a comment: {line}")
        else:
            lines.append(line)
    text = "#pragma once\n\nnamespace pelage {\n\n" + "\n".join(lines) + "\n\n}  // namespace pelage\n"
    if header.is_file() and header.read_text(encoding="utf-8") == text:
        return  # a new time stamp would recompile all files that include it
    header.parent.mkdir(parents=True, exist_ok=True)
    header.write_text(text, encoding="utf-8")


main()
