#!/usr/bin/env bash
# Draws and traces many random scenes with random knobs. usage: tests/extremes/fuzz.sh CASES [SEED] [PRESET [FILTER]]
# With FuzzWithoutGl.* as FILTER nothing is drawn by a software GL, which would take minutes.
set -euo pipefail
cd "$(dirname "$0")/../.."
cases=${1:?how many cases}
RC_PARAMS="max_success=$cases${2:+ seed=$2} noshrink=1" "build/${3:-tests}/bin/extremes_tests" --gtest_filter="${4:-*AnySceneIsFinite*}"
