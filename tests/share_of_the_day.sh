#!/bin/sh
# Runs a GoogleTest program: all its cases or, where PELAGE_EIGHTH is 0 to 7, one of as many parts as asked, by that
# number: eight days pass all. OSMesa's pictures have the bytes of EGL's, so it takes eighths where EGL takes quarters.
# usage: share_of_the_day.sh PARTS PROGRAM [ARGUMENT...]
set -eu
parts=$1
shift
if [ -n "${PELAGE_EIGHTH:-}" ]; then
  export GTEST_TOTAL_SHARDS="$parts" GTEST_SHARD_INDEX=$((PELAGE_EIGHTH % parts))
fi
exec "$@"
