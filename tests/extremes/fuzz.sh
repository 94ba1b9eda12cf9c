#!/usr/bin/env bash
# Any scenes with any knobs, drawn and traced, many of them. usage: tests/extremes/fuzz.sh CASES [SEED] [PRESET [FILTER]]
# FuzzWithoutGl.* as FILTER leaves out what a software GL would take minutes for.
set -euo pipefail
cd "$(dirname "$0")/../.."
cases=${1:?how many cases}
RC_PARAMS="max_success=$cases${2:+ seed=$2} noshrink=1" "build/${3:-tests}/bin/extremes_tests" --gtest_filter="${4:-*AnySceneIsFinite*}"
