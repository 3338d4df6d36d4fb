/* SPDX-License-Identifier: MIT */
/*
 * What validation, memory and plan ask of a scene alike.
 */
#ifndef GLINT_ASKED_SCENE_H
#define GLINT_ASKED_SCENE_H

#include <stdbool.h>
#include <stddef.h>

#include <glint/scene.h>

static inline bool is_black(const glint_colour *colour)
{
    return (colour->r_q14 | colour->g_q14 | colour->b_q14) == 0;
}

static inline bool has_fog(const glint_scene *scene)
{
    return (scene->fog.begin_q16 | scene->fog.end_q16) != 0;
}

/* Does less of a light arrive the farther away it is? */
static inline bool is_attenuated(const glint_light *light)
{
    const glint_attenuation *a = &light->attenuation;
    return light->kind != GLINT_DIRECTIONAL && (a->range_q16 != 0 || (a->k_q14[0] | a->k_q14[1] | a->k_q14[2]) != 0);
}

/* Does it depend on the place how much of a light arrives? */
static inline bool light_reaches(const glint_light *light)
{
    return light->kind == GLINT_SPOT || is_attenuated(light);
}

/* Questions about a material are asked before it is known to be there. */

static inline bool material_mirrors(const glint_material *material)
{
    return material != NULL && !is_black(&material->mirror);
}

/* A see-through object of two sides is gone through twice. */
static inline bool drawn_twice(const glint_material *material)
{
    return material != NULL && material->transmission_q14 != 0 && material->sides != GLINT_FRONT_SIDE;
}

#endif
