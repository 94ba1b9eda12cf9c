#!/usr/bin/env bash
# Tests under the address and undefined behaviour sanitizers, and the fuzzer for SECONDS from its corpus.
# usage: tests/sanitizers.sh [SECONDS [SUITE...]]     (30, and all unit, property and end-to-end suites)
set -euo pipefail
cd "$(dirname "$0")/.."

seconds=${1:-30}
shift $(($# > 0 ? 1 : 0))
suites=("$@")
if [ ${#suites[@]} -eq 0 ]; then
  for folder in tests/unit/*/ tests/property/*/; do suites+=("$(basename "$(dirname "$folder")")_$(basename "$folder")"); done
  for folder in clients files grooming node pictures service; do suites+=("end_to_end.$folder"); done
fi
targets=(fuzz_json)
for suite in "${suites[@]}"; do
  case $suite in
    end_to_end.*) targets+=(pelaged pelage pelage-import pelage-render) ;;
    *) targets+=("$suite") ;;
  esac
done
jobs=$(nproc)
export CCACHE_BASEDIR="$PWD"
cmake --preset asan -DCMAKE_CXX_COMPILER_LAUNCHER=ccache >/dev/null
cmake --build --preset asan -j "$jobs" --target "${targets[@]}"
# A sanitizer's own threads do not start where the test lets none start.
PELAGE_SANITIZED=1 GTEST_FILTER=-ParallelDeathTest.* ctest --preset asan -j "$jobs" --no-tests=error -R "^($(IFS='|'; echo "${suites[*]}")|fuzz_json.*)$"

found=$(mktemp -d)
trap 'rm -rf "$found"' EXIT
build/asan/bin/fuzz_json -max_total_time="$seconds" -max_len=4096 -print_final_stats=1 "$found" tests/fuzz/corpus
