#!/usr/bin/env bash
# Makes the packages of Debian, installs them in a bare system, runs their tests there, and removes them: no file may
# be left that was not there before.
#
#   packaging/tests/test_debian_packages.sh FOLDER [FOLDER_OF_PACKAGES]
#
# FOLDER is made anew, and holds the bare system while the test runs. Packages that are there already are tried in the place of
# new ones. Root alone may do this; where something is missing the test is skipped (77).
set -euo pipefail

folder=$1 packages=${2:-}
source=$(cd "$(dirname "$0")/../.." && pwd)
skip() { echo "SKIPPED: $*" && exit 77; }
[ "$(id -u)" -eq 0 ] || skip "a bare system is made by root"
for program in dpkg-buildpackage dh debootstrap; do
  command -v "$program" >/dev/null || skip "$program is not here: scripts/install_dependencies.sh packages"
done

rm -rf "$folder"
mkdir -p "$folder"
folder=$(cd "$folder" && pwd)
root=$folder/system
if [ -z "$packages" ]; then
  packages=$folder/packages
  "$source/scripts/make_debian_packages.sh" "$packages"
fi

release=$(. /etc/os-release && echo "$VERSION_CODENAME")
clean() {
  umount "$root/proc" 2>/dev/null || true
  rm -rf "$root"
}
trap clean EXIT
debootstrap --variant=minbase "$release" "$root" >"$folder/debootstrap.log" ||
  { tail "$folder/debootstrap.log" && skip "no bare system could be made"; }
mount -t proc proc "$root/proc"

within() { chroot "$root" env -i PATH=/usr/sbin:/usr/bin:/sbin:/bin HOME=/root LC_ALL=C.UTF-8 DEBIAN_FRONTEND=noninteractive "$@"; }
apt() { within apt-get --quiet --quiet --yes --no-install-recommends -o Dpkg::Use-Pty=0 "$@"; }

# What our packages want of others is installed first, and stays: only what they bring themselves is looked at.
mkdir "$root/packages" "$root/tests"
cp "$packages"/*.deb "$root/packages"
cp -r "$source/packaging/debian/tests/." "$root/tests"
mkdir -p "$root/source/examples/Handle_tunnel_loops"
cp "$source/README.md" "$root/source"
cp -r "$source/examples/Handle_tunnel_loops/data" "$root/source/examples/Handle_tunnel_loops"
apt update
fields() { for package in "$packages"/*.deb; do dpkg-deb --field "$package" "$1"; done; }
names() { tr ',' '\n' | sed 's/^ *//; s/[ (].*//' | grep -v '^$' | sort -u; }
mapfile -t ours < <(fields Package)
mapfile -t wanted < <({ fields Depends && sed -n 's/^Depends: //p' "$source/packaging/debian/tests/control"; } | names |
  grep -vxF "$(printf '%s\n' "${ours[@]}")")
apt install "${wanted[@]}" >/dev/null

# Names of all files but those that keep the state of the system.
listed() {
  within find / -xdev \( -path /proc -o -path /tmp -o -path /var/lib/dpkg -o -path /var/lib/apt -o -path /var/cache \
    -o -path /var/log -o -path /packages -o -path /tests -o -path /source -o -path '*/__pycache__' \) -prune -o -print | sort
}
listed >"$folder/before.txt"

within sh -c 'dpkg --install /packages/*.deb'
listed >"$folder/installed.txt"
[ "$(comm -13 "$folder/before.txt" "$folder/installed.txt" | wc -l)" -gt 300 ] ||
  { echo "Hardly any file was installed" >&2 && exit 1; }
for test in tool program-of-readme module; do
  echo "Test: $test"
  within sh -c 'rm -rf /tmp/test && mkdir /tmp/test && cd /source && AUTOPKGTEST_TMP=/tmp/test "/tests/$1"' sh "$test"
done

within dpkg --purge "${ours[@]}"
listed >"$folder/after.txt"
diff "$folder/before.txt" "$folder/after.txt" ||
  { echo "Files are left, or gone, after the packages were removed: see above" >&2 && exit 1; }
echo "Installed, used and removed: no file is left"
