/* SPDX-License-Identifier: MIT */
/*
 * Surfaces that let light through: what is left of the light that they scatter, what a grazing angle makes of the light
 * behind, and the order in which their objects are drawn. The formulas are those of <glint/scene.h>.
 *
 * Integer arithmetic for both backends.
 */
#ifndef GLINT_EFFECTS_THROUGH_H
#define GLINT_EFFECTS_THROUGH_H

#include <glint/plan.h>
#include <glint/scene.h>

#include "display/pack.h"

/* What an object lets through. */
typedef struct glint_through {
    uint16_t t_q15;      /* 0: nothing, and nothing else is set */
    bool grazes;         /* less at grazing angles */
    glint_shade grazing; /* G */
    uint16_t error_q8;   /* what it adds to the error of a pixel's own colour, 1/256 code */
    int32_t order;       /* an object with a greater one is drawn before; see glint_through_order() */
} glint_through;

void glint_through_set_up(glint_through *through, const glint_scene *scene, uint16_t object,
                          const glint_object_plan *plan);

/*
 * The material without the light that goes through: ambient, diffuse and emitted colour times 1 - t. Each is rounded to
 * half a unit of Q14, which is in glint_through.error_q8 for each light of the scene.
 */
void glint_through_body(glint_material *body, const glint_material *material);

/*
 * (1 - |cosine|)^5 in Q15, for a cosine in Q15, at most a little beyond 1. Error 0.51 units of Q15 of the exact power,
 * and at most 5 times an error of the cosine.
 */
uint32_t glint_through_mirrored_q15(int32_t cosine_q15);

/* Adds a part, Q15 and at most 1, of a colour; at most to 1. */
void glint_through_add(glint_shade *shade, const glint_shade *colour, uint32_t part_q15);

/* colour (1 - through), Q15. */
glint_shade glint_through_rest(const glint_shade *colour, uint32_t through_q15);

/*
 * |C - eye|^2 - R^2 of a sphere, as a number of 32 bits that grows with it; relative error 2^-19, and of the distance
 * 2^-28. With two spheres apart, the greater of these is of the sphere that the other one may cover: the eye lies on
 * the other one's side of the plane in which the two powers are equal, which separates the spheres.
 */
int32_t glint_through_order(const glint_bounds *bounds, const int32_t eye_q16[3]);

#endif
