"""Expands the #include lines of a shader and writes it as a C++ string. glslangValidator checks these variants: no #define;
each name that #ifdef tests or that begins with SHOWN_ by itself; all #ifdef names without SHOWN_*; and these with each shading
model. Other combinations are compiled when a scene first needs them.

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


SHADING_MODELS = 6  # number of models in renderer/shaders/constants.glsl


def variants(text):
    """Returns the variants to check, each a list of #define lines (see above)."""
    shown = [f"{name} 1" for name in sorted(set(re.findall(r"\bSHOWN_\w+", text)))]  # RasterOutput: a picture shows one at a time
    asked = sorted(set(re.findall(r"^\s*#ifdef\s+(\w+)", text, re.MULTILINE)))
    names = [f"{name} 1" for name in asked if not name.startswith("SHOWN_")]
    models = [f"SHADING_MODEL {number}" for number in range(SHADING_MODELS)] if "SHADING_MODEL" in text else []
    return [[], *([name] for name in [*names, *shown]), names, *([*names, model] for model in models)]


def check(source, text):
    """Checks all variants in one run: the validator takes longer to start than to check one."""
    version, rest = text.split("\n", 1)
    with tempfile.TemporaryDirectory() as folder:
        files = {}
        for number, defines in enumerate(variants(text)):
            file = pathlib.Path(folder, f"{number}{source.suffix}")
            file.write_text("\n".join([version, *(f"#define {line}" for line in defines), rest]), encoding="utf-8")
            files[str(file)] = f"{source} with {defines}:"
        answer = subprocess.run(["glslangValidator", *files], capture_output=True, text=True)
    if answer.returncode:
        sys.exit("\n".join(files.get(line, line) for line in answer.stdout.splitlines()))


def main():
    source, output, symbol, *folders = sys.argv[1:]
    source = pathlib.Path(source).resolve()
    text = expand(source, [pathlib.Path(f).resolve() for f in folders], set()) + "\n"
    check(source, text)
    pathlib.Path(output).write_text(
        f"namespace pelage::shaders {{\nextern const char* const {symbol};\n"
        f'const char* const {symbol} = R"glsl({text})glsl";\n}}\n', encoding="utf-8")


main()
