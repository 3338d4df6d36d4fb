/* SPDX-License-Identifier: MIT */
/*
 * One scene in every way of shading: what the atlas's programs count and judge in place of tools/cost/cases.c. The
 * command line says which: ATLAS_NAME, ATLAS_SCENE (the name of a glint_scene), ATLAS_WIDTH_PX, ATLAS_HEIGHT_PX and
 * ATLAS_BAND_PX, 0 for the whole frame. Without, the teapot: so that this file can be compiled and checked alone.
 */
#include "tools/cost/cases.h"

#include "tools/cost/shadings.h"

#ifndef ATLAS_SCENE
#define ATLAS_NAME "teapot"
#define ATLAS_SCENE demo_teapot
#define ATLAS_WIDTH_PX 320
#define ATLAS_HEIGHT_PX 240
#define ATLAS_BAND_PX 0
#endif

extern const glint_scene ATLAS_SCENE;

#define FRAME ATLAS_NAME, &ATLAS_SCENE, NULL, 0, ATLAS_WIDTH_PX, ATLAS_HEIGHT_PX, ATLAS_BAND_PX

const cost_case cost_cases[] = {
    {FRAME, EXACT},        {FRAME, Q2},        {FRAME, Q1},        {FRAME, GOURAUD},   {FRAME, FLAT},
    {FRAME, WITHIN(0.75)}, {FRAME, WITHIN(1)}, {FRAME, WITHIN(2)}, {FRAME, WITHIN(4)}, {FRAME, WITHIN(8)},
};

const uint16_t cost_case_count = sizeof cost_cases / sizeof cost_cases[0];
