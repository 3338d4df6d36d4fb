/* SPDX-License-Identifier: MIT */
#include <glint/plan.h>

#include "backend/parts.h"
#include "lighting/plan.inc"

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

void glint_plan_object(const glint_scene *scene, uint16_t object, glint_object_plan *plan)
{
    plan_object(scene, object, plan);
}

void glint_plan_light(const glint_scene *scene, uint16_t object, const glint_object_plan *of_object, uint16_t light,
                      glint_light_plan *plan)
{
    plan_light(scene, object, of_object, light, plan);
}
