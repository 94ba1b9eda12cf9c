#!/usr/bin/env bash
# Builds the container image with buildah and tries it: serve, groom, draw. The Debian 12 that it begins with is put
# together here, so that no registry is asked. Needs root and minutes. usage: tests/container.sh [PICTURE]
set -euo pipefail
cd "$(dirname "$0")/.."

picture=${1:-}
{ command -v buildah && command -v mmdebstrap; } >/dev/null || apt-get -qq install -y --no-install-recommends buildah mmdebstrap >/dev/null
store=$(mktemp -d --suffix=-pelage-container)
server=
clean_up() {
  [ -z "$server" ] || kill -- "-$server" 2>/dev/null || true  # buildah's helpers and the server are its group
  build rm --all >/dev/null 2>&1 || true
  rm -rf --one-file-system "$store"
}
trap clean_up EXIT
buildah=(buildah --root "$store/images" --runroot "$store/run" --storage-driver vfs)
build() { "${buildah[@]}" "$@"; }
export BUILDAH_ISOLATION=chroot

echo "container: a bare Debian 12"
mmdebstrap --quiet --variant=minbase bookworm "$store/debian.tar"
debian=$(build from scratch)
build add -q "$debian" "$store/debian.tar" / >/dev/null
if [ -n "${NODE_EXTRA_CA_CERTS:-}" ]; then  # what this machine's npm trusts
  build add -q "$debian" "$NODE_EXTRA_CA_CERTS" /certificates.pem >/dev/null
  build config --env NODE_EXTRA_CA_CERTS=/certificates.pem "$debian"
fi
build commit -q "$debian" docker.io/library/debian:12 >/dev/null
echo "container: the image"
build build --pull-never --ignorefile deploy/container/Containerfile.dockerignore -f deploy/container/Containerfile -t pelage .

container=$(build from --pull-never localhost/pelage)
entry=$(build inspect --type container --format '{{range .OCIv1.Config.Entrypoint}}{{.}} {{end}}' "$container")
echo "container: $entry"
# Chroot has the network of the machine: a free port, where the image has its own 8080.
setsid "${buildah[@]}" run "$container" -- ${entry/0.0.0.0:8080/127.0.0.1:0} >"$store/server.log" 2>&1 &
server=$!
for _ in $(seq 300); do grep -q 'http://' "$store/server.log" && break; sleep 0.1; done
address=$(grep -o 'http://[0-9.:]*' "$store/server.log")
in_container() { build run --env "PELAGE_SERVER=$address" "$container" -- "$@"; }
[ "$(in_container id -u)" != 0 ] || { echo "container: it runs as root" >&2; exit 1; }
in_container pelage new --name fox
in_container pelage run fox /usr/share/pelage/recipes/portrait_light.json
in_container pelage frame fox -o - --width 640 --height 640 --quality detailed >"$store/fox.png"
[ -z "$picture" ] || cp "$store/fox.png" "$picture"
echo "container: built, served, groomed and drawn"
