/* SPDX-License-Identifier: MIT */
/*
 * Environments that mirrors of the built-in scenes show. Generated: see tools/generate-environment.c.
 */
#ifndef EXAMPLES_SCENES_ENVIRONMENTS_H
#define EXAMPLES_SCENES_ENVIRONMENTS_H

#include <glint/scene.h>

/* A blue sky with a low sun over a tiled ground, 64 texels wide: 8 KB. */
extern const glint_environment demo_environment_sky;

#endif
