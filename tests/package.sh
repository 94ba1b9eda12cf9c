#!/usr/bin/env bash
# Builds the Debian package and tries it in a bare Debian 12, as a user would: install, serve, groom, draw, remove, and
# nothing of it is left. Needs root and minutes. usage: tests/package.sh [PICTURE]     PICTURE: where a frame is left
set -euo pipefail
cd "$(dirname "$0")/.."

picture=${1:-}
root=$(mktemp -d --suffix=-pelage-root)
clean_up() {
  umount "$root/proc" 2>/dev/null || true
  rm -rf --one-file-system "$root"
}
trap clean_up EXIT

deploy/package/build.sh
command -v mmdebstrap >/dev/null || apt-get -qq install -y --no-install-recommends mmdebstrap >/dev/null
echo "package: a bare Debian 12"
mmdebstrap --quiet --variant=minbase bookworm "$root"
mount -t proc proc "$root/proc"
cp /etc/resolv.conf "$root/etc/"
cp build/release/pelage_*.deb "$root/tmp/pelage.deb"
cp tests/package/groom.sh "$root/tmp/"
in_root() { env -i PATH=/usr/sbin:/usr/bin:/sbin:/bin HOME=/root LANG=C.UTF-8 DEBIAN_FRONTEND=noninteractive chroot "$root" "$@"; }
files() { in_root find / -xdev \( -path /proc -o -path /dev -o -path /tmp -o -path /var/lib/dpkg -o -path /var/log -o -path /var/cache \) -prune -o -print | sort; }

in_root apt-get -qq update
in_root apt-get -qq install -y --no-install-recommends /tmp/pelage.deb >/dev/null
in_root dpkg --purge pelage >/dev/null  # its dependencies stay
files >"$root/tmp/before"
in_root dpkg -i /tmp/pelage.deb
in_root bash /tmp/groom.sh
in_root dpkg -r pelage
files >"$root/tmp/after"
diff "$root/tmp/before" "$root/tmp/after" || { echo "package: files are left" >&2; exit 1; }
[ -z "$picture" ] || cp "$root/tmp/fox.png" "$picture"
echo "package: installed, tried and removed; nothing is left"
