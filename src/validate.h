/* SPDX-License-Identifier: MIT */
/*
 * Checks everything that a caller hands in, before anything is written. What has passed here is asserted, not tested,
 * further on.
 */
#ifndef GLINT_VALIDATE_H
#define GLINT_VALIDATE_H

#include <glint/display.h>
#include <glint/quality.h>
#include <glint/scene.h>

/* GLINT_OK or a glint_error. Reads every index of every mesh. `parts` are those of the backend, see backend/parts.h:
 * GLINT_ERROR_PART where it lacks one. */
int glint_validate(const glint_scene *scene, const glint_display *display, const glint_quality *quality,
                   uint32_t parts);

/* The part of it that the size functions need: the scene's and the display's counts and sizes, no pixel function. */
int glint_validate_sizes(const glint_scene *scene, const glint_display *display);

#endif
