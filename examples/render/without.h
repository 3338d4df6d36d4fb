/* SPDX-License-Identifier: MIT */
/*
 * A scene without some of its effects: the copy that glint-render --without draws.
 */
#ifndef EXAMPLES_RENDER_WITHOUT_H
#define EXAMPLES_RENDER_WITHOUT_H

#include <stddef.h>
#include <stdint.h>

#include <glint/scene.h>

/* The names of all effects, two lines of --help. */
#define WITHOUT_NAMES_1 "ambient, diffuse, specular, sky, emission, mirror, texture, attenuation, cones,"
#define WITHOUT_NAMES_2 "extents, shadows, fog, transmission, grazing, wire, sides"

/* Reads names of effects with commas between: a bit for each. Returns 0; or -1 with a sentence in `error`. */
int without_parse(const char *names, uint32_t *effects, char *error, size_t error_bytes);

/* What a copy is made of besides the scene itself. Free it with without_free(); a zeroed one is empty. */
typedef struct without_copy {
    glint_object *objects;
    glint_material *materials; /* one for each object */
    glint_light *lights;
} without_copy;

/* The scene, whose pointers are valid, without these effects: their fields are zero in the copy, the rest is as it is.
 * Returns 0; or -1 with a sentence in `error`: the scene has not got one of them, or memory ran out. */
int without(const glint_scene *in, uint32_t effects, without_copy *copy, glint_scene *out, char *error,
            size_t error_bytes);
void without_free(without_copy *copy);

#endif
