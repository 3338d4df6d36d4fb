/* SPDX-License-Identifier: MIT */
/*
 * Single faults in otherwise valid calls: what random numbers seldom come to.
 */
#ifndef GLINT_TESTS_FUZZ_SCENE_FAULTS_H
#define GLINT_TESTS_FUZZ_SCENE_FAULTS_H

#include "tests/fuzz/scene_effects.h"

/* One fault in an otherwise valid call; numbers beyond the list leave it alone. */
static inline void scene_case_break(scene_case *c, uint8_t fault)
{
    switch (fault) {
    case 0:
    case 1:
    case 2:
    case 3:
    case 4:
        c->null = (unsigned)1 << fault;
        break;
    case 5:
        c->scene.camera = NULL;
        break;
    case 6:
        c->scene.objects = NULL;
        break;
    case 7:
        c->scene.lights = NULL;
        break;
    case 8:
        c->objects[0].mesh = NULL;
        break;
    case 9:
        c->objects[0].material = NULL;
        break;
    case 10:
        c->meshes[0].positions = NULL;
        break;
    case 11:
        c->meshes[0].normals_q14 = NULL;
        break;
    case 12:
        c->meshes[0].triangles = NULL;
        break;
    case 13:
        c->meshes[0].vertex_count = 2;
        break;
    case 14:
        c->meshes[0].triangle_count = 0;
        break;
    case 15:
        c->meshes[0].fraction_bits = 25;
        break;
    case 16:
        c->meshes[0].fraction_bits = -1;
        break;
    case 17:
        c->scene.light_count = GLINT_MAX_LIGHTS + 1; /* the array is not that long: it must not be looked at */
        break;
    case 18:
        memcpy(c->camera.target_q16, c->camera.eye_q16, sizeof c->camera.eye_q16);
        break;
    case 19:
        memcpy(c->objects[0].place.linear_q16[1], c->objects[0].place.linear_q16[0], sizeof(int32_t[3]));
        break;
    case 20:
        ((uint16_t(*)[3])c->allocated[2])[c->meshes[0].triangle_count - 1][0] = c->meshes[0].vertex_count;
        break;
    case 21:
        ((uint16_t(*)[3])c->allocated[2])[c->meshes[0].triangle_count - 1][1] = c->meshes[0].vertex_count;
        break;
    case 22:
        ((uint16_t(*)[3])c->allocated[2])[c->meshes[0].triangle_count - 1][2] = c->meshes[0].vertex_count;
        break;
    case 23:
        c->camera.near_q16 = 63;
        break;
    case 24:
        c->camera.field_of_view_turn16 = 181;
        break;
    case 25:
        c->camera.eye_q16[1] = -((int32_t)1 << 30) - 1;
        break;
    case 26:
        c->objects[0].place.origin_q16[2] = ((int32_t)1 << 30) + 1;
        break;
    case 27:
        c->lights[0].colour.b_q14 = -1;
        break;
    case 28:
        c->materials[0].specular.g_q14 = 16385;
        break;
    case 29:
        c->materials[0].exponent_q4 = GLINT_MAX_EXPONENT * 16 + 1;
        break;
    case 30:
        c->scene.background.r_q14 = 16385;
        break;
    case 31:
        c->lights[0].kind = GLINT_POINT;
        c->lights[0].position_q16[0] = INT32_MIN;
        break;
    default:
        break;
    }
}

/* One fault in the effects of an otherwise valid scene; numbers beyond the list leave it alone. */
static inline void scene_case_break_effect(scene_case *c, uint8_t fault)
{
    glint_light *light = &c->lights[0];
    glint_material *material = &c->materials[0];
    switch (fault) {
    case 0:
        light->kind = GLINT_SPOT;
        light->inner_turn16 = 4000;
        light->outer_turn16 = 4000 + GLINT_LEAST_CONE_TURN16 - 1;
        break;
    case 1: /* turned round */
        light->kind = GLINT_SPOT;
        light->inner_turn16 = 4000;
        light->outer_turn16 = 2000;
        break;
    case 2:
        light->kind = GLINT_SPOT;
        light->outer_turn16 = GLINT_WIDEST_CONE_TURN16 + 1;
        break;
    case 3:
        light->kind = GLINT_SPOT;
        memset(light->direction, 0, sizeof light->direction);
        break;
    case 4:
        light->kind = GLINT_POINT;
        light->attenuation.range_q16 = GLINT_LEAST_DISTANCE_Q16 - 1;
        break;
    case 5:
        light->kind = GLINT_POINT;
        light->attenuation.unit_q16 = UINT32_MAX;
        break;
    case 6:
        light->kind = GLINT_BALL;
        light->radius_q16 = -1;
        break;
    case 7:
        light->kind = GLINT_PANEL;
        light->position_q16[1] = 1;
        light->edge_q16[0][1] = -((int32_t)1 << 30);
        light->edge_q16[1][1] = 0;
        break;
    case 8:
        light->kind = GLINT_PANEL;
        light->edge_q16[0][2] = light->edge_q16[1][2] = INT32_MIN; /* the sum is 0 in 32 bits */
        break;
    case 9:
        light->kind = GLINT_BALL;
        light->samples = GLINT_MAX_SAMPLES + 1;
        break;
    case 10:
        light->kind = GLINT_PANEL;
        light->casts_shadows = true;
        break;
    case 11:
        c->scene.sky.g_q14 = -1;
        break;
    case 12:
        c->scene.ground.b_q14 = INT16_MIN;
        break;
    case 13:
        c->scene.fog.begin_q16 = 65536;
        c->scene.fog.end_q16 = 65536 + GLINT_LEAST_DISTANCE_Q16 - 1;
        break;
    case 14:
        c->scene.fog.begin_q16 = -1;
        c->scene.fog.end_q16 = 65536;
        break;
    case 15:
        c->scene.fog.end_q16 = 65536;
        c->scene.fog.colour.r_q14 = 16385;
        break;
    case 16:
        material->emission.b_q14 = -1;
        break;
    case 17:
        material->mirror.r_q14 = 16385;
        break;
    case 18:
        material->mirror.r_q14 = 1;
        c->scene.environment = NULL;
        break;
    case 19:
        c->environment.side = 24;
        c->scene.environment = &c->environment;
        break;
    case 20:
        c->environment.side = 8;
        c->environment.texels = NULL;
        c->scene.environment = &c->environment;
        break;
    case 21:
        material->sides = GLINT_TWO_SIDED + 1;
        break;
    case 22:
        material->shadows = 4;
        break;
    case 23:
        material->transmission_q14 = 16385;
        break;
    case 24:
        material->grazing.g_q14 = -1;
        break;
    case 25:
        material->wire_width_q4 = GLINT_MAX_WIRE_Q4 + 1;
        break;
    case 26:
        material->wire.r_q14 = 16385; /* also without a width */
        break;
    case 27:
        c->textures[0].width_px = 0;
        break;
    case 28:
        c->textures[0].texels = NULL;
        break;
    case 29:
        c->textures[0].format = GLINT_TEXTURE_PALETTE8;
        c->textures[0].palette_count = GLINT_MAX_PALETTE + 1;
        break;
    case 30:
        c->meshes[0].texcoords = NULL;
        break;
    case 31:
        c->meshes[0].texcoord_bits = GLINT_MAX_TEXCOORD_BITS + 1;
        break;
    default:
        break;
    }
}

#endif
