#!/bin/sh
# Runs a GoogleTest program: all its cases or, where PELAGE_EIGHTH is 0 to 7, that eighth of them: eight days pass all.
# usage: share_of_the_day.sh PROGRAM [ARGUMENT...]
set -eu
if [ -n "${PELAGE_EIGHTH:-}" ]; then
  export GTEST_TOTAL_SHARDS=8 GTEST_SHARD_INDEX="$PELAGE_EIGHTH"
fi
exec "$@"
