#!/usr/bin/env bash
# Draws a picture of 8192 x 8192 and a model of a million triangles on both backends, which takes minutes and gigabytes.
# usage: tests/extremes/large.sh [PRESET]
set -euo pipefail
cd "$(dirname "$0")/../.."
cmake --build --preset "${1:-tests}" --target extremes_large
"build/${1:-tests}/bin/extremes_large"
