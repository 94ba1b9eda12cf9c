#!/usr/bin/env bash
# Installs Debian 12 packages that are missing. usage: deploy/packages.sh build|package|demo|test
set -euo pipefail

build=(build-essential cmake ninja-build pkg-config ccache python3 python3-yaml glslang-tools
  libglm-dev libegl-dev libosmesa6-dev libegl1 libegl-mesa0 libgl1-mesa-dri libosmesa6
  libcpp-httplib-dev nlohmann-json3-dev libopenimageio-dev libwebp-dev zlib1g-dev libtinyobjloader-dev libassimp-dev libzip-dev libembree-dev libtbb-dev libeigen3-dev libmeshoptimizer-dev libhwy-dev
  libsqlite3-dev libcli11-dev libspdlog-dev libfmt-dev libseccomp-dev)
package=("${build[@]}" file git)  # CPack finds programs by `file`; the version has the commit from git
demo=("${build[@]}" glmark2-data openimageio-tools)
test=("${demo[@]}" libgtest-dev librapidcheck-dev python3-pil python3-numpy python3-openimageio python3-jsonschema mypy python3-pip curl
  slurm-wlm munge ffmpeg
  clang-14 libclang-rt-14-dev clang-format-14 clang-tidy-14 chromium)

case "${1:-}" in
  build) wanted=("${build[@]}") ;;
  package) wanted=("${package[@]}") ;;
  demo) wanted=("${demo[@]}") ;;
  test) wanted=("${test[@]}") ;;
  *) echo "usage: $0 build|package|demo|test" >&2; exit 2 ;;
esac

# The studio needs Node.js 18 or newer with npm; any that is installed will do, Debian's or not.
major=$({ node --version 2>/dev/null || true; } | sed -n 's/^v\([0-9]*\).*/\1/p')
if ! { [ "${major:-0}" -ge 18 ] && command -v npm >/dev/null; }; then wanted+=(nodejs npm); fi

missing=()
for package in "${wanted[@]}"; do
  dpkg-query -W -f='${db:Status-Status}' "$package" 2>/dev/null | grep -q '^installed$' || missing+=("$package")
done
if [ ${#missing[@]} -eq 0 ]; then echo "packages: all ${#wanted[@]} are there"; exit 0; fi

echo "packages: installing ${missing[*]}"
as_root=()
[ "$(id -u)" -eq 0 ] || as_root=(sudo)
for try in 1 2 3; do
  if "${as_root[@]}" apt-get -qq update &&
     "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get -qq install -y --no-install-recommends "${missing[@]}" >/dev/null; then
    exit 0
  fi
  echo "packages: try $try failed, once more in $((try * 5)) s" >&2
  sleep $((try * 5))
done
echo "packages: cannot install ${missing[*]}; is the network there, and are Debian 12's sources set up?" >&2
exit 1
