#!/usr/bin/env bash
# Installs what the tests need, builds and passes them: the same cases each day. What takes longer is in tests/nightly.sh.
# usage: tests/run.sh [ctest arguments]
set -euo pipefail
cd "$(dirname "$0")/.."

started=$SECONDS
export CCACHE_BASEDIR="$PWD"  # a clean checkout elsewhere finds a part of what was compiled here
deploy/packages.sh test
jobs=$(nproc)
echo "build: optimised, with tests, in build/tests"
cmake --preset tests -DPELAGE_BENCH=OFF -DCMAKE_CXX_COMPILER_LAUNCHER=ccache >/dev/null
cmake --build --preset tests -j "$jobs"
echo "build: done after $((SECONDS - started)) s"
rm -rf build/tests/results
passed=yes no_skips=()
[ "${CI:-}" != true ] || no_skips=(--no-skips)
# One more than there are cores, as tests wait for servers, browsers and clocks: a quarter less time.
RC_PARAMS="seed=1 max_success=25" ctest --preset tests -j $((jobs + 1)) --no-tests=error -LE nightly "$@" || passed=no
echo "tests: done after $((SECONDS - started)) s, packages and build included"
python3 tests/count.py build/tests/results build/tests/ctest.xml "${no_skips[@]}" || passed=no
[ $passed = yes ]
