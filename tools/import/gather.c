/* SPDX-License-Identifier: MIT */
/*
 * Walks the node tree: the world matrix of each use of a mesh and of the nodes of lights and cameras. Products are in
 * double, so that the rounding of a place is that of its Q16 format alone.
 */
#include "tools/import/internal.h"

#ifdef GLINT_HAVE_ASSIMP

#include <math.h>
#include <string.h>

#define MAX_OBJECTS UINT16_MAX

static const matrix34 identity = {{{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}}};

/* assimp's matrices are row-major with the translation in the last column, like matrix34. */
static matrix34 from_file(const struct aiMatrix4x4 *matrix)
{
    matrix34 result = {{{(double)matrix->a1, (double)matrix->a2, (double)matrix->a3, (double)matrix->a4},
                        {(double)matrix->b1, (double)matrix->b2, (double)matrix->b3, (double)matrix->b4},
                        {(double)matrix->c1, (double)matrix->c2, (double)matrix->c3, (double)matrix->c4}}};
    return result;
}

static bool affine(const struct aiMatrix4x4 *matrix)
{
    return fabsf(matrix->d1) < 1e-6f && fabsf(matrix->d2) < 1e-6f && fabsf(matrix->d3) < 1e-6f &&
           fabsf(matrix->d4 - 1) < 1e-6f;
}

static matrix34 multiply(const matrix34 *a, const matrix34 *b)
{
    matrix34 result;
    for (int i = 0; i < 3; i++) {
        for (int k = 0; k < 4; k++) {
            double sum = k == 3 ? a->entry[i][3] : 0;
            for (int j = 0; j < 3; j++) {
                sum += a->entry[i][j] * b->entry[j][k];
            }
            result.entry[i][k] = sum;
        }
    }
    return result;
}

void transform_direction(const matrix34 *matrix, const double direction[3], double result[3])
{
    for (int i = 0; i < 3; i++) {
        result[i] = dot3(matrix->entry[i], direction);
    }
}

void transform_point(const matrix34 *matrix, const double point[3], double result[3])
{
    transform_direction(matrix, point, result);
    for (int i = 0; i < 3; i++) {
        result[i] += matrix->entry[i][3];
    }
}

static int add_instance(importer *import, unsigned mesh, const matrix34 *world, const char *name)
{
    if (import->instance_count == MAX_OBJECTS) {
        return fail(import, "the file uses meshes more than %d times; at most so many objects expected", MAX_OBJECTS);
    }
    void *instances = import->instances;
    if (!store_grow(&instances, import->instance_count, &import->instance_room, sizeof *import->instances)) {
        return fail_memory(import);
    }
    import->instances = instances;
    import->instances[import->instance_count++] = (instance){mesh, *world, name};
    return 0;
}

/* Recursion: assimp built the tree by recursion, so its depth has been survived. */
static int gather_node(importer *import, const struct aiNode *node,
                       const matrix34 *parent) /* NOLINT(misc-no-recursion) */
{
    const char *name = name_of(&node->mName);
    matrix34 local = from_file(&node->mTransformation);
    matrix34 world = multiply(parent, &local);
    for (int i = 0; i < 3; i++) {
        for (int k = 0; k < 4; k++) {
            if (!isfinite(world.entry[i][k])) {
                return fail(import, "node '%s': its matrix is not finite; finite numbers expected", name);
            }
        }
    }
    if (!affine(&node->mTransformation)) {
        return fail(import, "node '%s': its matrix has no last row 0 0 0 1; an affine matrix expected", name);
    }
    for (unsigned i = 0; i < node->mNumMeshes; i++) {
        if (node->mMeshes[i] >= import->file->mNumMeshes) {
            return fail(import, "node '%s': mesh %u out of range; less than %u expected", name, node->mMeshes[i],
                        import->file->mNumMeshes);
        }
        if (add_instance(import, node->mMeshes[i], &world, name)) {
            return -1;
        }
    }
    for (unsigned i = 0; i < node->mNumChildren; i++) {
        if (gather_node(import, node->mChildren[i], &world)) {
            return -1;
        }
    }
    return 0;
}

int gather_instances(importer *import)
{
    if (gather_node(import, import->file->mRootNode, &identity)) {
        return -1;
    }
    if (!import->instance_count) {
        return fail(import, "no node uses a mesh; at least one object expected");
    }
    return 0;
}

static const struct aiNode *find_node(const struct aiNode *node, const char *name) /* NOLINT(misc-no-recursion) */
{
    if (strcmp(node->mName.data, name) == 0) {
        return node;
    }
    for (unsigned i = 0; i < node->mNumChildren; i++) {
        const struct aiNode *found = find_node(node->mChildren[i], name);
        if (found) {
            return found;
        }
    }
    return NULL;
}

const struct aiNode *gather_find_node(const importer *import, const char *name)
{
    return find_node(import->file->mRootNode, name);
}

bool gather_node_matrix(importer *import, const char *name, matrix34 *world)
{
    *world = identity;
    const struct aiNode *node = find_node(import->file->mRootNode, name);
    bool found = node != NULL;
    for (; node; node = node->mParent) {
        matrix34 local = from_file(&node->mTransformation);
        *world = multiply(&local, world);
    }
    return found;
}

#endif
