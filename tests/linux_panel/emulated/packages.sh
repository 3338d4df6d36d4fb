#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
#
# tests/linux_panel/emulated/packages.sh FOLDER: what the emulated board takes of Debian 12's arm64 packages, unpacked into
# FOLDER/root. They are got with the system's sources and keys, but nothing of the system is changed: apt's lists and its
# cache of arm64 are in FOLDER too.
set -euo pipefail
folder=$(mkdir -p "$1" && cd "$1" && pwd)

mkdir -p "$folder/lists/partial" "$folder/cache/archives/partial" "$folder/debs"
options=(-qq -o APT::Architecture=arm64 -o APT::Architectures::=arm64 -o Dir::State::Lists="$folder/lists"
    -o Dir::State::status=/dev/null -o Dir::Cache="$folder/cache" -o APT::Sandbox::User="$(id -un)"
    -o Acquire::Languages=none -o Acquire::Retries=3)

apt-get "${options[@]}" update
kernel=$(apt-cache "${options[@]}" depends linux-image-arm64 | awk '$1 == "Depends:" { print $2; exit }')
[ -n "$kernel" ] || {
    echo "packages.sh: the package sources have no linux-image-arm64" >&2
    exit 1
}
rm -rf "$folder/root" "$folder"/debs/*.deb
(cd "$folder/debs" && apt-get "${options[@]}" download \
    "$kernel" busybox-static libc6 libgpiod2 libgpiod-dev gpiod)
for package in "$folder"/debs/*.deb; do
    # of the kernel's 400 MB: itself and two modules
    wanted=(.)
    case $package in */linux-image-*) wanted=(./boot './lib/modules/*/kernel/drivers/spi') ;; esac
    mkdir -p "$folder/root"
    dpkg --fsys-tarfile "$package" | tar -x -C "$folder/root" --wildcards "${wanted[@]}"
done
rm -rf "$folder/lists" "$folder/cache" "$folder/debs"
echo "$kernel" >"$folder/kernel"
