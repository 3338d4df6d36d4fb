/* SPDX-License-Identifier: MIT */
/*
 * The importer of a build without assimp: it always fails, and says what to install.
 */
#include "tools/import/import.h"

#ifndef GLINT_HAVE_ASSIMP

int import_scene(const char *path, imported_scene **out, char *error, size_t error_bytes)
{
    *out = NULL;
    snprintf(
        error, error_bytes,
        "%s: this build cannot read model files; install assimp (Debian and Ubuntu: libassimp-dev) and build again; "
        "the built-in scenes work without it",
        path);
    return -1;
}

#endif
