/* SPDX-License-Identifier: MIT */
/*
 * The plan: which terms of the model an object needs under each light, and why it does not need the others. The
 * renderers make it for every object before they draw it and do what it says; a program may ask for it too, to tell a
 * person what a scene costs (glint-render --explain).
 *
 * What the plan leaves out is zero at every point of the object, so leaving it out changes no pixel.
 */
#ifndef GLINT_PLAN_H
#define GLINT_PLAN_H

#include <stdbool.h>
#include <stdint.h>

#include <glint/scene.h>

#ifdef __cplusplus
extern "C" {
#endif

/* Why a term is left out. */
typedef enum glint_reason {
    GLINT_NEEDED = 0,           /* it is not */
    GLINT_REFLECTANCE_ZERO = 1, /* the material has no reflectance (or emission) for it */
    GLINT_LIGHT_ZERO = 2,       /* the light, or the scene's ambient light, is black */
    GLINT_NO_COMMON_COLOUR = 3, /* neither is black, but no channel has both: a blue light on a red surface */
    GLINT_OUT_OF_RANGE = 4,     /* the whole object is at least the light's range away from it */
    GLINT_OUTSIDE_CONE = 5,     /* the whole object is outside of the spot light's outer cone */
    GLINT_NOT_CAST = 6,         /* shadows: the light casts none */
    GLINT_NOT_TAKEN = 7,        /* shadows: the object takes none */
    GLINT_NOTHING_CASTS = 8     /* shadows: no object of the scene casts any */
} glint_reason;

/* A sentence in English, never NULL. */
const char *glint_reason_text(int reason);

/* A sphere in world space that holds an object: coordinates and radius in Q16 world units, rounded outwards. */
typedef struct glint_bounds {
    int64_t centre_q16[3], radius_q16;
} glint_bounds;

typedef struct glint_object_plan {
    uint8_t ambient, sky, ground, emission; /* glint_reason of each term that no light is needed for */
    bool needs_bounds;                      /* some light may be too far away */
    glint_bounds bounds;                    /* only where needs_bounds */
} glint_object_plan;

typedef struct glint_light_plan {
    uint8_t diffuse, specular; /* glint_reason of each term */
    uint8_t shadow;            /* glint_reason: shadows of this light may fall on the object, or why not */
    bool attenuation, cone;    /* if one of these is needed: its factors a (or w) and b are evaluated */
} glint_light_plan;

/* Object and light by their numbers in a scene that glint_*_render() would accept. */
void glint_plan_object(const glint_scene *scene, uint16_t object, glint_object_plan *plan);
void glint_plan_light(const glint_scene *scene, uint16_t object, const glint_object_plan *of_object, uint16_t light,
                      glint_light_plan *plan);

#ifdef __cplusplus
}
#endif

#endif
