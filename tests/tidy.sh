#!/usr/bin/env bash
# clang-tidy over the product's sources as build/tests compiles them, several files of a folder at a time.
# usage: tests/tidy.sh
set -euo pipefail
cd "$(dirname "$0")/.."

[ -f build/tests/compile_commands.json ] || { echo "$0: run tests/run.sh first, which makes build/tests" >&2; exit 2; }
/usr/bin/python3 - <<'PY' | xargs -P "$(nproc)" -n 1 clang-tidy-14 -p build/tests --quiet --extra-arg=-Wno-unknown-warning-option 2>/dev/null
import json
files = sorted(entry["file"] for entry in json.load(open("build/tests/compile_commands.json")))
product = [f for f in files if any(f"/build/tests/{top}/" in f for top in ("base", "protocol", "renderer", "server", "clients")) and "/Unity/" in f]
print("\n".join(product))
PY
echo "clang-tidy: nothing found"
