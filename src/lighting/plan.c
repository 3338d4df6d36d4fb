/* SPDX-License-Identifier: MIT */
#include <glint/plan.h>

#include "geometry/place.h"
#include "lighting/source.h"
#include "number/fixed.h"

const char *glint_reason_text(int reason)
{
    switch ((glint_reason)reason) {
    case GLINT_NEEDED:
        return "needed";
    case GLINT_REFLECTANCE_ZERO:
        return "the material has none of it";
    case GLINT_LIGHT_ZERO:
        return "the light is black";
    case GLINT_NO_COMMON_COLOUR:
        return "light and material have no channel in common";
    case GLINT_OUT_OF_RANGE:
        return "the object is beyond the light's range";
    case GLINT_OUTSIDE_CONE:
        return "the object is outside of the light's cone";
    case GLINT_NOT_IN_SCENE:
        return "the scene has none of it";
    case GLINT_IN_FRONT:
        return "the object is in front of it";
    case GLINT_NOTHING_TO_COLOUR:
        return "there is neither ambient nor diffuse light that it could colour";
    case GLINT_NOT_CAST:
        return "the light casts no shadows";
    case GLINT_NOT_TAKEN:
        return "the object takes no shadows";
    case GLINT_NOTHING_CASTS:
        return "no object casts a shadow";
    default:
        return "unknown reason";
    }
}

static bool is_black(const glint_colour *colour)
{
    return (colour->r_q14 | colour->g_q14 | colour->b_q14) == 0;
}

static glint_reason reason_of(const glint_colour *reflectance, const glint_colour *light)
{
    if (is_black(reflectance)) {
        return GLINT_REFLECTANCE_ZERO;
    }
    if (is_black(light)) {
        return GLINT_LIGHT_ZERO;
    }
    const int32_t r = (int32_t)reflectance->r_q14 * light->r_q14, g = (int32_t)reflectance->g_q14 * light->g_q14,
                  b = (int32_t)reflectance->b_q14 * light->b_q14;
    return (r | g | b) == 0 ? GLINT_NO_COMMON_COLOUR : GLINT_NEEDED;
}

/* Of the ambient and diffuse terms, those of lights out of reach included: a light that moves changes no texture. */
static glint_reason reason_of_texture(const glint_scene *scene, const glint_material *material,
                                      const glint_object_plan *plan)
{
    if (material->texture == NULL) {
        return GLINT_REFLECTANCE_ZERO;
    }
    bool any = plan->ambient == GLINT_NEEDED || plan->sky == GLINT_NEEDED || plan->ground == GLINT_NEEDED;
    for (uint16_t i = 0; i < scene->light_count && !any; i++) {
        any = reason_of(&material->diffuse, &scene->lights[i].colour) == GLINT_NEEDED;
    }
    return any ? GLINT_NEEDED : GLINT_NOTHING_TO_COLOUR;
}

static bool has_reach(const glint_light *light)
{
    return light->kind == GLINT_SPOT || (light->kind != GLINT_DIRECTIONAL && light->attenuation.range_q16 != 0);
}

/* Half the box of the mesh's vertices goes through the place to half a box along the world's axes. */
static void bounds_of(const glint_object *object, glint_bounds *bounds)
{
    const glint_mesh *mesh = object->mesh;
    int32_t linear_q16[3][3];
    int64_t square = 0;
    int16_t low[3], high[3];
    for (int k = 0; k < 3; k++) {
        low[k] = INT16_MAX;
        high[k] = INT16_MIN;
    }
    for (uint16_t v = 0; v < mesh->vertex_count; v++) {
        for (int k = 0; k < 3; k++) {
            const int16_t p = flash_s16(&mesh->positions[v][k]);
            low[k] = p < low[k] ? p : low[k];
            high[k] = p > high[k] ? p : high[k];
        }
    }
    glint_linear_of(&object->place, linear_q16);
    for (int i = 0; i < 3; i++) {
        int64_t centre = 0, half = 0; /* Q(17 + fraction_bits), below 2^26 2^17 3 */
        for (int k = 0; k < 3; k++) {
            centre += (int64_t)linear_q16[i][k] * ((int32_t)low[k] + high[k]);
            half += (int64_t)magnitude32(linear_q16[i][k]) * ((int32_t)high[k] - low[k]);
        }
        bounds->centre_q16[i] = object->place.origin_q16[i] + glint_shift_round64(centre, -1 - mesh->fraction_bits);
        /* 2 units: the centre's rounding, and the shift's */
        half = (half >> (1 + mesh->fraction_bits)) + 2;
        bounds->half_q16[i] = half;
        /* in steps of 2^14, so that the sum of squares fits: below 2^45 2^-14 */
        half = (half >> 14) + 1;
        square += half * half;
    }
    bounds->radius_q16 = ((int64_t)glint_square_root_u64((uint64_t)square) + 1) * ((int64_t)1 << 14);
}

/* Positions in steps of 2^down Q16 units in which no difference has more than 30 bits. */
typedef struct apart {
    int64_t away[3]; /* from the light to the centre */
    int64_t distance, radius, range;
    int down;
} apart;

static apart apart_of(const glint_light *light, const glint_bounds *bounds)
{
    apart a;
    uint64_t any = 1, square = 0;
    for (int k = 0; k < 3; k++) {
        a.away[k] = bounds->centre_q16[k] - light->position_q16[k];
        any |= magnitude64(a.away[k]);
    }
    a.down = bit_length64(any) > 30 ? bit_length64(any) - 30 : 0;
    for (int k = 0; k < 3; k++) {
        a.away[k] = glint_shift_round64(a.away[k], -a.down);
        square += (uint64_t)(a.away[k] * a.away[k]); /* < 3 2^60 */
    }
    a.distance = glint_square_root_u64(square);
    a.radius = (bounds->radius_q16 >> a.down) + 4; /* with what rounding moved the centre by */
    a.range = ((int64_t)light->attenuation.range_q16 >> a.down) + 1;
    return a;
}

/* Is a sphere outside of the cone? With x the angle of its centre off the axis, when its distance from the cone's
 * surface, |away| sin(x - outer), is at least the radius, and x at least the outer angle. */
static bool outside_cone(const glint_light *light, const apart *a)
{
    int64_t direction[3], away[3];
    int32_t axis_q30[3], towards_q30[3], sine_q30, cosine_q30;
    for (int k = 0; k < 3; k++) {
        direction[k] = light->direction[k];
        away[k] = a->away[k];
    }
    if (!glint_unit_q30(away, towards_q30) || a->distance <= a->radius) {
        return false;
    }
    (void)glint_unit_q30(direction, axis_q30);
    glint_sine_cosine_q30(light->outer_turn16, &sine_q30, &cosine_q30);
    /* cos x, and sin x from below by its square */
    int64_t cosine = 0;
    for (int k = 0; k < 3; k++) {
        cosine += (int64_t)axis_q30[k] * towards_q30[k];
    }
    const int64_t cos_x_q30 = cosine >> 30;
    const int64_t rest = ((int64_t)1 << 60) - cos_x_q30 * cos_x_q30;
    const int64_t sin_x_q30 = rest > 0 ? (int64_t)glint_square_root_u64((uint64_t)rest) : 0;
    /* sin(x - outer), less 2^-14 for the root near 0 */
    const int64_t sine = ((sin_x_q30 * cosine_q30 - cos_x_q30 * sine_q30) >> 30) - ((int64_t)1 << 16);
    return cos_x_q30 < cosine_q30 && (a->distance * sine >> 30) > a->radius;
}

/* The depth of the farthest point of a sphere along the view direction, Q16, rounded up. */
static int64_t farthest_q16(const glint_camera *camera, const glint_bounds *bounds)
{
    int64_t forward[3], away[3], depth = 0;
    int32_t forward_q30[3];
    uint64_t any = 1;
    for (int k = 0; k < 3; k++) {
        forward[k] = (int64_t)camera->target_q16[k] - camera->eye_q16[k];
        away[k] = bounds->centre_q16[k] - camera->eye_q16[k];
        any |= magnitude64(away[k]);
    }
    (void)glint_unit_q30(forward, forward_q30);
    const int down = bit_length64(any) > 31 ? bit_length64(any) - 31 : 0;
    for (int k = 0; k < 3; k++) {
        depth += (away[k] >> down) * forward_q30[k];
    }
    /* three parts cut to so many bits, the sum's, and the direction's 6 units of 2^-30 a component */
    return ((depth >> 30) + 40) * ((int64_t)1 << down) + bounds->radius_q16;
}

static glint_reason fog_reason(const glint_scene *scene, const glint_bounds *bounds)
{
    return farthest_q16(scene->camera, bounds) <= scene->fog.begin_q16 ? GLINT_IN_FRONT : GLINT_NEEDED;
}

void glint_plan_object(const glint_scene *scene, uint16_t object, glint_object_plan *plan)
{
    const glint_material *material = scene->objects[object].material;
    plan->ambient = (uint8_t)reason_of(&material->ambient, &scene->ambient);
    plan->sky = (uint8_t)reason_of(&material->ambient, &scene->sky);
    plan->ground = (uint8_t)reason_of(&material->ambient, &scene->ground);
    plan->emission = (uint8_t)(is_black(&material->emission) ? GLINT_REFLECTANCE_ZERO : GLINT_NEEDED);
    plan->texture = (uint8_t)reason_of_texture(scene, material, plan);
    plan->mirror = (uint8_t)(is_black(&material->mirror) ? GLINT_REFLECTANCE_ZERO : GLINT_NEEDED);
    const bool has_fog = (scene->fog.begin_q16 | scene->fog.end_q16) != 0;
    const bool lets_through = material->transmission_q14 != 0;
    plan->transmission = (uint8_t)(lets_through ? GLINT_NEEDED : GLINT_REFLECTANCE_ZERO);
    plan->grazing = (uint8_t)(lets_through && !is_black(&material->grazing) ? GLINT_NEEDED : GLINT_REFLECTANCE_ZERO);
    plan->wire = (uint8_t)(material->wire_width_q4 != 0 ? GLINT_NEEDED : GLINT_REFLECTANCE_ZERO);
    plan->needs_bounds = has_fog || lets_through;
    for (uint16_t i = 0; i < scene->light_count; i++) {
        plan->needs_bounds =
            plan->needs_bounds || has_reach(&scene->lights[i]) || glint_source_extends(&scene->lights[i]);
    }
    if (plan->needs_bounds) {
        bounds_of(&scene->objects[object], &plan->bounds);
    }
    plan->fog = (uint8_t)(has_fog ? fog_reason(scene, &plan->bounds) : GLINT_NOT_IN_SCENE);
}

static bool anything_casts(const glint_scene *scene)
{
    for (uint16_t i = 0; i < scene->object_count; i++) {
        if ((scene->objects[i].material->shadows & GLINT_CASTS_NO_SHADOW) == 0) {
            return true;
        }
    }
    return false;
}

/* Of a light that adds something to the object: whether shadows may take it away. */
static glint_reason shadow_reason(const glint_scene *scene, const glint_material *material, const glint_light *light)
{
    return !light->casts_shadows                              ? GLINT_NOT_CAST
           : (material->shadows & GLINT_TAKES_NO_SHADOW) != 0 ? GLINT_NOT_TAKEN
           : !anything_casts(scene)                           ? GLINT_NOTHING_CASTS
                                                              : GLINT_NEEDED;
}

void glint_plan_light(const glint_scene *scene, uint16_t object, const glint_object_plan *of_object, uint16_t light,
                      glint_light_plan *plan)
{
    const glint_material *material = scene->objects[object].material;
    const glint_light *source = &scene->lights[light];
    const glint_attenuation *attenuation = &source->attenuation;
    plan->diffuse = (uint8_t)reason_of(&material->diffuse, &source->colour);
    plan->specular = (uint8_t)reason_of(&material->specular, &source->colour);
    plan->cone = source->kind == GLINT_SPOT;
    plan->attenuation =
        source->kind != GLINT_DIRECTIONAL &&
        (attenuation->range_q16 != 0 || (attenuation->k_q14[0] | attenuation->k_q14[1] | attenuation->k_q14[2]) != 0);
    plan->shadow = (uint8_t)shadow_reason(scene, material, source);
    if (plan->diffuse != GLINT_NEEDED && plan->specular != GLINT_NEEDED) {
        plan->shadow = plan->diffuse;
        return;
    }
    if (!has_reach(source)) {
        return;
    }
    const apart a = apart_of(source, &of_object->bounds);
    const glint_reason reason =
        attenuation->range_q16 != 0 &&
                a.distance > a.radius + a.range + (int64_t)(glint_source_size_q16(source) >> a.down)
            ? GLINT_OUT_OF_RANGE
        : plan->cone && outside_cone(source, &a) ? GLINT_OUTSIDE_CONE
                                                 : GLINT_NEEDED;
    if (reason != GLINT_NEEDED) {
        plan->diffuse = (uint8_t)(plan->diffuse == GLINT_NEEDED ? (uint8_t)reason : plan->diffuse);
        plan->specular = (uint8_t)(plan->specular == GLINT_NEEDED ? (uint8_t)reason : plan->specular);
        plan->shadow = (uint8_t)reason;
    }
}
