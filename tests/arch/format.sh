#!/usr/bin/env bash
# Checks that every C++ file is formatted by clang-format (.clang-format). usage: format.sh ROOT [--fix]
set -euo pipefail
cd "$1"
how=(--dry-run -Werror)
[ "${2:-}" != --fix ] || how=(-i)
git ls-files -z '*.cpp' '*.h' | xargs -0 -n 32 -P "$(nproc)" clang-format-14 "${how[@]}" ||
  { echo "format: run tests/arch/format.sh . --fix" >&2; exit 1; }
