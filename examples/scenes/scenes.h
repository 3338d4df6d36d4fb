/* SPDX-License-Identifier: MIT */
/*
 * The built-in scenes: constant data in the library's formats, so that firmware links the same bits that the host draws
 * and the tests compare. Each family of scenes is one object file, and the table demo_scenes[] is another: a program
 * that names one scene, say demo_teapot, links that scene's family and its meshes and nothing more.
 */
#ifndef EXAMPLES_SCENES_SCENES_H
#define EXAMPLES_SCENES_SCENES_H

#include <stdint.h>

#include <glint/error.h>
#include <glint/scene.h>

#ifdef __cplusplus
extern "C" {
#endif

typedef struct demo_scene {
    const char *name;  /* as on a command line: "sphere-10x6" */
    const char *title; /* one line */
    const glint_scene *scene;
    uint16_t width_px, height_px; /* the size that the scene is designed for */
} demo_scene;

/* All built-in scenes, in the order of a gallery. */
extern const demo_scene demo_scenes[];
extern const uint16_t demo_scene_count;

/* The built-in scene with exactly this name, or NULL if there is none (or `name` is NULL). */
const demo_scene *demo_scene_named(const char *name);

/*
 * A copy of scene `in` with all its objects turned about the vertical line (the world's y) through the camera's target,
 * counter-clockwise seen from above, in 1/65536 turn. Camera, lights and materials are shared with `in` and stay.
 *
 * objects: `in->object_count` elements; may be in->objects itself where that is writable.
 * out: may be `in` itself.
 * At angle 0 each place has the same effect, bit for bit (a zero linear part is written out as the identity).
 * Otherwise an entry is within 0.51 ulp (Q16) of the exact value, and another 0.51 for each unit of the two values that
 * it turns, from the rounded sine and cosine: 6 ulp for an object 10 units off the axis.
 *
 * Returns 0, or GLINT_ERROR_NULL_ARGUMENT, GLINT_ERROR_NULL_CAMERA, GLINT_ERROR_NULL_OBJECTS; then nothing is written.
 */
int demo_scene_turn(const glint_scene *in, uint16_t angle_turn16, glint_object *objects, glint_scene *out);

/* spheres.c: a lit sphere in three tessellations, and with Blinn's cosine in place of Phong's */
extern const glint_scene demo_sphere_10x6, demo_sphere_32x16, demo_sphere_64x32;
extern const glint_scene demo_blinn;

/* teapot.c */
extern const glint_scene demo_teapot;

/* knot.c */
extern const glint_scene demo_torus_knot;

/* room.c: several objects in a room, directional and point lights */
extern const glint_scene demo_room;

/* point_light.c: a near point light over a floor */
extern const glint_scene demo_point_light;

/* sources.c: spot lights and attenuated ones, sky and ground, surfaces that emit light */
extern const glint_scene demo_spots, demo_open_sky, demo_lanterns;

/* extended.c: panels, and a ball */
extern const glint_scene demo_panels, demo_globe;

/* mirror.c: surfaces that mirror a sky */
extern const glint_scene demo_chrome, demo_gilded;

/* kinds.c: the same things under lights of each kind; a hall of eight lamps, of which two reach its middle */
extern const glint_scene demo_source_directional, demo_source_point, demo_source_four, demo_source_panel;
extern const glint_scene demo_eight_lamps;

/* blend.c: surfaces seen from both sides; fog; surfaces that let light through; a mesh's edges */
extern const glint_scene demo_bowls, demo_avenue, demo_glass, demo_pond, demo_mesh;

/* shadows.c: hard shadows of the sun, and of lamps in a room */
extern const glint_scene demo_shadows_sun, demo_shadows_lamps;

/* textured.c: a tiled floor and a wooden wall, a planet */
extern const glint_scene demo_tiles, demo_planet;

/* gallery_ratio.c: a row of spheres, ambient to diffuse ratio growing to the right */
extern const glint_scene demo_ambient_ratio;

/* gallery_specular.c: a grid of spheres, specular share growing downwards, exponent growing to the right; a row of
 * them, exponent growing to the right */
extern const glint_scene demo_specular_grid, demo_exponents;

/* gallery_terms.c: one still life with growing parts of the model */
extern const glint_scene demo_ambient_only, demo_diffuse_only, demo_full_phong;

/* gallery_lights.c: one still life under more and more lights */
extern const glint_scene demo_lights_blue, demo_lights_blue_red, demo_lights_blue_red_green;
extern const glint_scene demo_three_lights, demo_many_lights;

#ifdef __cplusplus
}
#endif

#endif
