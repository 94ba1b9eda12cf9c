"""Embeds the files of folders in a program: writes an assembler file with their bytes and a C++ file with their table.

usage: embed.py BYTES.s TABLE.cpp FOLDER...

index.html is served at the address /; assets/FILE, docs/FILE and openapi.json are served under their own names; any other file is an
error. FILE.gz and FILE.br are the compressed forms of FILE and are optional.
"""
import hashlib
import pathlib
import re
import sys

TYPES = {
    ".html": "text/html; charset=utf-8",
    ".js": "text/javascript; charset=utf-8",
    ".css": "text/css; charset=utf-8",
    ".json": "application/json",
    ".svg": "image/svg+xml",
    ".png": "image/png",
    ".jpg": "image/jpeg",
    ".webp": "image/webp",
    ".obj": "application/octet-stream",
    ".hdr": "application/octet-stream",
    ".pelage": "application/octet-stream",
}
HASHED = re.compile(r".+-[A-Za-z0-9_-]{8,}\.\w+")  # NAME-HASH.js: the name changes with the content
ASSET = re.compile(r"(assets|docs)/[A-Za-z0-9_.-]+|openapi\.json")
FORMS = {"identity": "", "gzip": ".gz", "brotli": ".br"}


def files(folder):
    """Returns the names of the files, without their compressed forms."""
    names = sorted(path.relative_to(folder).as_posix() for path in folder.rglob("*") if path.is_file())
    plain = [name for name in names if not (name.endswith((".gz", ".br")) and name[:-3] in names)]
    for name in plain:
        if name != "index.html" and not ASSET.fullmatch(name):
            sys.exit(f"embed.py: {name} has no address; only index.html, openapi.json, assets/* and docs/* have")
        if pathlib.PurePath(name).suffix not in TYPES:
            sys.exit(f"embed.py: {name} is of no known type")
        if not (folder / name).stat().st_size:
            sys.exit(f"embed.py: {name} is empty")
    return plain


def bytes_of(symbol, path):
    quoted = str(path.resolve()).replace("\\", "\\\\").replace('"', '\\"')
    return f'.globl {symbol}\n{symbol}:\n.incbin "{quoted}"\n.globl {symbol}_end\n{symbol}_end:\n.byte 0\n'


def main(assembler, table, *folders):
    code, declared, rows = [".section .rodata\n"], [], []
    named = [(pathlib.Path(folder), name) for folder in folders for name in files(pathlib.Path(folder))]
    if "index.html" not in [name for _, name in named]:
        sys.exit(f"embed.py: none of {folders} has an index.html")
    for number, (folder, name) in enumerate(named):
        views = []
        for form, ending in FORMS.items():
            path, symbol = folder / (name + ending), f"pelage_embedded_{number}_{form}"
            if not path.is_file():
                views.append("{}")
                continue
            code.append(bytes_of(symbol, path))
            declared.append(f"extern const char {symbol}[], {symbol}_end[];\n")
            views.append(f"{{{symbol}, static_cast<std::size_t>({symbol}_end - {symbol})}}")
        address = "/" if name == "index.html" else "/" + name
        tag = hashlib.sha256((folder / name).read_bytes()).hexdigest()[:24]
        hashed = "true" if address != "/" and HASHED.fullmatch(name) else "false"
        rows.append(f'      {{"{address}", "{TYPES[pathlib.PurePath(name).suffix]}", {", ".join(views)}, "{tag}", {hashed}}},\n')
    code.append('.section .note.GNU-stack,"",%progbits\n')
    pathlib.Path(assembler).write_text("".join(code), encoding="utf-8")
    pathlib.Path(table).write_text(
        '#include "server/http/embedded_files.h"\n\nextern "C" {\n' + "".join(declared) + "}\n\nnamespace pelage {\n\n"
        "std::span<const EmbeddedFile> embedded_files() {\n  static const EmbeddedFile files[] = {\n" + "".join(rows)
        + "  };\n  return files;\n}\n\n}  // namespace pelage\n", encoding="utf-8")


main(*sys.argv[1:])
