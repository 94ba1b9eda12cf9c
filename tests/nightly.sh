#!/usr/bin/env bash
# What takes too long for each change: all tests with all cases on each GL, that benchmarks build, the soak, many fuzzed
# scenes, the Debian package in a bare system, the container, clang-tidy over all sources, all suites under the sanitizers, and ten
# minutes of the fuzzer.
# usage: tests/nightly.sh [SEED]
set -euo pipefail
cd "$(dirname "$0")/.."

seed=${1:-$(($(date +%s) / 86400))}
jobs=$(nproc)
export CCACHE_BASEDIR="$PWD"
echo "nightly: seed $seed"
deploy/packages.sh test
cmake --preset tests -DPELAGE_BENCH=ON -DCMAKE_CXX_COMPILER_LAUNCHER=ccache >/dev/null
cmake --build --preset tests -j "$jobs"
ctest --preset tests -j "$jobs" --no-tests=error
python3 tests/count.py build/tests/results build/tests/ctest.xml
tests/extremes/fuzz.sh 1000 "$seed"
tests/package.sh
tests/container.sh

tests/tidy.sh
tests/sanitizers.sh 600
