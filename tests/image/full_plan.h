/* SPDX-License-Identifier: MIT */
/*
 * A plan that leaves nothing out, in the place of <glint/plan.h>'s for a copy of a backend: see test_pruning.h.
 */
#ifndef GLINT_TESTS_IMAGE_FULL_PLAN_H
#define GLINT_TESTS_IMAGE_FULL_PLAN_H

#include <glint/glint.h>

static inline void full_plan_object(const glint_scene *scene, uint16_t object, glint_object_plan *plan)
{
    glint_plan_object(scene, object, plan);
    if (plan->texture == GLINT_NOTHING_TO_COLOUR) {
        plan->texture = GLINT_NEEDED;
    }
    plan->ambient = plan->sky = plan->ground = plan->emission = plan->fog = GLINT_NEEDED;
}

static inline void full_plan_light(const glint_scene *scene, uint16_t object, const glint_object_plan *of_object,
                                   uint16_t light, glint_light_plan *plan)
{
    glint_plan_light(scene, object, of_object, light, plan);
    plan->diffuse = plan->specular = GLINT_NEEDED;
    if (scene->lights[light].casts_shadows && plan->shadow != GLINT_NOT_TAKEN) {
        plan->shadow = GLINT_NEEDED;
    }
}

/* Only where they are called: in parentheses the names stand for the library's. */
#define glint_plan_object(scene, object, plan) full_plan_object(scene, object, plan)
#define glint_plan_light(scene, object, of_object, light, plan) full_plan_light(scene, object, of_object, light, plan)

#endif
