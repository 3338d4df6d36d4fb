#!/bin/sh
# SPDX-License-Identifier: MIT
# Writes tests/image/golden_hashes.h from what the fixed backend draws now: write-golden.sh BUILD. Run by `make golden`.
# Look at the pictures of `make demo` before committing the result.
set -eu
build=$1
target=tests/image/golden_hashes.h
{
    printf '/* Made by: make golden */\n/* SPDX-License-Identifier: MIT */\n/* clang-format off */\n'
    printf '/* FNV-1a, 64 bits, of each built-in scene at its own size in RGB888: exact, Gouraud, flat;\n * tolerance 1 and 4; q2. */\n'
    printf '#ifndef GLINT_TESTS_IMAGE_GOLDEN_HASHES_H\n#define GLINT_TESTS_IMAGE_GOLDEN_HASHES_H\n\n#include <stdint.h>\n\n'
    printf 'static const struct {\n    const char *scene;\n    uint64_t hash[6];\n} golden_hashes[] = {\n'
    GLINT_GOLDEN=write "$build/tests/image/test_same_image" 2>/dev/null | sed -n 's/^.*GOLDEN  *{/    {/p'
    printf '};\n\n#define GOLDEN_COUNT (sizeof golden_hashes / sizeof *golden_hashes)\n\n#endif\n'
} >"$target.part"
mv "$target.part" "$target"
