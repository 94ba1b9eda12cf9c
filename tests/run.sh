#!/usr/bin/env bash
# Installs what the tests need, builds and passes all of them but the nightly ones. Of the GL and extreme cases an eighth
# runs on EGL and on OSMesa: of 0 to 7 the one of this day, or N.
# Then clang-tidy over an eighth of the sources, a quarter of what reads bytes from outside under the sanitizers, and 30 s of
# the fuzzer. Eight days pass all of it; tests/nightly.sh does so in one night.
# usage: tests/run.sh [--eighth N] [ctest arguments]
set -euo pipefail
cd "$(dirname "$0")/.."

eighth=$(($(date +%s) / 86400 % 8))
if [ "${1:-}" = --eighth ]; then eighth=${2:?--eighth needs 0 to 7}; shift 2; fi
case $eighth in [0-7]) ;; *) echo "$0: --eighth needs 0 to 7" >&2; exit 2 ;; esac

started=$SECONDS
export CCACHE_BASEDIR="$PWD"  # a clean checkout elsewhere finds what was compiled here
deploy/packages.sh test
jobs=$(nproc)
echo "build: optimised, with tests, in build/tests"
cmake --preset tests -DPELAGE_BENCH=OFF -DCMAKE_CXX_COMPILER_LAUNCHER=ccache >/dev/null
cmake --build --preset tests -j "$jobs"
echo "build: done after $((SECONDS - started)) s"
echo "cases of GL: eighth $eighth (tests/run.sh --eighth $eighth runs it again)"
rm -rf build/tests/results
passed=yes no_skips=()
[ "${CI:-}" != true ] || no_skips=(--no-skips)
PELAGE_EIGHTH=$eighth ctest --preset tests -j "$jobs" --no-tests=error -LE nightly "$@" || passed=no
if [ $# -eq 0 ]; then  # all of them
  tests/tidy.sh "$eighth" 8 || passed=no
  quarters=("unit_base unit_protocol" "unit_history" "property_json" "unit_fields unit_guides")
  read -ra quarter <<< "${quarters[eighth % 4]}"
  tests/sanitizers.sh 30 "${quarter[@]}" || passed=no
fi
echo "tests: done after $((SECONDS - started)) s, packages and build included"
python3 tests/count.py build/tests/results "${no_skips[@]}" || passed=no
[ $passed = yes ]
