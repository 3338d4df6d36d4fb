#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
#
# Draws every built-in scene with the fixed backend in each build and at each band height, and compares the SHA-256 of
# the pictures: tools/check-bit-identical.sh FOLDER BUILD..., with FOLDER/BUILD/glint-render for each.
set -euo pipefail

folder=$1
shift
bands=(1 7 16 full)
status=0
out=$folder/picture.ppm

scenes=$("$folder/$1/glint-render" --list | awk '{ print $1 }')
[ -n "$scenes" ] || {
    echo "no built-in scene" >&2
    exit 1
}
printf '%-24s %-9s %s\n' scene pictures "SHA-256"
for scene in $scenes; do
    sums=
    pictures=0
    for build in "$@"; do
        for band in "${bands[@]}"; do
            rows=(--band "$band")
            [ "$band" != full ] || rows=()
            "$folder/$build/glint-render" "$scene" -o "$out" --backend fixed --shading exact --format rgb888 "${rows[@]}"
            sum=$(sha256sum <"$out")
            sums+="${sum%% *} $build band $band"$'\n'
            pictures=$((pictures + 1))
        done
    done
    distinct=$(awk 'NF { print $1 }' <<<"$sums" | sort | uniq -c | sort -rn)
    if [ "$(wc -l <<<"$distinct")" -eq 1 ]; then
        printf '%-24s %-9d %s\n' "$scene" "$pictures" "$(awk '{ print $2 }' <<<"$distinct")"
    else
        printf '%-24s %-9d DIFFER\n' "$scene" "$pictures"
        sort <<<"$sums" | sed '/^$/d; s/^/    /'
        status=1
    fi
done
rm -f "$out"
exit $status
