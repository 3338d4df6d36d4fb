/* SPDX-License-Identifier: MIT */
/*
 * What the parts of the importer share: the scene under construction and the steps that fill it. In the order of the
 * calls in import.c: check, gather, quantise, view, place, materials, lights.
 */
#ifndef GLINT_TOOLS_IMPORT_INTERNAL_H
#define GLINT_TOOLS_IMPORT_INTERNAL_H

#include <stdbool.h>

#include "tools/import/import.h"

#if defined(__GNUC__)
#define PRINTF_LIKE(text, first) __attribute__((format(printf, text, first)))
#else
#define PRINTF_LIKE(text, first)
#endif

#define FIXED_ONE_Q16 65536.0
#define FIXED_ONE_Q14 16384.0
#define ORIGIN_LIMIT 16384.0 /* greatest world coordinate of a glint_place, glint_light and glint_camera */
#define LINEAR_LIMIT 1024.0  /* greatest entry of a glint_place's matrix */
#define PI 3.14159265358979323846

/* store.c: the imported scene's memory and warnings */

struct imported_scene {
    glint_scene scene;
    glint_camera camera;
    import_report report;
    char **warnings;
    size_t warning_count, warning_room;
    void **blocks; /* all else that the scene owns */
    size_t block_count, block_room;
};

imported_scene *store_new(void);
/* Zeroed memory that lives as long as the scene; NULL when there is none. */
void *store_take(imported_scene *scene, size_t count, size_t bytes);
/* Adds a warning; without memory it is lost. */
void store_warn(imported_scene *scene, const char *format, ...) PRINTF_LIKE(2, 3);
/* Grows `*array` so that index `count` is there; false without memory. */
bool store_grow(void **array, size_t count, size_t *room, size_t bytes);

#ifdef GLINT_HAVE_ASSIMP

#include <assimp/scene.h>

typedef struct matrix34 {
    double entry[3][4]; /* rows of an affine matrix, the origin in the last column */
} matrix34;

/* One use of a mesh by a node. */
typedef struct instance {
    unsigned mesh; /* of the file */
    matrix34 world;
    const char *name; /* of the node */
} instance;

/*
 * A mesh of the file after quantisation: model = centre + integer / 2^exponent. It takes several glint_mesh where it
 * has more than 65,535 vertices or triangles.
 */
typedef struct quantised {
    bool used;
    int exponent;
    int unit_log2; /* the place multiplies by 2^unit_log2, the glint_mesh has as many fraction bits more */
    double centre[3];
    glint_mesh *parts; /* in memory of the scene */
    unsigned part_count;
    unsigned grid; /* meshes of one number share exponent, centre and unit */
} quantised;

/* The camera in world units of the file, before it is put into a glint_camera. */
typedef struct view {
    double eye[3], forward[3], up[3]; /* unit vectors */
    double distance;                  /* to the target */
    double near_plane;
    double field_of_view; /* vertical, radians */
    bool from_file;
} view;

typedef enum file_kind { FILE_OBJ, FILE_GLTF, FILE_COLLADA } file_kind;

typedef struct importer {
    const struct aiScene *file;
    file_kind kind;
    bool index_out_of_range; /* said assimp's log */
    imported_scene *out;
    char *error;
    size_t error_bytes;
    instance *instances;
    size_t instance_count, instance_room;
    quantised *meshes;        /* as many as the file has */
    double low[3], high[3];   /* bounding box of all instances, in the file's world units */
    double centre[3], radius; /* of its bounding sphere */
    double world_scale;
    view view;
    double position_square_sum, relative_square_sum, normal_square_sum;
    uint64_t position_samples, normal_samples;
} importer;

/* Writes the error and returns -1. */
int fail(importer *import, const char *format, ...) PRINTF_LIKE(2, 3);
int fail_memory(importer *import);

/* A name for messages: the file's, or "(unnamed)". */
const char *name_of(const struct aiString *name);

/* check.c: what assimp handed over is whole and finite. */
int check_file(importer *import);

/* gather.c: world matrices of all uses of meshes; of a named node, identity and false when there is none. */
int gather_instances(importer *import);
/* The first node of that name, or NULL. */
const struct aiNode *gather_find_node(const importer *import, const char *name);
bool gather_node_matrix(importer *import, const char *name, matrix34 *world);
void transform_point(const matrix34 *matrix, const double point[3], double result[3]);
void transform_direction(const matrix34 *matrix, const double direction[3], double result[3]);

/* quantise.c: int16 meshes, bounding box and sphere. */
int quantise_meshes(importer *import);

/* t_junctions.c: counts vertices inside open edges; false when there are too many open edges to look through. */
bool count_t_junctions(const int16_t (*positions)[3], size_t vertex_count, const uint32_t (*triangles)[3],
                       size_t triangle_count, uint64_t *result);

/* camera.c */
void find_view(importer *import);
void write_camera(importer *import);

/* place.c: world scale, units of the meshes, and the objects. Needs the view. */
int place_objects(importer *import);

/* materials.c: by number in the file; NULL for those that no object uses. The array belongs to the scene. */
int make_materials(importer *import, const glint_material *const **by_number);

/* lights.c */
int make_lights(importer *import);

/* Small vectors, in vector.c. */
double dot3(const double a[3], const double b[3]);
double length3(const double a[3]);
void cross3(const double a[3], const double b[3], double result[3]);
bool normalise3(double a[3]); /* false, a unchanged, when its length is 0 */
/* round(value * one), limited to +-limit */
double to_fixed(double value, double one, double limit);
/* The integer vector of greatest length in int16 along a direction. */
void to_direction(const double direction[3], int16_t result[3]);

#endif

#endif
