#!/usr/bin/env bash
# Builds the package for Debian 12: build/release/pelage_VERSION_ARCHITECTURE.deb. usage: deploy/package/build.sh
set -euo pipefail
cd "$(dirname "$0")/../.."
deploy/packages.sh package
cmake --preset release -DCMAKE_CXX_COMPILER_LAUNCHER=ccache >/dev/null
cmake --build --preset release -j "$(nproc)"
(cd build/release && rm -f pelage_*.deb && cpack --config CPackConfig.cmake)
