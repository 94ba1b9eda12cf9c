#!/usr/bin/env python3
"""Writes the parts of the package that follow the contract: schemas.py, commands.py and requests.py. The build calls it.

usage: generate.py OPENAPI_JSON [FOLDER]

FOLDER is that of the package, `pelage` beside this file unless given. The same contract gives the same bytes.
"""

import pathlib
import sys

from generator.contract import Contract
from generator.methods import commands_module, requests_module
from generator.schemas import schemas_module

MODULES = {"schemas.py": schemas_module, "commands.py": commands_module, "requests.py": requests_module}


def main(arguments):
    if len(arguments) not in (1, 2):
        sys.exit(__doc__)
    contract = Contract.read(arguments[0])
    folder = pathlib.Path(arguments[1]) if len(arguments) == 2 else pathlib.Path(__file__).resolve().parent / "pelage"
    for name, make in MODULES.items():
        made, file = make(contract), folder / name
        if not file.exists() or file.read_text(encoding="utf-8") != made:
            file.write_text(made, encoding="utf-8")


if __name__ == "__main__":
    main(sys.argv[1:])
