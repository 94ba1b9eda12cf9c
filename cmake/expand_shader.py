"""Expands #include lines of a shader, checks its variants with glslangValidator and writes it as a C++ string.

usage: expand_shader.py SOURCE OUTPUT.cpp SYMBOL INCLUDE_DIR...
"""
import pathlib
import re
import subprocess
import sys
import tempfile


def expand(path, folders, seen):
    if path in seen:
        return ""
    seen.add(path)
    text = []
    for line in path.read_text(encoding="utf-8").splitlines():
        found = re.match(r'\s*#include\s+"([^"]+)"', line)
        if not found:
            text.append(line)
            continue
        candidates = [folder / found.group(1) for folder in [path.parent, *folders]]
        existing = [c for c in candidates if c.is_file()]
        if not existing:
            sys.exit(f"{path}: no file for {line.strip()}")
        text.append(expand(existing[0].resolve(), folders, seen))
    return "\n".join(text)


def variants(text):
    """Sets of names that may be defined: none, each one that the text asks for with #ifdef alone, and all of them."""
    names = sorted(set(re.findall(r"^\s*#ifdef\s+(\w+)", text, re.MULTILINE)))
    return [[], *([name] for name in names), names] if names else [[]]


def check(source, text, defines):
    stage = source.suffix[1:]
    version, rest = text.split("\n", 1)
    with tempfile.NamedTemporaryFile("w", suffix="." + stage) as file:
        file.write("\n".join([version, *(f"#define {name} 1" for name in defines), rest]))
        file.flush()
        answer = subprocess.run(["glslangValidator", file.name], capture_output=True, text=True)
    if answer.returncode:
        sys.exit(f"{source} with {defines}:\n{answer.stdout}")


def main():
    source, output, symbol, *folders = sys.argv[1:]
    source = pathlib.Path(source).resolve()
    text = expand(source, [pathlib.Path(f).resolve() for f in folders], set()) + "\n"
    for defines in variants(text):
        check(source, text, defines)
    pathlib.Path(output).write_text(
        f"namespace pelage::shaders {{\nextern const char* const {symbol};\n"
        f'const char* const {symbol} = R"glsl({text})glsl";\n}}\n', encoding="utf-8")


main()
