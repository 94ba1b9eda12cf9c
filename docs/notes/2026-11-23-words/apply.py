#!/usr/bin/env python3
"""Puts the words of the glossary in the place of the old ones, over a whole tree. Usage: apply.py ROOT [--dry]

Files move by `git mv`; contents change by the tables in tables.py. Running it twice changes nothing.
"""
import os
import re
import subprocess
import sys

sys.dont_write_bytecode = True
sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import tables  # noqa: E402

C_LIKE = (".cpp", ".h", ".glsl", ".frag", ".vert", ".in")
PYTHON = (".py", ".sh", ".cmake", "CMakeLists.txt")
PROSE = (".md",)
DATA = (".json", ".yaml", ".csv")
SKIPPED = re.compile(r"^(CHANGELOG\.md|LICENSE|docs/notes/|docs/trade/.*\.html|\.clang|\.git)|tests/arch/words\.py$")

# Code, strings and comments of C++ and GLSL. A number first: 1'000 has no character in it.
C_TOKENS = re.compile(
    r"""(?P<number>\b\d[\w.]*(?:'\w+)+)|(?P<comment>//[^\n]*|/\*.*?\*/)|(?P<include>\#\s*include\s*[<"][^>"\n]*[>"])"""
    r"""|(?P<raw>R"(?P<d>[^\s()\\"]{0,16})\(.*?\)(?P=d)")|(?P<string>"(?:\\.|[^"\\\n])*")|(?P<char>'(?:\\.|[^'\\\n])+')""", re.S)
P_TOKENS = re.compile(
    r"""(?P<comment>(?m:(?<![\w"'$&/{(])\#[^\n]*))|(?P<string>\"\"\".*?\"\"\"|'''.*?'''|"(?:\\.|[^"\\\n])*"|'(?:\\.|[^'\\\n])*')""", re.S)


def regions(path, text):
    """(kind, text): c code, s strings, m comments, i includes, p prose, d data."""
    if path.endswith(PROSE):
        return [("p", text)]
    if path.endswith(DATA):
        return [("d", text)]
    if path.endswith(C_LIKE):
        pattern = C_TOKENS
    elif path.endswith(PYTHON) or text.startswith("#!"):
        pattern = P_TOKENS
    else:
        return []
    out, at = [], 0
    for match in pattern.finditer(text):
        out.append(("c", text[at:match.start()]))
        kind = {"comment": "m", "include": "i", "number": "c"}.get(match.lastgroup, "s")
        if match.lastgroup == "d":
            kind = "s"
        out.append((kind, match.group()))
        at = match.end()
    out.append(("c", text[at:]))
    return [part for part in out if part[1]]


class Rule:
    """One replacement: in regions of these kinds, in files whose path matches `inside` and not `outside`."""

    def __init__(self, pattern, new, kinds="csmpd", inside="", outside=None):
        self.pattern, self.new, self.kinds = re.compile(pattern), new, kinds
        self.inside, self.outside = re.compile(inside), re.compile(outside) if outside else None

    def takes(self, path):
        return self.inside.search(path) and not (self.outside and self.outside.search(path))


def tracked(root):
    listed = subprocess.run(["git", "-C", root, "ls-files", "-z"], check=True, capture_output=True, text=True).stdout
    return [name for name in listed.split("\0") if name and os.path.isfile(os.path.join(root, name))]


def new_name(path):
    for pattern, new in tables.FILES:
        path = re.sub(pattern, new, path)
    return path


def move_files(root, dry):
    moved = {}
    for path in tracked(root):
        if path.startswith("docs/notes/"):
            continue
        to = new_name(path)
        if to == path:
            continue
        if os.path.exists(os.path.join(root, to)):
            print(f"left where it is, for {to} exists: {path}")
            continue
        moved[path] = to
        if not dry:
            os.makedirs(os.path.dirname(os.path.join(root, to)) or ".", exist_ok=True)
            subprocess.run(["git", "-C", root, "mv", path, to], check=True)
    return moved


def rewritten(path, text, file_rules, rules):
    # Whole-text rules first: names of files in includes, CMake and links.
    for rule in file_rules:
        text = rule.pattern.sub(rule.new, text)
    parts = regions(path, text)
    if not parts:
        return text
    for index, (kind, part) in enumerate(parts):
        for rule in rules:
            if kind in rule.kinds:
                part = rule.pattern.sub(rule.new, part)
        parts[index] = (kind, part)
    return "".join(part for _, part in parts)


def main():
    root, dry = sys.argv[1], "--dry" in sys.argv
    moved = move_files(root, dry)
    rules = [Rule(*row) for row in tables.rules()]
    texts = [Rule(*row) for row in tables.TEXTS]
    changed = 0
    for path in tracked(root):
        if SKIPPED.search(path):
            continue
        full = os.path.join(root, path)
        try:
            with open(full, encoding="utf-8", newline="") as file:
                before = file.read()
        except UnicodeDecodeError:
            continue
        after = rewritten(path, before, [r for r in texts if r.takes(path)], [r for r in rules if r.takes(path)])
        if after != before:
            changed += 1
            if not dry:
                with open(full, "w", encoding="utf-8", newline="") as file:
                    file.write(after)
    print(f"{len(moved)} files moved, {changed} files changed")


if __name__ == "__main__":
    main()
