"""Expands #include lines of a shader, checks it with glslangValidator and writes it as a C++ string.

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


def check(source, text):
    stage = source.suffix[1:]
    with tempfile.NamedTemporaryFile("w", suffix="." + stage) as file:
        file.write(text)
        file.flush()
        answer = subprocess.run(["glslangValidator", file.name], capture_output=True, text=True)
    if answer.returncode:
        sys.exit(f"{source}:\n{answer.stdout}")


def main():
    source, output, symbol, *folders = sys.argv[1:]
    source = pathlib.Path(source).resolve()
    text = expand(source, [pathlib.Path(f).resolve() for f in folders], set()) + "\n"
    check(source, text)
    pathlib.Path(output).write_text(
        f"namespace pelage::shaders {{\nextern const char* const {symbol};\n"
        f'const char* const {symbol} = R"glsl({text})glsl";\n}}\n', encoding="utf-8")


main()
