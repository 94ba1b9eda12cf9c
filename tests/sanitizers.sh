#!/usr/bin/env bash
# Unit and property tests under the address and undefined behaviour sanitizers, and the fuzzer for SECONDS from its corpus.
# usage: tests/sanitizers.sh [SECONDS]
set -euo pipefail
cd "$(dirname "$0")/.."

seconds=${1:-30}
jobs=$(nproc)
export CCACHE_BASEDIR="$PWD"
cmake --preset asan -DCMAKE_CXX_COMPILER_LAUNCHER=ccache >/dev/null
targets=(fuzz_json)
for folder in tests/unit/*/ tests/property/*/; do
  targets+=("$(basename "$(dirname "$folder")")_$(basename "$folder")")
done
cmake --build --preset asan -j "$jobs" --target "${targets[@]}"
ctest --preset asan -j "$jobs" --no-tests=error -R '^(unit|property|fuzz)_'

found=$(mktemp -d)
trap 'rm -rf "$found"' EXIT
build/asan/bin/fuzz_json -max_total_time="$seconds" -max_len=4096 -print_final_stats=1 "$found" tests/fuzz/corpus
