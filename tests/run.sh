#!/usr/bin/env bash
# Installs what the tests need, builds and passes all of them. usage: tests/run.sh [ctest arguments]
set -euo pipefail
cd "$(dirname "$0")/.."

started=$SECONDS
deploy/packages.sh test
jobs=$(nproc)
echo "build: release, with tests"
cmake --preset release -DPELAGE_TESTS=ON -DPELAGE_BENCH=ON -DCMAKE_CXX_COMPILER_LAUNCHER=ccache >/dev/null
cmake --build --preset release -j "$jobs"
echo "build: done after $((SECONDS - started)) s"
ctest --preset release -j "$jobs" --no-tests=error "$@"
echo "tests: done after $((SECONDS - started)) s, packages and build included"
