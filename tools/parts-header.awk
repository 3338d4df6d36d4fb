# SPDX-License-Identifier: MIT
#
# Joins a backend's bodies into one header that a user compiles with a choice of parts, see include/glint/parts.h:
#
#     awk -v backend=fixed -f tools/parts-header.awk >glint/fixed_parts.h
#
# What src/backend/BACKEND.inc includes from src/ is put in its place, each header once; <...> stay as they are.

function take(file,    line, name, path) {
    path = "src/" file
    while ((getline line < path) > 0) {
        if (line ~ /^#include "/) {
            split(line, name, "\"")
            if (name[2] ~ /\.inc$/ || !(name[2] in taken)) {
                taken[name[2]] = 1
                take(name[2])
            }
        } else {
            print line
        }
        read++
    }
    if (close(path) != 0 || read == 0) {
        print "parts-header: cannot read " path > "/dev/stderr"
        exit failed = 1
    }
}

BEGIN {
    print "/* awk -v backend=" backend " -f tools/parts-header.awk */"
    print "/* The " backend " backend with the parts of GLINT_PARTS, see <glint/parts.h>. For one file of a program. */"
    print "#ifndef GLINT_PARTS"
    print "#error \"name the parts first: #define GLINT_PARTS (GLINT_PART_SPECULAR | ...), see glint/parts.h\""
    print "#endif"
    print "#ifdef __cplusplus"
    print "#error \"this header is C: include it in a C file of its own and call its functions from C++\""
    print "#endif"
    print "#ifdef __GNUC__"
    print "#pragma GCC system_header /* no warnings of functions that a choice of parts does not call */"
    print "#endif"
    print "#ifndef BACKEND_NAME"
    print "#define BACKEND_NAME(name) glint_" backend "_parts_##name"
    print "#endif"
    take("backend/" backend ".inc")
    exit failed
}
