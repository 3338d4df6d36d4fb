/* SPDX-License-Identifier: MIT */
/*
 * An import_scene() that calls assimp as tools/import/import.c does, releases the model and looks at nothing: the same
 * calls in the same order, with the same flags and properties. Linked with fuzz_import.c in place of the importer it
 * reads the same bytes from files of the same names, so what leaks here is lost by assimp itself (run-import.sh).
 *
 * The importer gives up after the first pass where check_file() refuses the model, and else goes on to the second.
 * Which of the two is not decided here but by FUZZ_ASSIMP_PASSES in the environment: 1, or 2 (also when it is not set).
 *
 * Limits: a change of the calls in import.c has to be made here too. When it is forgotten the leaks no longer agree,
 * and run-import.sh calls them this project's: the error is loud.
 */
#include <stdlib.h>
#include <string.h>

#include "tools/import/import.h"

#ifdef GLINT_HAVE_ASSIMP

#include <assimp/cimport.h>
#include <assimp/config.h>
#include <assimp/postprocess.h>
#include <assimp/scene.h>

#define SMOOTHING_DEGREES 50.0f

/* import.c takes any index that assimp finds out of range for an error, and then stops after the first pass. */
static void ignore_log(const char *message, char *user)
{
    (void)message;
    (void)user;
}

static const struct aiScene *parse(const char *path)
{
    struct aiPropertyStore *properties = aiCreatePropertyStore();
    if (!properties) {
        return NULL;
    }
    aiSetImportPropertyFloat(properties, AI_CONFIG_PP_GSN_MAX_SMOOTHING_ANGLE, SMOOTHING_DEGREES);
    const struct aiScene *file = aiImportFileExWithProperties(path, aiProcess_ValidateDataStructure, NULL, properties);
    aiReleasePropertyStore(properties);
    return file;
}

/* NULL when assimp failed; it has then released the model. */
static const struct aiScene *make_triangles(const struct aiScene *file, const char *path)
{
    const char *ending = strrchr(path, '.');
    const int is_gltf = ending && (strcmp(ending, ".gltf") == 0 || strcmp(ending, ".glb") == 0);
    if (!is_gltf) {
        file = aiApplyPostProcessing(file, aiProcess_GenSmoothNormals);
    }
    return file ? aiApplyPostProcessing(file, aiProcess_Triangulate) : NULL;
}

int import_scene(const char *path, imported_scene **out, char *error, size_t error_bytes)
{
    const char *passes = getenv("FUZZ_ASSIMP_PASSES");
    struct aiLogStream log = {ignore_log, NULL};
    aiAttachLogStream(&log);
    const struct aiScene *file = parse(path);
    if (file && (!passes || strcmp(passes, "1") != 0)) {
        file = make_triangles(file, path);
    }
    aiDetachLogStream(&log);
    aiReleaseImport(file); /* NULL is allowed */
    *out = NULL;
    (void)snprintf(error, error_bytes, "%s: read by assimp alone", path);
    return -1;
}

#endif
