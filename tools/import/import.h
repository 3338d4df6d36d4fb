/* SPDX-License-Identifier: MIT */
/*
 * Reads a model file into a glint_scene, and writes a glint_scene as C source for firmware. For host tools only.
 *
 * Files: Wavefront .obj with .mtl, glTF 2.0 (.gltf, .glb) and COLLADA .dae, parsed by assimp. What becomes of each
 * quantity in them is in the table of tools/import/README.md. Built without assimp (GLINT_HAVE_ASSIMP not defined),
 * import_scene() always fails, with a message that names the package to install.
 *
 * Limits: static geometry only, one camera, textures of the diffuse colour only, no transparency; what is left out is
 * told as a warning. Not for several threads at once, as assimp's log streams are global.
 */
#ifndef GLINT_TOOLS_IMPORT_H
#define GLINT_TOOLS_IMPORT_H

#include <stddef.h>
#include <stdint.h>
#include <stdio.h>

#include <glint/scene.h>

/* An imported scene with all that it points to. */
typedef struct imported_scene imported_scene;

/* What the import cost in accuracy, and how much there is. An object with several meshes counts once for each. */
typedef struct import_report {
    uint32_t meshes, objects, materials, lights;
    uint64_t vertices, triangles; /* in the meshes; one that is used twice counts once */
    uint64_t flash_bytes;         /* of positions, normals, texture coordinates, triangles and textures */

    /* Distance from the position in the file to the quantised one, over all vertices, and the same relative to the
     * diagonal of the bounding box of the mesh. Normals: the angle to the unit normal of the file. */
    double position_max_units, position_rms_units; /* in the units of the file's mesh, before its node's matrix */
    double position_max_relative, position_rms_relative;
    double normal_max_degrees, normal_rms_degrees;

    double world_scale;   /* world units of the scene for one of the file's: 1, or a power of two where the file's
                           * coordinates are beyond what a glint_place holds, or too small for its step of 2^-16 */
    double centre[3];     /* of the bounding box of all objects, in world units */
    double radius;        /* greatest distance of a vertex from the centre: the camera's near plane is safe for any
                           * turn of the objects about the centre when the eye is outside of this sphere */
    uint64_t dropped;     /* degenerate triangles, before or after quantisation */
    uint64_t t_junctions; /* vertices inside another triangle's edge; meshes of very many open edges are not looked
                           * through (see tools/import/README.md) */
} import_report;

/*
 * Reads `path`. Returns 0 and the scene, to be freed with imported_scene_free(); or -1, `*out` NULL and in `error` (of
 * `error_bytes` > 0, always terminated) a sentence without newline that says what is wrong and what was expected.
 */
int import_scene(const char *path, imported_scene **out, char *error, size_t error_bytes);

/* The scene and its report; valid until the imported scene is freed. */
const glint_scene *imported_scene_view(const imported_scene *scene);
const import_report *imported_scene_report(const imported_scene *scene);

/* What the scene could not take over from the file, one sentence each, for the tools to print on stderr. */
size_t imported_scene_warning_count(const imported_scene *scene);
const char *imported_scene_warning(const imported_scene *scene, size_t index); /* index < the count */

/* NULL is allowed. */
void imported_scene_free(imported_scene *scene);

/*
 * Writes `scene` as C99 source that defines `const glint_scene PREFIX_scene` from static const data. `prefix` is a C
 * identifier. `command` becomes the comment on the first line. `header`: the name for an #include of the header that
 * declares the scene, or NULL. Works for every scene, and without assimp. Returns 0, or -1 when writing failed (errno).
 */
int import_write_c(FILE *file, const glint_scene *scene, const char *prefix, const char *command, const char *header);

/* Writes the header that declares PREFIX_scene, for C and C++. Returns as above. */
int import_write_header(FILE *file, const char *prefix, const char *command);

#endif
