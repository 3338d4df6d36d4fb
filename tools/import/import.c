/* SPDX-License-Identifier: MIT */
/*
 * import_scene(): from the path to the finished scene, step by step. Parsing is assimp's; everything that decides on
 * numbers is in the files that the steps name. tools/import/README.md has the table of what becomes of what.
 *
 * assimp runs in two passes: the first only parses, so that check.c sees the file's own numbers; the second makes
 * normals, on the polygons of the file (the halves of a quad would count twice), and triangles.
 *
 * Limits: what assimp itself leaks or reads amiss on a broken file is out of reach here.
 */
#include "tools/import/internal.h"

#ifdef GLINT_HAVE_ASSIMP

#include <ctype.h>
#include <errno.h>
#include <stdarg.h>
#include <stdlib.h>
#include <string.h>

#include <assimp/cimport.h>
#include <assimp/config.h>
#include <assimp/postprocess.h>

/* Faces that meet at a smaller angle share a smooth normal where the file has none: sides of a prism of 8 and more are
 * smooth (45 degrees), the edges of a cube and of a hexagonal prism (60 degrees) stay sharp. */
#define SMOOTHING_DEGREES 50.0f

#define MAX_PARSER_WARNINGS 20

int fail(importer *import, const char *format, ...)
{
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(import->error, import->error_bytes, format, arguments);
    va_end(arguments);
    for (char *c = import->error; *c; c++) {
        if (iscntrl((unsigned char)*c)) { /* assimp's messages and names from the file may have more than one line */
            *c = ' ';
        }
    }
    return -1;
}

int fail_memory(importer *import)
{
    return fail(import, "not enough memory for the model");
}

const char *name_of(const struct aiString *name)
{
    return name->length ? name->data : "(unnamed)";
}

/* The kind by the path's ending, in any case; -1 for an unknown one. */
static int kind_of(const char *path)
{
    static const struct {
        const char *ending;
        file_kind kind;
    } kinds[] = {{".obj", FILE_OBJ}, {".gltf", FILE_GLTF}, {".glb", FILE_GLTF}, {".dae", FILE_COLLADA}};
    size_t length = strlen(path);
    for (size_t i = 0; i < sizeof kinds / sizeof *kinds; i++) {
        size_t bytes = strlen(kinds[i].ending);
        size_t same = 0;
        while (same < bytes && length >= bytes &&
               tolower((unsigned char)path[length - bytes + same]) == kinds[i].ending[same]) {
            same++;
        }
        if (same == bytes) {
            return (int)kinds[i].kind;
        }
    }
    return -1;
}

/* Says what is wrong with the file itself, where assimp would only say that it could not read it. */
static int check_path(importer *import, const char *path)
{
    int kind = kind_of(path);
    if (kind < 0) {
        return fail(import, "unknown kind of file; .obj, .gltf, .glb or .dae expected");
    }
    import->kind = (file_kind)kind;
    errno = 0;
    FILE *file = fopen(path, "rb");
    if (!file) {
        return fail(import, "cannot open: %s", strerror(errno));
    }
    int first = fgetc(file); /* fails on a directory */
    int problem = ferror(file) ? errno : 0;
    fclose(file);
    if (problem) {
        return fail(import, "cannot read: %s", strerror(problem));
    }
    if (first == EOF) {
        return fail(import, "the file is empty; a model expected");
    }
    return 0;
}

/*
 * assimp's own warnings ("Warn,  T0: text\n") become ours: that is how a missing MTL is told. glTF faces with an index
 * out of range it drops with no more than a warning, though the file is broken: that is an error here.
 */
static void take_log(const char *message, char *user)
{
    importer *import = (importer *)(void *)user;
    if (strncmp(message, "Warn", 4) != 0 && strncmp(message, "Error", 5) != 0) {
        return;
    }
    import->index_out_of_range = import->index_out_of_range || strstr(message, "out-of-range indices");
    if (import->out->warning_count >= MAX_PARSER_WARNINGS) {
        return;
    }
    const char *text = strstr(message, ": ");
    text = text ? text + 2 : message;
    store_warn(import->out, "assimp: %.*s", (int)strcspn(text, "\n"), text);
}

static int parse(importer *import, const char *path)
{
    struct aiPropertyStore *properties = aiCreatePropertyStore();
    if (!properties) {
        return fail_memory(import);
    }
    aiSetImportPropertyFloat(properties, AI_CONFIG_PP_GSN_MAX_SMOOTHING_ANGLE, SMOOTHING_DEGREES);
    import->file = aiImportFileExWithProperties(path, aiProcess_ValidateDataStructure, NULL, properties);
    aiReleasePropertyStore(properties);
    if (!import->file) {
        const char *reason = aiGetErrorString();
        static const char *const names[] = {"a Wavefront OBJ", "a glTF 2.0", "a COLLADA"};
        if (!reason || !*reason || strncmp(reason, "No suitable reader", 18) == 0) {
            reason = "its contents are not of that format";
        }
        return fail(import, "not %s file that can be read: %s", names[import->kind], reason);
    }
    if (import->index_out_of_range) {
        return fail(import,
                    "a face has a vertex index out of range; indices less than the number of vertices expected");
    }
    return 0;
}

/* glTF 2.0, 3.7.2.1: a primitive without normals has flat ones; those are the zero normals of a glint_mesh. */
static int make_triangles(importer *import)
{
    unsigned steps[2] = {aiProcess_GenSmoothNormals, aiProcess_Triangulate};
    for (int i = import->kind == FILE_GLTF ? 1 : 0; i < 2; i++) {
        const struct aiScene *processed = aiApplyPostProcessing(import->file, steps[i]);
        if (!processed) {
            import->file = NULL; /* assimp has released it */
            return fail(import, "assimp cannot %s: %s", i ? "make triangles" : "make normals", aiGetErrorString());
        }
        import->file = processed;
    }
    return 0;
}

static int run(importer *import, const char *path)
{
    struct aiLogStream log = {take_log, (char *)(void *)import};
    aiAttachLogStream(&log);
    int result = parse(import, path);
    if (!result) {
        result = check_file(import);
    }
    if (!result) {
        result = make_triangles(import);
    }
    aiDetachLogStream(&log);
    if (result || gather_instances(import) || quantise_meshes(import)) {
        return -1;
    }
    find_view(import);
    if (place_objects(import) || make_lights(import)) {
        return -1;
    }
    write_camera(import);
    return 0;
}

int import_scene(const char *path, imported_scene **out, char *error, size_t error_bytes)
{
    *out = NULL;
    char reason[1024] = "";
    importer import = {.error = reason, .error_bytes = sizeof reason, .world_scale = 1, .path = path};
    import.out = store_new();
    int result = import.out ? check_path(&import, path) : fail_memory(&import);
    if (!result) {
        result = run(&import, path);
    }
    aiReleaseImport(import.file); /* NULL is allowed */
    free(import.instances);
    if (result) {
        imported_scene_free(import.out);
        snprintf(error, error_bytes, "%s: %s", path, reason);
        return -1;
    }
    *out = import.out;
    return 0;
}

#endif
