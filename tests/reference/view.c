/* SPDX-License-Identifier: MIT */
/*
 * Reads the scene's bits into double precision and takes every triangle to view space and to the screen, by the
 * conventions of <glint/scene.h>: the reference's own reading of them.
 */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "internal.h"

#define Q16 65536.0
#define Q14 16384.0
#define PI 3.14159265358979323846

static vector from_q16(const int32_t v[3])
{
    return vector_of(v[0] / Q16, v[1] / Q16, v[2] / Q16);
}

static void from_colour(glint_colour c, double rgb[3])
{
    rgb[0] = c.r_q14 / Q14;
    rgb[1] = c.g_q14 / Q14;
    rgb[2] = c.b_q14 / Q14;
}

static void load_camera(reference_detail *d, const glint_camera *c)
{
    vector up = vector_of(c->up[0], c->up[1], c->up[2]);
    if (length(up) == 0.0) {
        up = vector_of(0.0, 1.0, 0.0);
    }
    d->eye = from_q16(c->eye_q16);
    d->forward = unit(minus(from_q16(c->target_q16), d->eye));
    d->right = unit(cross(d->forward, up));
    d->down = cross(d->forward, d->right);
    d->focal = d->height / 2.0 / tan(c->field_of_view_turn16 / Q16 * 2.0 * PI / 2.0);
    d->near_z = c->near_q16 / Q16;
}

vector view_ray(const reference_detail *d, double x, double y)
{
    return vector_of((x - d->width / 2.0) / d->focal, (y - d->height / 2.0) / d->focal, 1.0);
}

static void load_surface(surface *out, const glint_material *in, const glint_scene *scene)
{
    double ambient[3], sky[3], ground[3], reflectance[3];
    from_colour(scene->ambient, ambient);
    from_colour(scene->sky, sky);
    from_colour(scene->ground, ground);
    from_colour(in->ambient, reflectance);
    for (int k = 0; k < 3; k++) {
        out->ambient[k] = reflectance[k] * ambient[k];
        out->sky[k] = reflectance[k] * sky[k];
        out->ground[k] = reflectance[k] * ground[k];
    }
    from_colour(in->emission, out->emission);
    from_colour(in->mirror, out->mirror);
    out->sides = in->sides;
    out->casts = (in->shadows & GLINT_CASTS_NO_SHADOW) == 0;
    out->takes = (in->shadows & GLINT_TAKES_NO_SHADOW) == 0;
    from_colour(in->diffuse, out->diffuse);
    out->transmission = in->transmission_q14 / Q14;
    from_colour(in->grazing, out->grazing);
    from_colour(in->wire, out->wire);
    out->wire_width = in->wire_width_q4 / 16.0;
    out->grazes = in->grazing.r_q14 != 0 || in->grazing.g_q14 != 0 || in->grazing.b_q14 != 0;
    for (int k = 0; k < 3; k++) {
        double body = 1.0 - out->transmission;
        out->ambient[k] *= body;
        out->sky[k] *= body;
        out->ground[k] *= body;
        out->diffuse[k] *= body;
        out->emission[k] *= body;
    }
    from_colour(in->specular, out->specular);
    out->exponent = in->exponent_q4 / 16.0;
    out->blinn = in->specular_model == GLINT_BLINN;
}

static void load_air(reference_detail *d, const glint_scene *scene)
{
    d->up = unit(vector_of(scene->up[0], scene->up[1], scene->up[2]));
    if (length(d->up) == 0.0) {
        d->up = vector_of(0.0, 1.0, 0.0);
    }
    from_colour(scene->fog.colour, d->fog);
    d->fog_begin = scene->fog.begin_q16 / Q16;
    d->fog_end = scene->fog.end_q16 / Q16;
}

/* An object's place: points by the matrix, normals by its cofactors, which are the inverse transpose times the
 * determinant; the determinant's sign is taken out again so that outside stays outside. */
typedef struct placing {
    vector row[3], normal_row[3], origin;
    double handedness; /* -1 for a place that mirrors */
} placing;

static placing load_place(const glint_place *place)
{
    placing p;
    bool zero = true;
    for (int i = 0; i < 3; i++) {
        p.row[i] = from_q16(place->linear_q16[i]);
        zero = zero && length(p.row[i]) == 0.0;
    }
    if (zero) {
        p.row[0] = vector_of(1.0, 0.0, 0.0);
        p.row[1] = vector_of(0.0, 1.0, 0.0);
        p.row[2] = vector_of(0.0, 0.0, 1.0);
    }
    p.origin = from_q16(place->origin_q16);
    p.handedness = dot(p.row[0], cross(p.row[1], p.row[2])) < 0.0 ? -1.0 : 1.0;
    for (int i = 0; i < 3; i++) {
        p.normal_row[i] = times(p.handedness, cross(p.row[(i + 1) % 3], p.row[(i + 2) % 3]));
    }
    return p;
}

static vector place_normal(const placing *p, vector n)
{
    return unit(vector_of(dot(p->normal_row[0], n), dot(p->normal_row[1], n), dot(p->normal_row[2], n)));
}

static vector to_view(const reference_detail *d, vector world)
{
    vector v = minus(world, d->eye);
    return vector_of(dot(d->right, v), dot(d->down, v), dot(d->forward, v));
}

/* Sutherland-Hodgman against the near plane, and the screen positions of what remains. */
static void cut_at_near(const reference_detail *d, triangle *t, const vector p[3])
{
    t->corner_count = 0;
    for (int i = 0; i < 3; i++) {
        int j = (i + 1) % 3;
        bool here = p[i].z > d->near_z, there = p[j].z > d->near_z;
        double along[2] = {0.0, 0.0};
        int label[2] = {i, 0}, count = 0;
        if (here) {
            count = 1;
        }
        if (here != there) {
            along[count] = (d->near_z - p[i].z) / (p[j].z - p[i].z);
            label[count] = here ? NEAR_EDGE : i;
            count++;
        }
        for (int k = 0; k < count; k++) {
            vector v = plus(times(1.0 - along[k], p[i]), times(along[k], p[j]));
            corner *c = &t->corners[t->corner_count];
            if (along[k] != 0.0) {
                v.z = d->near_z;
            }
            c->x = d->width / 2.0 + d->focal * v.x / v.z;
            c->y = d->height / 2.0 + d->focal * v.y / v.z;
            c->inverse_z = 1.0 / v.z;
            for (int m = 0; m < 3; m++) {
                c->linear[m] = (m == i ? 1.0 - along[k] : 0.0) + (m == j ? along[k] : 0.0);
                c->share[m] = c->linear[m] * c->inverse_z;
            }
            t->label[t->corner_count++] = label[k];
        }
    }
}

/* The polygon's edges as signed distances, and whether it is so thin that moving its corners by e may flip it. */
static void measure(const reference_detail *d, triangle *t, double sign)
{
    double width = HUGE_VAL;
    for (int k = 0; k < t->corner_count; k++) {
        const corner *a = &t->corners[k], *b = &t->corners[(k + 1) % t->corner_count];
        double dx = b->x - a->x, dy = b->y - a->y, l = hypot(dx, dy), far = 0.0;
        double *line = t->line[k];
        line[0] = line[1] = line[2] = 0.0;
        if (l > 0.0) {
            line[0] = -dy / l * sign;
            line[1] = dx / l * sign;
            line[2] = -(line[0] * a->x + line[1] * a->y);
        }
        for (int m = 0; m < t->corner_count; m++) {
            far = fmax(far, line[0] * (t->corners[m].x - a->x) + line[1] * (t->corners[m].y - a->y));
        }
        width = fmin(width, far);
    }
    t->thin = width <= 2.0 * d->options.edge_px;
}

/* Two equal corners: never seen, and its neighbours close up without it since its own edges cancel out. */
static bool collapsed(const triangle *t)
{
    for (int i = 0; i < 3; i++) {
        if (memcmp(t->model[i], t->model[(i + 1) % 3], sizeof t->model[i]) == 0) {
            return true;
        }
    }
    return false;
}

static void load_triangle(const reference_detail *d, triangle *t, const glint_mesh *mesh, const uint16_t index[3],
                          const placing *place)
{
    vector p[3];
    double scale = ldexp(1.0, -mesh->fraction_bits);
    int64_t m[3][3];
    for (int i = 0; i < 3; i++) {
        const int16_t *position = mesh->positions[index[i]];
        vector local = times(scale, vector_of(position[0], position[1], position[2]));
        for (int k = 0; k < 3; k++) {
            t->model[i][k] = position[k];
            m[i][k] = position[k] - (int64_t)mesh->positions[index[0]][k];
        }
        t->world[i] = plus(vector_of(dot(place->row[0], local), dot(place->row[1], local), dot(place->row[2], local)),
                           place->origin);
        p[i] = to_view(d, t->world[i]);
    }
    /* exact: differences below 2^17, products below 2^34 */
    t->face = place_normal(place, vector_of((double)(m[1][1] * m[2][2] - m[1][2] * m[2][1]),
                                            (double)(m[1][2] * m[2][0] - m[1][0] * m[2][2]),
                                            (double)(m[1][0] * m[2][1] - m[1][1] * m[2][0])));
    for (int i = 0; i < 3; i++) {
        const int16_t *n = mesh->normals_q14[index[i]];
        vector normal = place_normal(place, vector_of(n[0], n[1], n[2]));
        t->normal[i] = length(normal) > 0.0 ? normal : t->face;
        for (int k = 0; k < 2 && d->surfaces[t->object].texture.rgb; k++) {
            t->texcoord[i][k] = ldexp(mesh->texcoords[index[i]][k], -mesh->texcoord_bits);
        }
    }

    vector plane = cross(minus(p[1], p[0]), minus(p[2], p[0]));
    double height = dot(plane, p[0]), sign = height < 0.0 ? -1.0 : 1.0;
    t->plane = times(sign, plane);
    t->height = sign * height;
    for (int i = 0; i < 3; i++) {
        t->edge[i] = times(sign, cross(p[(i + 1) % 3], p[(i + 2) % 3]));
    }
    /* The outward normal (of a mirrored triangle: the other way) points against the ray to the triangle. */
    t->front = height * place->handedness < 0.0 && length(t->face) > 0.0;
    t->away = !t->front;
    int sides = d->surfaces[t->object].sides;
    t->front = t->front || (sides != GLINT_FRONT_SIDE && height != 0.0 && length(t->face) > 0.0);
    for (int i = 0; i < 3 && t->away && sides == GLINT_TWO_SIDED; i++) {
        t->normal[i] = times(-1.0, t->normal[i]);
    }
    if (t->away && sides == GLINT_TWO_SIDED) {
        t->face = times(-1.0, t->face);
    }
    cut_at_near(d, t, p);
    if (collapsed(t)) {
        t->corner_count = 0;
    }
    measure(d, t, sign);
}

static int fail(char *error, size_t error_bytes, const char *text)
{
    if (error_bytes > 0) {
        snprintf(error, error_bytes, "%s", text);
    }
    return -1;
}

static int load_object(reference_detail *d, int number, const glint_object *o, char *error, size_t error_bytes)
{
    placing place = load_place(&o->place);
    for (int i = 0; i < o->mesh->triangle_count; i++) {
        const uint16_t *index = o->mesh->triangles[i];
        for (int k = 0; k < 3; k++) {
            if (index[k] >= o->mesh->vertex_count) {
                if (error_bytes > 0) {
                    snprintf(error, error_bytes,
                             "object %d: triangle %d names vertex %u, but the mesh has %u; an index below that was "
                             "expected",
                             number, i, (unsigned)index[k], (unsigned)o->mesh->vertex_count);
                }
                return -1;
            }
        }
        triangle *t = &d->triangles[d->triangle_count++];
        t->object = number;
        load_triangle(d, t, o->mesh, index, &place);
    }
    return 0;
}

int view_load(reference_detail *d, const glint_scene *scene, char *error, size_t error_bytes)
{
    size_t count = 0;
    if (!scene || !scene->camera) {
        return fail(error, error_bytes, "a scene with a camera was expected, not NULL");
    }
    if ((scene->object_count > 0 && !scene->objects) || (scene->light_count > 0 && !scene->lights)) {
        return fail(error, error_bytes, "an array for the objects and lights that the scene counts was expected");
    }
    for (int i = 0; i < scene->object_count; i++) {
        const glint_object *o = &scene->objects[i];
        if (!o->mesh || !o->material || !o->mesh->positions || !o->mesh->normals_q14 || !o->mesh->triangles) {
            return fail(error, error_bytes, "an object with a material and a whole mesh was expected, not NULL");
        }
        count += o->mesh->triangle_count;
    }
    if (count > INT32_MAX) {
        return fail(error, error_bytes, "at most 2147483647 triangles were expected");
    }
    d->triangles = calloc(count + 1, sizeof *d->triangles);
    d->surfaces = calloc((size_t)scene->object_count + 1, sizeof *d->surfaces);
    d->lamps = calloc((size_t)scene->light_count + 1, sizeof *d->lamps);
    if (!d->triangles || !d->surfaces || !d->lamps) {
        return fail(error, error_bytes, "no memory for the scene's triangles");
    }

    load_camera(d, scene->camera);
    load_air(d, scene);
    if (around_load(&d->around, scene->environment)) {
        return fail(error, error_bytes, "no memory for the scene's environment");
    }
    from_colour(scene->background, d->background);
    d->lamp_count = scene->light_count;
    for (int i = 0; i < d->lamp_count; i++) {
        lamp_load(&d->lamps[i], &scene->lights[i]);
    }
    d->surface_count = scene->object_count;
    for (int i = 0; i < d->surface_count; i++) {
        load_surface(&d->surfaces[i], scene->objects[i].material, scene);
        d->has_layers = d->has_layers || d->surfaces[i].transmission > 0.0;
        const glint_texture *texture = scene->objects[i].material->texture;
        if (texture && (!texture->texels || !scene->objects[i].mesh->texcoords)) {
            return fail(error, error_bytes, "a texture with texels, and texture coordinates for it, were expected");
        }
        if (texture && picture_load(&d->surfaces[i].texture, texture)) {
            return fail(error, error_bytes, "no memory for a texture");
        }
        if (load_object(d, i, &scene->objects[i], error, error_bytes)) {
            return -1;
        }
    }
    return 0;
}
