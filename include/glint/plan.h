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
    GLINT_NEEDED = 0,            /* it is not */
    GLINT_REFLECTANCE_ZERO = 1,  /* the material has no reflectance (or emission) for it */
    GLINT_LIGHT_ZERO = 2,        /* the light, or the scene's ambient light, is black */
    GLINT_NO_COMMON_COLOUR = 3,  /* neither is black, but no channel has both: a blue light on a red surface */
    GLINT_OUT_OF_RANGE = 4,      /* the whole object is at least the light's range away from it */
    GLINT_OUTSIDE_CONE = 5,      /* the whole object is outside of the spot light's outer cone */
    GLINT_NOT_IN_SCENE = 6,      /* the scene has none of it */
    GLINT_IN_FRONT = 7,          /* the whole object is in front of where the fog begins */
    GLINT_NOTHING_TO_COLOUR = 8, /* the texture has neither ambient nor diffuse light to multiply */
    GLINT_NOT_CAST = 9,          /* shadows: the light casts none */
    GLINT_NOT_TAKEN = 10,        /* shadows: the object takes none */
    GLINT_NOTHING_CASTS = 11     /* shadows: no object of the scene casts any */
} glint_reason;

/* A sentence in English, never NULL. */
const char *glint_reason_text(int reason);

/* A sphere in world space that holds an object: coordinates and radius in Q16 world units, rounded outwards. */
typedef struct glint_bounds {
    int64_t centre_q16[3], radius_q16;
    int64_t half_q16[3]; /* half the edges of a box about the same centre that holds it too */
} glint_bounds;

typedef struct glint_object_plan {
    uint8_t ambient, sky, ground, emission, mirror; /* glint_reason of each term that no light is needed for */
    uint8_t texture;                                /* glint_reason of the factor T of ambient and diffuse terms */
    uint8_t fog;                                    /* glint_reason: is fog mixed in at the object's pixels? */
    uint8_t transmission, grazing;                  /* glint_reason: does light come through, less at grazing angles? */
    uint8_t wire;                                   /* glint_reason: are edges drawn? */
    bool needs_bounds;   /* some light may be too far away or has an extent, there may be fog, or light comes through */
    glint_bounds bounds; /* where needs_bounds, else 0 */
} glint_object_plan;

typedef struct glint_light_plan {
    uint8_t diffuse, specular; /* glint_reason of each term */
    uint8_t shadow;            /* glint_reason: shadows of this light may fall on the object, or why not */
    bool attenuation, cone;    /* if one of these is needed: its factors a (or w) and b are evaluated */
} glint_light_plan;

/*
 * How many point lights stand for a light, and what they leave out: the greatest difference between their mean and the
 * light of the whole source, anywhere on the object, for normals in any direction. It is bounded by the source's size
 * over its distance from the object's box; specular light also by the exponent, and by how near source, object and eye
 * are to lying in a line, where the highlight is cut off at n.s = 0. Sources that are not extended are one point light
 * and leave out nothing.
 */
typedef struct glint_source_plan {
    uint8_t points;    /* 1..samples */
    bool enough;       /* error_q8 is within the room; else as many as `samples` allows */
    uint32_t error_q8; /* 1/256 code, in the strongest channel */
} glint_source_plan;

/* Object and light by their numbers in a scene that glint_*_render() would accept. */
void glint_plan_object(const glint_scene *scene, uint16_t object, glint_object_plan *plan);
void glint_plan_light(const glint_scene *scene, uint16_t object, const glint_object_plan *of_object, uint16_t light,
                      glint_light_plan *plan);

/* Of a light that has a term: the fewest points that are within an error of `room_q8`. */
void glint_plan_source(const glint_scene *scene, uint16_t object, const glint_object_plan *of_object, uint16_t light,
                       const glint_light_plan *of_light, uint32_t room_q8, glint_source_plan *plan);

/* The room that a tolerance (glint_quality.tolerance) leaves to each extended source of the scene: half of what it has
 * above the rounding to whole codes; without a tolerance 1/4 code. All share it. */
uint32_t glint_plan_room_q8(const glint_scene *scene, uint8_t tolerance);

#ifdef __cplusplus
}
#endif

#endif
