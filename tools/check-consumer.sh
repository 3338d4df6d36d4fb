#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
#
# Builds and runs one source as a C and as a C++ program against an installed copy of the library, finding it with
# pkg-config as any user would; and with it, as C, the backend with parts of a user's own:
#
#     tools/check-consumer.sh PREFIX SOURCE PARTS_SOURCE
set -euo pipefail

prefix=$1
source=$2
parts=$3
export PKG_CONFIG_PATH=$prefix/lib/pkgconfig
read -ra flags <<<"$(pkg-config --cflags --libs glint)"
strict=(-pedantic -Wall -Wextra -Wconversion -Wshadow -Werror)

# Only the installed headers are in the search path, so a header that was not installed is missed here.
gcc -std=c99 "${strict[@]}" -c "$parts" "${flags[@]}" -o "$prefix/consumer-parts.o"

build_and_run() {
    local language=$1
    shift
    "$@" "${strict[@]}" "$source" -x none "$prefix/consumer-parts.o" "${flags[@]}" -o "$prefix/consumer-$language"
    "$prefix/consumer-$language"
    echo "$language program: built against glint $(pkg-config --modversion glint), ran"
}
build_and_run c gcc -std=c99 -x c
build_and_run c++ g++ -std=c++11 -x c++
