#!/usr/bin/env bash
# Installs what the tests need, builds and passes all of them but the nightly ones. Of the GL and extreme cases on OSMesa,
# whose pictures have the bytes of EGL's, an eighth runs: of 0 to 7 the one of this day, or N.
# Then clang-tidy over a quarter of the sources, the sanitizers and 30 s of the fuzzer.
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
echo "cases on OSMesa: eighth $eighth (tests/run.sh --eighth $eighth runs it again)"
rm -rf build/tests/results
passed=yes no_skips=()
[ "${CI:-}" != true ] || no_skips=(--no-skips)
PELAGE_OSMESA_EIGHTH=$eighth ctest --preset tests -j "$jobs" --no-tests=error -LE nightly "$@" || passed=no
if [ $# -eq 0 ]; then  # all of them: a quarter of the sources, and what reads bytes from outside also under the sanitizers, and the fuzzer
  tests/tidy.sh $((eighth % 4)) 4 || passed=no
  tests/sanitizers.sh 30 unit_base unit_protocol unit_fields unit_history property_json || passed=no
fi
echo "tests: done after $((SECONDS - started)) s, packages and build included"
python3 tests/count.py build/tests/results "${no_skips[@]}" || passed=no
[ $passed = yes ]
