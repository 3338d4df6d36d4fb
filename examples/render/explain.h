/* SPDX-License-Identifier: MIT */
/*
 * The plan of a frame in words: which terms of the model each object needs under each light, why not the others, and
 * what was evaluated when it was drawn.
 */
#ifndef EXAMPLES_RENDER_EXPLAIN_H
#define EXAMPLES_RENDER_EXPLAIN_H

#include <stdio.h>

#include <glint/quality.h>
#include <glint/scene.h>

/* The scene has been drawn, so it is valid; `report` is of that frame. */
void explain(FILE *file, const glint_scene *scene, const glint_report *report);

#endif
