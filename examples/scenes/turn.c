/* SPDX-License-Identifier: MIT */
/*
 * Turning a scene in front of its camera. See scenes.h.
 */
#include <stddef.h>

#include <examples/scenes/scenes.h>
#include <glint/place.h>

static int is_zero(const glint_place *place)
{
    for (int i = 0; i < 3; i++) {
        for (int k = 0; k < 3; k++) {
            if (place->linear_q16[i][k] != 0) {
                return 0;
            }
        }
    }
    return 1;
}

int demo_scene_turn(const glint_scene *in, uint16_t angle_turn16, glint_object *objects, glint_scene *out)
{
    if (in == NULL || objects == NULL || out == NULL) {
        return GLINT_ERROR_NULL_ARGUMENT;
    }
    if (in->camera == NULL) {
        return GLINT_ERROR_NULL_CAMERA;
    }
    if (in->objects == NULL && in->object_count > 0) {
        return GLINT_ERROR_NULL_OBJECTS;
    }

    /* out and back about the axis; |target| <= 2^30, so the negation fits */
    const int32_t *target = in->camera->target_q16;
    glint_place to_axis = glint_shift(-target[0], 0, -target[2]);
    glint_place from_axis = glint_shift(target[0], 0, target[2]);
    glint_place turn = glint_turn_y(angle_turn16);
    glint_place turn_back = glint_then(&turn, &from_axis);

    for (uint16_t i = 0; i < in->object_count; i++) {
        glint_object object = in->objects[i];
        if (is_zero(&object.place)) { /* zero stands for the identity, with the origin as it is */
            for (int k = 0; k < 3; k++) {
                object.place.linear_q16[k][k] = INT32_C(1) << 16;
            }
        }
        glint_place centred = glint_then(&object.place, &to_axis);
        object.place = glint_then(&centred, &turn_back);
        objects[i] = object;
    }
    glint_scene turned = *in;
    turned.objects = objects;
    *out = turned;
    return GLINT_OK;
}
