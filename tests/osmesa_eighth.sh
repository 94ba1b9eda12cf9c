#!/bin/sh
# Runs a GoogleTest program: all its cases or, where PELAGE_OSMESA_EIGHTH is 0 to 7, that eighth of them. OSMesa's
# pictures have the bytes of EGL's, so a change passes an eighth and eight days pass all. usage: osmesa_eighth.sh PROGRAM [ARGUMENT...]
set -eu
if [ -n "${PELAGE_OSMESA_EIGHTH:-}" ]; then
  export GTEST_TOTAL_SHARDS=8 GTEST_SHARD_INDEX="$PELAGE_OSMESA_EIGHTH"
fi
exec "$@"
