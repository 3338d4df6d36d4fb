#!/bin/sh
# SPDX-License-Identifier: MIT
#
# Replaces what stands in a document between a line <!-- NAME: ... --> and the next <!-- end -->:
#
#     tools/replace-marked.sh DOCUMENT NAME TEXTFILE
set -eu

if ! grep -q "^<!-- $2: " "$1"; then
    echo "$1 has no line <!-- $2: ... -->" >&2
    exit 1
fi
awk -v name="$2" -v text="$3" '
    /^<!-- end -->/ { inside = 0 }
    !inside { print }
    index($0, "<!-- " name ": ") == 1 {
        inside = 1
        print ""
        while ((getline line < text) > 0) { print line }
        print ""
    }' "$1" >"$1.new"
mv "$1.new" "$1"
