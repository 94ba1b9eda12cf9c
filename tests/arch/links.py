"""Checks that every relative link and picture of the Markdown pages leads to a file, and every #anchor to a heading.

usage: links.py ROOT
"""
import pathlib
import re
import subprocess
import sys
import tempfile

LINK = re.compile(r"\]\(([^)\s]+)\)")
ELSEWHERE = re.compile(r"[a-z]+:")
CODE = re.compile(r"^```.*?^```|^(?: {4}|\t).*?$|`[^`\n]*`", re.M | re.S)


def anchors(text):
    """Returns the anchors that Markdown viewers make of the headings."""
    titles = re.findall(r"^#+ (.*)$", text, re.M)
    return {re.sub(r"[^\w\- ]", "", title.lower()).replace(" ", "-") for title in titles}


def problems(root, page):
    text = (root / page).read_text(encoding="utf-8")
    found = []
    for target in LINK.findall(CODE.sub("", text)):
        if ELSEWHERE.match(target):
            continue
        path, _, anchor = target.partition("#")
        file = root / page.parent / path if path else root / page
        if not file.exists():
            found.append(f"{page}: {target} is not there")
        elif anchor and file.suffix == ".md" and anchor not in anchors(file.read_text(encoding="utf-8")):
            found.append(f"{page}: {target} has no such heading")
    return found


def pages(root):
    listed = subprocess.run(["git", "-C", str(root), "ls-files", "*.md"], capture_output=True, text=True)
    names = listed.stdout.split() if listed.returncode == 0 else []
    return [pathlib.Path(name) for name in names] or [
        path.relative_to(root) for top in (".", "docs") for path in sorted((root / top).glob("*.md" if top == "." else "**/*.md"))]


def main():
    root = pathlib.Path(sys.argv[1])
    checked = [page for page in pages(root) if (root / page).exists()]
    found = [line for page in checked for line in problems(root, page)]
    print(f"{len(checked)} pages")
    if found or not checked:
        sys.exit("\n".join(found) or "no pages found")


main()
