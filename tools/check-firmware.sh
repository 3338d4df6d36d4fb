#!/usr/bin/env bash
# SPDX-License-Identifier: MIT
#
# Looks at the symbols of a linked firmware that uses the fixed backend on a processor without floating-point unit:
# tools/check-firmware.sh NM FILE.elf. Fails if it holds anything that the library promises not to need.
set -euo pipefail

nm=$1
elf=$2
symbols=$("$nm" --defined-only "$elf" | awk '{ print $3 }' | sort -u)
status=0

# forbid WHAT PATTERN (extended regular expression over whole names)
forbid() {
    local found
    if found=$(grep -Ex -- "$2" <<<"$symbols"); then
        echo "$elf holds $1:" $found >&2
        status=1
    else
        echo "none of $1"
    fi
}

grep -qx glint_fixed_render <<<"$symbols" || {
    echo "$elf does not call glint_fixed_render(), so it shows nothing" >&2
    exit 1
}
forbid "the heap" '_*(malloc|calloc|realloc|free|sbrk)(_r)?'
forbid "libm" '(a?(sin|cos|tan)h?|atan2|sqrt|cbrt|pow|exp2?|expm1|log(2|10|1p)?|f(abs|mod|ma|loor)|ceil|l?l?r(int|ound)|trunc|ldexp|frexp|hypot)f?'
forbid "the float backend" 'glint_float_.*'
# Run-time ABI for the Arm Architecture, 4.1.2: fadd, dmul, i2f, f2iz, d2f ...; and libgcc's own names.
forbid "soft float" '__aeabi_([fd](add|sub|rsub|mul|div|cmp.*|2.*)|c[fd](r?cmp.*)|u?[il]2[fd]|[hf]2.*)|__(add|sub|mul|div|neg|eq|ne|lt|le|gt|ge|unord|fix|fixuns|float|floatun|extend|trunc)[a-z]*[sdt]f[a-z0-9]*'
# Some 700 bytes of flash and hundreds of cycles a division.
forbid "64-bit division" '__aeabi_u?ldivmod|__u?(div|mod)(mod)?di[34]'
exit $status
