"""Makes the reference: static pages of all commands, operations and types of the contract.

usage: make.py OPENAPI_JSON FOLDER

FOLDER gets docs/, with index.html, a page for each command, each group of operations and each type, their pictures, the
files of the examples and one style sheet. The pages link only to each other. The build runs this program; the server
serves the pages at /docs.
"""

from __future__ import annotations

import gzip
import pathlib
import shutil
import sys

import yaml

HERE = pathlib.Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parent))
from contract import Contract  # noqa: E402
from pages import Pages, read_pictures  # noqa: E402

COMPRESSED = (".html", ".css")


def write(path: pathlib.Path, content: bytes) -> None:
    """Writes a file and, for HTML and CSS, a shorter gzip next to it. The same content gives the same bytes."""
    path.write_bytes(content)
    small = gzip.compress(content, 9, mtime=0)
    if path.suffix in COMPRESSED and len(small) < len(content):
        path.with_name(path.name + ".gz").write_bytes(small)


def main(contract_file: str, folder: str) -> None:
    target = pathlib.Path(folder) / "docs"
    shutil.rmtree(target, ignore_errors=True)
    target.mkdir(parents=True)
    clients = yaml.safe_load((HERE / "clients.yaml").read_text(encoding="utf-8"))
    write(target / "style.css", (HERE / "style.css").read_bytes())
    for path in (*(HERE / "pictures").glob("*.jpg"), *(HERE / "files").iterdir()):
        write(target / path.name, path.read_bytes())
    for name, text in Pages(Contract(pathlib.Path(contract_file)), clients, read_pictures(HERE / "pictures")).all():
        write(target / name, text.encode())


if __name__ == "__main__":
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    main(*sys.argv[1:])
