#!/usr/bin/env bash
# Installs what the tests need, builds and passes all of them. usage: tests/run.sh [ctest arguments]
set -euo pipefail
cd "$(dirname "$0")/.."

started=$SECONDS
export CCACHE_BASEDIR="$PWD"  # a clean checkout elsewhere finds what was compiled here
deploy/packages.sh test
jobs=$(nproc)
echo "build: optimised, with tests, in build/tests"
cmake --preset tests -DCMAKE_CXX_COMPILER_LAUNCHER=ccache >/dev/null
cmake --build --preset tests -j "$jobs"
echo "build: done after $((SECONDS - started)) s"
ctest --preset tests -j "$jobs" --no-tests=error "$@"
echo "tests: done after $((SECONDS - started)) s, packages and build included"
