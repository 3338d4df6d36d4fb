/* SPDX-License-Identifier: MIT */
/*
 * From world matrices to the objects' places: Q16, entries up to 1024, origins up to 16384.
 *
 * World scale. One world unit is the file's unit unless coordinates exceed half the range of an origin, or all objects
 * are smaller than a quarter of a unit, where the step of 2^-16 becomes coarse: then the whole scene, camera and lights
 * with it, is scaled by a power of two, which no picture shows.
 *
 * Units of a mesh. A matrix of small entries (0.01 for a model in centimetres) would lose its precision in Q16; so the
 * mesh gets a unit smaller by a power of two (more fraction bits), and its matrix larger entries.
 */
#include "tools/import/internal.h"

#ifdef GLINT_HAVE_ASSIMP

#include <math.h>
#include <stdlib.h>

#define EXTENT_LIMIT (ORIGIN_LIMIT / 2)
#define LEAST_RADIUS 0.25
#define LEAST_ENTRY 0.5 /* of a matrix's greatest: its error is then at most 2^-16 of it */

/* The greatest world coordinate of objects and camera. */
static double greatest_coordinate(const importer *import)
{
    double greatest = 0;
    for (int k = 0; k < 3; k++) {
        double target = import->view.eye[k] + import->view.distance * import->view.forward[k];
        greatest = fmax(greatest, fmax(fabs(import->low[k]), fabs(import->high[k])));
        greatest = fmax(greatest, fmax(fabs(import->view.eye[k]), fabs(target)));
    }
    for (size_t i = 0; i < import->instance_count; i++) {
        for (int k = 0; k < 3; k++) {
            greatest = fmax(greatest, fabs(import->instances[i].world.entry[k][3]));
        }
    }
    return greatest;
}

static void choose_world_scale(importer *import)
{
    double greatest = greatest_coordinate(import);
    double scale = 1;
    while (import->radius > 0 && import->radius * scale < LEAST_RADIUS && greatest * scale * 2 <= EXTENT_LIMIT) {
        scale *= 2;
    }
    while (greatest * scale > ORIGIN_LIMIT - 1) {
        scale /= 2;
    }
    import->world_scale = scale;
    import->out->report.world_scale = scale;
    if (scale < 1 || scale > 1) {
        store_warn(import->out, "the scene is scaled by %g to suit the range of Glint's coordinates", scale);
    }
}

static double greatest_entry(const matrix34 *matrix)
{
    double greatest = 0;
    for (int i = 0; i < 3; i++) {
        for (int k = 0; k < 3; k++) {
            greatest = fmax(greatest, fabs(matrix->entry[i][k]));
        }
    }
    return greatest;
}

/* One unit for all meshes of a grid, as their places are the same. */
static int choose_units(importer *import)
{
    for (unsigned m = 0; m < import->file->mNumMeshes; m++) {
        quantised *mesh = &import->meshes[m];
        double greatest = 0, least = HUGE_VAL;
        const char *name = NULL;
        for (size_t i = 0; mesh->used && i < import->instance_count; i++) {
            const quantised *other = &import->meshes[import->instances[i].mesh];
            double entry = greatest_entry(&import->instances[i].world) * import->world_scale;
            if (other->grid != mesh->grid || !(entry > 0)) {
                continue;
            }
            greatest = fmax(greatest, entry);
            least = fmin(least, entry);
            name = import->instances[i].name;
        }
        if (!name) {
            continue;
        }
        int low = -mesh->exponent, high = GLINT_MAX_FRACTION_BITS - mesh->exponent;
        high = (int)fmin(high, floor(log2(LINEAR_LIMIT / greatest)));
        if (low > high) {
            return fail(
                import,
                "node '%s': its matrix and the size of its meshes are too far apart; entries of at most %g for a "
                "scene of this size expected",
                name, LINEAR_LIMIT);
        }
        int unit = least < LEAST_ENTRY ? (int)ceil(log2(LEAST_ENTRY / least)) : 0;
        mesh->unit_log2 = unit < low ? low : unit > high ? high : unit;
        for (unsigned part = 0; part < mesh->part_count; part++) {
            mesh->parts[part].fraction_bits = (int8_t)(mesh->exponent + mesh->unit_log2);
        }
    }
    return 0;
}

/* The criterion of glint_place, on the rounded entries. */
static bool singular(const glint_place *place)
{
    double rows[3][3], crossed[3], greatest = 0;
    for (int i = 0; i < 3; i++) {
        for (int k = 0; k < 3; k++) {
            rows[i][k] = place->linear_q16[i][k] / FIXED_ONE_Q16;
            greatest = fmax(greatest, fabs(rows[i][k]));
        }
    }
    cross3(rows[1], rows[2], crossed);
    return !(fabs(dot3(rows[0], crossed)) >= ldexp(greatest * greatest * greatest, -24)) || !(greatest > 0);
}

static void make_place(const importer *import, const instance *use, const quantised *mesh, glint_place *place)
{
    double origin[3];
    transform_point(&use->world, mesh->centre, origin);
    for (int i = 0; i < 3; i++) {
        for (int k = 0; k < 3; k++) {
            double entry = ldexp(use->world.entry[i][k] * import->world_scale, mesh->unit_log2);
            place->linear_q16[i][k] = (int32_t)to_fixed(entry, FIXED_ONE_Q16, 1 << 26);
        }
        place->origin_q16[i] = (int32_t)to_fixed(origin[i] * import->world_scale, FIXED_ONE_Q16, 1 << 30);
    }
}

/* A mesh without texture coordinates is drawn in its material's plain colours. NULL without memory. */
static const glint_material *without_texture(importer *import, const glint_material *material, const char *node)
{
    glint_material *plain = store_take(import->out, 1, sizeof *plain);
    if (plain) {
        *plain = *material;
        plain->texture = NULL;
        store_warn(import->out, "node '%s': drawn without its texture: the mesh has no texture coordinates", node);
    }
    return plain;
}

static int make_objects(importer *import, const glint_material *const *materials)
{
    import_report *report = &import->out->report;
    size_t count = 0;
    for (size_t i = 0; i < import->instance_count; i++) {
        count += import->meshes[import->instances[i].mesh].part_count;
    }
    if (count > UINT16_MAX) {
        return fail(import, "the file makes %zu objects; at most %d expected", count, UINT16_MAX);
    }
    glint_object *objects = store_take(import->out, count, sizeof *objects);
    if (!objects) {
        return fail_memory(import);
    }
    for (size_t i = 0; i < import->instance_count; i++) {
        const instance *use = &import->instances[i];
        const quantised *mesh = &import->meshes[use->mesh];
        glint_place place;
        make_place(import, use, mesh, &place);
        if (mesh->part_count && singular(&place)) {
            store_warn(import->out, "node '%s': its matrix flattens the object, which is left out", use->name);
            continue;
        }
        const glint_material *material = materials[import->file->mMeshes[use->mesh]->mMaterialIndex];
        if (mesh->part_count && material->texture && !mesh->parts->texcoords) {
            material = without_texture(import, material, use->name);
            if (!material) {
                return fail_memory(import);
            }
        }
        for (unsigned part = 0; part < mesh->part_count; part++) {
            objects[report->objects++] = (glint_object){&mesh->parts[part], material, place};
        }
    }
    if (!report->objects) {
        return fail(import, "no object is left; at least one expected");
    }
    import->out->scene.objects = objects;
    import->out->scene.object_count = (uint16_t)report->objects;
    return 0;
}

static void count_meshes(importer *import)
{
    import_report *report = &import->out->report;
    for (unsigned m = 0; m < import->file->mNumMeshes; m++) {
        for (unsigned part = 0; part < import->meshes[m].part_count; part++) {
            const glint_mesh *mesh = &import->meshes[m].parts[part];
            report->meshes++;
            report->vertices += mesh->vertex_count;
            report->triangles += mesh->triangle_count;
            report->flash_bytes += mesh->texcoords ? mesh->vertex_count * sizeof *mesh->texcoords : 0;
            report->flash_bytes += mesh->vertex_count * (sizeof *mesh->positions + sizeof *mesh->normals_q14) +
                                   mesh->triangle_count * sizeof *mesh->triangles;
        }
    }
    for (int k = 0; k < 3; k++) {
        report->centre[k] = import->centre[k] * import->world_scale;
    }
    report->radius = import->radius * import->world_scale;
}

int place_objects(importer *import)
{
    choose_world_scale(import);
    const glint_material *const *materials;
    if (choose_units(import) || make_materials(import, &materials) || make_objects(import, materials)) {
        return -1;
    }
    count_meshes(import);
    return 0;
}

#endif
