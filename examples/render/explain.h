/* SPDX-License-Identifier: MIT */
/*
 * A frame in words: which terms of the model each object needs under each light, and why not the others; and what was
 * evaluated when it was drawn, by object and by light.
 */
#ifndef EXAMPLES_RENDER_EXPLAIN_H
#define EXAMPLES_RENDER_EXPLAIN_H

#include <stdio.h>

#include <glint/quality.h>
#include <glint/scene.h>

#include "observe.h"

/* The scene has been drawn in this quality, so it is valid; `report` and `seen` are of that frame. Returns 0, or -1
 * without memory. */
int explain(FILE *file, const glint_scene *scene, const glint_quality *quality, const glint_report *report,
            const observation *seen);

#endif
