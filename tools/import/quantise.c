/* SPDX-License-Identifier: MIT */
/*
 * From float meshes to glint_mesh: int16 positions on the finest grid of a power of two that holds them, Q14 normals,
 * equal vertices joined, degenerate triangles dropped, and parts of at most 65,535 vertices and triangles.
 *
 * Meshes whose nodes stand at the same place share one grid, since an OBJ is cut into a mesh for each material and
 * their common borders must stay closed. A grid is shifted to the centre of its meshes where that gains two bits or
 * more; the shift goes into the place.
 *
 * Error: half a step of the grid in each coordinate, so at most sqrt(3)/2 steps; measured for the report.
 */
#include "tools/import/internal.h"

#ifdef GLINT_HAVE_ASSIMP

#include <math.h>
#include <stdlib.h>
#include <string.h>

#define COORDINATE_LIMIT INT16_MAX
#define SHIFT_GAIN_BITS 2
#define NO_VERTEX UINT32_MAX

typedef struct box {
    double low[3], high[3];
} box;

static const box empty_box = {{HUGE_VAL, HUGE_VAL, HUGE_VAL}, {-HUGE_VAL, -HUGE_VAL, -HUGE_VAL}};

static void enclose(box *bounds, const double point[3])
{
    for (int k = 0; k < 3; k++) {
        bounds->low[k] = fmin(bounds->low[k], point[k]);
        bounds->high[k] = fmax(bounds->high[k], point[k]);
    }
}

static void position_of(const struct aiMesh *mesh, unsigned vertex, double result[3])
{
    result[0] = (double)mesh->mVertices[vertex].x;
    result[1] = (double)mesh->mVertices[vertex].y;
    result[2] = (double)mesh->mVertices[vertex].z;
}

/* Vertices that no triangle uses do not count: glTF buffers may hold many. */
static void enclose_mesh(const struct aiMesh *mesh, box *bounds)
{
    for (unsigned f = 0; f < mesh->mNumFaces; f++) {
        for (unsigned i = 0; mesh->mFaces[f].mNumIndices == 3 && i < 3; i++) {
            double point[3];
            position_of(mesh, mesh->mFaces[f].mIndices[i], point);
            enclose(bounds, point);
        }
    }
}

/* The greatest e with round(extent * 2^e) <= COORDINATE_LIMIT; 0 for no extent. */
static int grid_exponent(double extent)
{
    if (!(extent > 0)) {
        return 0;
    }
    int power;
    double fraction = frexp(extent, &power); /* extent = fraction * 2^power, fraction in [0.5, 1) */
    int exponent = 15 - power;
    return floor(ldexp(fraction, 15) + 0.5) > COORDINATE_LIMIT ? exponent - 1 : exponent;
}

static bool same_place(const matrix34 *a, const matrix34 *b)
{
    for (int i = 0; i < 3; i++) {
        for (int k = 0; k < 4; k++) {
            if (a->entry[i][k] < b->entry[i][k] || a->entry[i][k] > b->entry[i][k]) {
                return false;
            }
        }
    }
    return true;
}

/* Numbers the grids by the place of each mesh's first use; returns false without memory. */
static bool number_grids(importer *import)
{
    const matrix34 **places = malloc(import->instance_count * sizeof *places);
    unsigned grids = 0;
    for (size_t i = 0; places && i < import->instance_count; i++) {
        quantised *mesh = &import->meshes[import->instances[i].mesh];
        if (mesh->used) {
            continue;
        }
        mesh->used = true;
        mesh->grid = 0;
        while (mesh->grid < grids && !same_place(places[mesh->grid], &import->instances[i].world)) {
            mesh->grid++;
        }
        if (mesh->grid == grids) {
            places[grids++] = &import->instances[i].world;
        }
    }
    free(places);
    return places != NULL;
}

/* One grid for all meshes of a number. */
static void choose_grids(importer *import)
{
    for (unsigned m = 0; m < import->file->mNumMeshes; m++) {
        quantised *mesh = &import->meshes[m];
        bool first = mesh->used;
        for (unsigned other = 0; first && other < m; other++) {
            first = !(import->meshes[other].used && import->meshes[other].grid == mesh->grid);
        }
        if (!first) {
            continue;
        }
        box bounds = empty_box;
        for (unsigned other = m; other < import->file->mNumMeshes; other++) {
            if (import->meshes[other].used && import->meshes[other].grid == mesh->grid) {
                enclose_mesh(import->file->mMeshes[other], &bounds);
            }
        }
        double extent = 0, centred = 0, centre[3];
        for (int k = 0; k < 3; k++) {
            bool any = bounds.low[k] <= bounds.high[k];
            double low = any ? bounds.low[k] : 0, high = any ? bounds.high[k] : 0;
            centre[k] = (low + high) / 2;
            extent = fmax(extent, fmax(fabs(low), fabs(high)));
            centred = fmax(centred, (high - low) / 2);
        }
        bool shift = centred > 0 && grid_exponent(centred) >= grid_exponent(extent) + SHIFT_GAIN_BITS;
        for (unsigned other = m; other < import->file->mNumMeshes; other++) {
            quantised *member = &import->meshes[other];
            if (member->used && member->grid == mesh->grid) {
                member->exponent = grid_exponent(shift ? centred : extent);
                for (int k = 0; k < 3; k++) {
                    member->centre[k] = shift ? centre[k] : 0;
                }
            }
        }
    }
}

/* A joined vertex of a mesh: position, normal and texture coordinates, the key of the joining. */
enum { TEXCOORD = 6, VALUES = 8 };
typedef struct joined_vertex {
    int16_t value[VALUES];
} joined_vertex;

typedef struct workspace {
    joined_vertex *vertices; /* joined_count of them */
    size_t joined_count;
    uint32_t *joined_of;      /* of each file vertex, NO_VERTEX until it is used */
    uint32_t *table;          /* hash table of joined vertices */
    size_t table_mask;        /* its size - 1 */
    uint32_t (*triangles)[3]; /* of joined vertices */
    size_t triangle_count;
    uint64_t zero_normals;
    bool textured;
    int texcoord_bits;
    double greatest_texcoord;
} workspace;

static void workspace_free(workspace *work)
{
    free(work->vertices);
    free(work->joined_of);
    free(work->table);
    free(work->triangles);
}

static bool workspace_allocate(workspace *work, const struct aiMesh *mesh)
{
    size_t size = 16;
    while (size < 2 * (size_t)mesh->mNumVertices) {
        size *= 2;
    }
    work->table_mask = size - 1;
    work->vertices = calloc((size_t)mesh->mNumVertices + 1, sizeof *work->vertices);
    work->joined_of = malloc(((size_t)mesh->mNumVertices + 1) * sizeof *work->joined_of);
    work->table = malloc(size * sizeof *work->table);
    work->triangles = calloc((size_t)mesh->mNumFaces + 1, sizeof *work->triangles);
    if (!work->vertices || !work->joined_of || !work->table || !work->triangles) {
        return false;
    }
    memset(work->joined_of, 0xff, ((size_t)mesh->mNumVertices + 1) * sizeof *work->joined_of);
    memset(work->table, 0xff, size * sizeof *work->table);
    return true;
}

/* assimp counts v upwards, whatever the file does. What is not finite is 0. */
static void texcoord_of(const struct aiMesh *mesh, unsigned vertex, double uv[2])
{
    uv[0] = (double)mesh->mTextureCoords[0][vertex].x;
    uv[1] = 1 - (double)mesh->mTextureCoords[0][vertex].y;
    for (int k = 0; k < 2; k++) {
        uv[k] = isfinite(uv[k]) ? uv[k] : 0;
    }
}

/* Texture coordinates are kept where the material has a texture, with as many bits as they leave room for. */
static void measure_texcoords(importer *import, workspace *work, const struct aiMesh *mesh)
{
    work->textured = mesh->mTextureCoords[0] && has_texture(import->file->mMaterials[mesh->mMaterialIndex]);
    for (unsigned v = 0; work->textured && v < mesh->mNumVertices; v++) {
        double uv[2];
        texcoord_of(mesh, v, uv);
        work->greatest_texcoord = fmax(work->greatest_texcoord, fmax(fabs(uv[0]), fabs(uv[1])));
    }
    work->texcoord_bits = GLINT_MAX_TEXCOORD_BITS;
    while (work->texcoord_bits > GLINT_LEAST_TEXCOORD_BITS &&
           ldexp(work->greatest_texcoord, work->texcoord_bits) > INT16_MAX) {
        work->texcoord_bits--;
    }
    if (ldexp(work->greatest_texcoord, work->texcoord_bits) > INT16_MAX + 1.0) {
        store_warn(import->out, "mesh '%s': texture coordinates of %g are limited to 64", name_of(&mesh->mName),
                   work->greatest_texcoord);
    }
}

/* The joined vertex that equals `vertex` in all bits, made when there is none yet. */
static uint32_t join(workspace *work, const joined_vertex *vertex)
{
    uint32_t hash = 2166136261u; /* FNV-1a over the values */
    for (int k = 0; k < VALUES; k++) {
        hash = (hash ^ (uint16_t)vertex->value[k]) * 16777619u;
    }
    size_t slot = (hash ^ (hash >> 15)) & work->table_mask;
    while (work->table[slot] != NO_VERTEX) {
        if (memcmp(&work->vertices[work->table[slot]], vertex, sizeof *vertex) == 0) {
            return work->table[slot];
        }
        slot = (slot + 1) & work->table_mask;
    }
    work->vertices[work->joined_count] = *vertex;
    work->table[slot] = (uint32_t)work->joined_count;
    return (uint32_t)work->joined_count++;
}

static void note_position_error(importer *import, const double error[3], double diagonal)
{
    import_report *report = &import->out->report;
    double distance = length3(error);
    double relative = diagonal > 0 ? distance / diagonal : 0;
    report->position_max_units = fmax(report->position_max_units, distance);
    report->position_max_relative = fmax(report->position_max_relative, relative);
    import->position_square_sum += distance * distance;
    import->relative_square_sum += relative * relative;
    import->position_samples++;
}

static void note_normal_error(importer *import, const double normal[3], const int16_t rounded[3])
{
    double other[3] = {rounded[0], rounded[1], rounded[2]}, crossed[3];
    cross3(normal, other, crossed);
    double degrees = atan2(length3(crossed), dot3(normal, other)) * (180 / PI);
    import->out->report.normal_max_degrees = fmax(import->out->report.normal_max_degrees, degrees);
    import->normal_square_sum += degrees * degrees;
    import->normal_samples++;
}

static uint32_t quantise_vertex(importer *import, workspace *work, const struct aiMesh *mesh, const quantised *grid,
                                unsigned index, double diagonal)
{
    if (work->joined_of[index] != NO_VERTEX) {
        return work->joined_of[index];
    }
    joined_vertex vertex = {{0}};
    double position[3], error[3];
    position_of(mesh, index, position);
    for (int k = 0; k < 3; k++) {
        double value = ldexp(position[k] - grid->centre[k], grid->exponent);
        vertex.value[k] = (int16_t)to_fixed(value, 1, COORDINATE_LIMIT);
        error[k] = ldexp(vertex.value[k], -grid->exponent) + grid->centre[k] - position[k];
    }
    note_position_error(import, error, diagonal);

    if (mesh->mNormals) {
        const struct aiVector3D *given = &mesh->mNormals[index];
        double normal[3] = {(double)given->x, (double)given->y, (double)given->z};
        /* assimp makes NaN normals where all faces of a vertex are degenerate. */
        if (isfinite(length3(normal)) && normalise3(normal)) {
            for (int k = 0; k < 3; k++) {
                vertex.value[3 + k] = (int16_t)to_fixed(normal[k], FIXED_ONE_Q14, FIXED_ONE_Q14);
            }
            note_normal_error(import, normal, &vertex.value[3]);
        } else {
            work->zero_normals++;
        }
    }
    if (work->textured) {
        double uv[2];
        texcoord_of(mesh, index, uv);
        for (int k = 0; k < 2; k++) {
            vertex.value[TEXCOORD + k] = (int16_t)to_fixed(uv[k], ldexp(1, work->texcoord_bits), INT16_MAX);
        }
    }
    return work->joined_of[index] = join(work, &vertex);
}

/* On the grid: with exact integers, so nothing thin is dropped that still has an area. */
static bool degenerate(const joined_vertex *a, const joined_vertex *b, const joined_vertex *c)
{
    int64_t u[3], v[3]; /* |u|, |v| < 2^17 */
    for (int k = 0; k < 3; k++) {
        u[k] = b->value[k] - a->value[k];
        v[k] = c->value[k] - a->value[k];
    }
    return u[1] * v[2] == u[2] * v[1] && u[2] * v[0] == u[0] * v[2] && u[0] * v[1] == u[1] * v[0];
}

/* Cuts the joined mesh into parts of at most 65,535 vertices and triangles, in the order of the triangles. */
static int cut_parts(importer *import, const workspace *work, quantised *result)
{
    size_t room = 0;
    size_t next = 0;
    uint32_t *local = malloc((work->joined_count + 1) * sizeof *local); /* index in the part under way */
    uint32_t *order = malloc((UINT16_MAX + 1) * sizeof *order);         /* its vertices */
    glint_mesh *parts = NULL;
    bool memory = local && order;
    while (memory && next < work->triangle_count) {
        memset(local, 0xff, work->joined_count * sizeof *local);
        size_t first = next;
        uint32_t vertices = 0;
        for (; next < work->triangle_count && next - first < UINT16_MAX && vertices + 3 <= UINT16_MAX; next++) {
            for (int k = 0; k < 3; k++) {
                uint32_t joined = work->triangles[next][k];
                if (local[joined] == NO_VERTEX) {
                    order[vertices] = joined;
                    local[joined] = vertices++;
                }
            }
        }
        int16_t(*positions)[3] = store_take(import->out, vertices, sizeof *positions);
        int16_t(*normals)[3] = store_take(import->out, vertices, sizeof *normals);
        int16_t(*texcoords)[2] = work->textured ? store_take(import->out, vertices, sizeof *texcoords) : NULL;
        uint16_t(*triangles)[3] = store_take(import->out, next - first, sizeof *triangles);
        void *grown = parts;
        memory = positions && normals && triangles && (texcoords || !work->textured) &&
                 store_grow(&grown, result->part_count, &room, sizeof *parts);
        parts = grown;
        if (!memory) {
            break;
        }
        for (uint32_t v = 0; v < vertices; v++) {
            memcpy(positions[v], &work->vertices[order[v]].value[0], sizeof positions[v]);
            memcpy(normals[v], &work->vertices[order[v]].value[3], sizeof normals[v]);
            if (texcoords) {
                memcpy(texcoords[v], &work->vertices[order[v]].value[TEXCOORD], sizeof texcoords[v]);
            }
        }
        for (size_t t = first; t < next; t++) {
            for (int k = 0; k < 3; k++) {
                triangles[t - first][k] = (uint16_t)local[work->triangles[t][k]];
            }
        }
        parts[result->part_count++] = (glint_mesh){.positions = (const int16_t(*)[3])positions,
                                                   .normals_q14 = (const int16_t(*)[3])normals,
                                                   .triangles = (const uint16_t(*)[3])triangles,
                                                   .vertex_count = (uint16_t)vertices,
                                                   .triangle_count = (uint16_t)(next - first),
                                                   .texcoord_bits = (int8_t)(texcoords ? work->texcoord_bits : 0),
                                                   .texcoords = (const int16_t(*)[2])texcoords};
    }
    if (memory) {
        result->parts = store_take(import->out, result->part_count, sizeof *parts);
        memory = result->parts != NULL;
    }
    if (memory && parts) {
        memcpy(result->parts, parts, result->part_count * sizeof *parts);
    }
    free(parts);
    free(local);
    free(order);
    return memory ? 0 : fail_memory(import);
}

static int look_for_t_junctions(importer *import, const workspace *work, const char *name)
{
    int16_t(*positions)[3] = malloc((work->joined_count + 1) * sizeof *positions);
    if (!positions) {
        return fail_memory(import);
    }
    for (size_t v = 0; v < work->joined_count; v++) {
        memcpy(positions[v], work->vertices[v].value, sizeof positions[v]);
    }
    uint64_t found = 0;
    if (count_t_junctions((const int16_t(*)[3])positions, work->joined_count, (const uint32_t(*)[3])work->triangles,
                          work->triangle_count, &found) &&
        found) {
        store_warn(import->out,
                   "mesh '%s': %llu T-junctions (a vertex inside another triangle's edge), where pixels of the "
                   "background may show through",
                   name, (unsigned long long)found);
        import->out->report.t_junctions += found;
    }
    free(positions);
    return 0;
}

static int quantise_mesh(importer *import, const struct aiMesh *mesh, quantised *result)
{
    const char *name = name_of(&mesh->mName);
    box bounds = empty_box;
    enclose_mesh(mesh, &bounds);
    double size[3];
    for (int k = 0; k < 3; k++) {
        size[k] = fmax(0, bounds.high[k] - bounds.low[k]);
    }
    double diagonal = length3(size);

    workspace work = {0};
    int status = workspace_allocate(&work, mesh) ? 0 : fail_memory(import);
    measure_texcoords(import, &work, mesh);
    uint64_t dropped = 0;
    for (unsigned f = 0; !status && f < mesh->mNumFaces; f++) {
        const struct aiFace *face = &mesh->mFaces[f];
        if (face->mNumIndices != 3) {
            continue; /* points and lines */
        }
        uint32_t *corner = work.triangles[work.triangle_count];
        for (int k = 0; k < 3; k++) {
            corner[k] = quantise_vertex(import, &work, mesh, result, face->mIndices[k], diagonal);
        }
        if (degenerate(&work.vertices[corner[0]], &work.vertices[corner[1]], &work.vertices[corner[2]])) {
            dropped++;
        } else {
            work.triangle_count++;
        }
    }
    if (!status && dropped) {
        store_warn(import->out, "mesh '%s': %llu triangles without area are dropped", name,
                   (unsigned long long)dropped);
        import->out->report.dropped += dropped;
    }
    if (!status && work.zero_normals) {
        store_warn(import->out, "mesh '%s': %llu normals of length zero stand for the normal of the face", name,
                   (unsigned long long)work.zero_normals);
    }
    if (!status) {
        status = look_for_t_junctions(import, &work, name);
    }
    if (!status) {
        status = cut_parts(import, &work, result);
    }
    workspace_free(&work);
    return status;
}

/* Bounding box of all instances and a sphere about its centre. */
static int find_bounds(importer *import)
{
    box bounds = empty_box;
    double square = 0;
    for (int pass = 0; pass < 2; pass++) {
        for (size_t i = 0; i < import->instance_count; i++) {
            const quantised *mesh = &import->meshes[import->instances[i].mesh];
            for (unsigned part = 0; part < mesh->part_count; part++) {
                for (unsigned v = 0; v < mesh->parts[part].vertex_count; v++) {
                    double point[3], world[3];
                    for (int k = 0; k < 3; k++) {
                        point[k] = ldexp(mesh->parts[part].positions[v][k], -mesh->exponent) + mesh->centre[k];
                    }
                    transform_point(&import->instances[i].world, point, world);
                    if (pass == 0) {
                        enclose(&bounds, world);
                        continue;
                    }
                    for (int k = 0; k < 3; k++) {
                        world[k] -= import->centre[k];
                    }
                    square = fmax(square, dot3(world, world));
                }
            }
        }
        for (int k = 0; k < 3; k++) {
            import->low[k] = bounds.low[k];
            import->high[k] = bounds.high[k];
            import->centre[k] = (bounds.low[k] + bounds.high[k]) / 2;
        }
    }
    import->radius = sqrt(square);
    if (!isfinite(import->radius)) {
        return fail(import, "the objects are too far apart for double precision");
    }
    return 0;
}

int quantise_meshes(importer *import)
{
    import->meshes = store_take(import->out, import->file->mNumMeshes, sizeof *import->meshes);
    if (!import->meshes || !number_grids(import)) {
        return fail_memory(import);
    }
    choose_grids(import);
    unsigned parts = 0;
    for (unsigned m = 0; m < import->file->mNumMeshes; m++) {
        if (import->meshes[m].used && quantise_mesh(import, import->file->mMeshes[m], &import->meshes[m])) {
            return -1;
        }
        parts += import->meshes[m].part_count;
    }
    if (!parts) {
        return fail(import, "the file has no triangle with an area; at least one expected");
    }
    import_report *report = &import->out->report;
    if (import->position_samples) {
        report->position_rms_units = sqrt(import->position_square_sum / (double)import->position_samples);
        report->position_rms_relative = sqrt(import->relative_square_sum / (double)import->position_samples);
    }
    if (import->normal_samples) {
        report->normal_rms_degrees = sqrt(import->normal_square_sum / (double)import->normal_samples);
    }
    return find_bounds(import);
}

#endif
