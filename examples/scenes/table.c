/* SPDX-License-Identifier: MIT */
/*
 * The list of all built-in scenes. A program that uses this file links every scene; see scenes.h.
 */
#include <stddef.h>

#include <examples/scenes/scenes.h>

const demo_scene demo_scenes[] = {
    {"sphere-10x6", "A lit sphere of 100 triangles", &demo_sphere_10x6, 240, 240},
    {"sphere-32x16", "The yardstick: a lit sphere of 960 triangles", &demo_sphere_32x16, 240, 240},
    {"sphere-64x32", "A lit sphere of 3,968 triangles", &demo_sphere_64x32, 240, 240},
    {"blinn", "The yardstick with Blinn's n.h in place of Phong's r.c", &demo_blinn, 240, 240},
    {"teapot", "The Utah teapot in copper", &demo_teapot, 320, 240},
    {"torus-knot", "A (2,3) torus knot in glossy plastic", &demo_torus_knot, 240, 240},
    {"room", "A room with furniture, a directional and two point lights", &demo_room, 320, 240},
    {"point-light", "A near point light over a floor", &demo_point_light, 320, 240},
    {"spots", "Two spot lights and a lamp of short range on a stage", &demo_spots, 320, 240},
    {"open-sky", "The stage in the open: sun, sky and ground", &demo_open_sky, 320, 240},
    {"lanterns", "Lanterns that emit light, which falls off with distance", &demo_lanterns, 320, 240},
    {"panels", "A window and a tube: sources with an extent", &demo_panels, 320, 240},
    {"globe", "The same room under a glowing ball", &demo_globe, 320, 240},
    {"source-directional", "Parallel light", &demo_source_directional, 320, 240},
    {"source-point", "The same things under a lamp", &demo_source_point, 320, 240},
    {"source-four", "Under four lamps that stand for a panel", &demo_source_four, 320, 240},
    {"source-panel", "Under the panel", &demo_source_panel, 320, 240},
    {"eight-lamps", "A hall of eight lamps, of which two reach the knot", &demo_eight_lamps, 320, 240},
    {"chrome", "A teapot of chrome under the open sky", &demo_chrome, 320, 240},
    {"gilded", "A gilded knot and a varnished ball under the open sky", &demo_gilded, 320, 240},
    {"bowls", "Bowls seen from inside and outside: culled, each side alike, two-sided", &demo_bowls, 320, 240},
    {"avenue", "Pillars along a road that ends in the fog", &demo_avenue, 320, 240},
    {"glass", "A glass ball and a block of green glass on tiles", &demo_glass, 320, 240},
    {"pond", "Things that stand in shallow water", &demo_pond, 320, 240},
    {"mesh", "The teapot with the edges of its mesh", &demo_mesh, 320, 240},
    {"tiles", "A tiled floor in strong perspective, and a wooden wall", &demo_tiles, 320, 240},
    {"planet", "A planet, bilinearly filtered", &demo_planet, 240, 240},
    {"shadows-sun", "Shadows of the sun on a floor, and of a knot on itself", &demo_shadows_sun, 320, 240},
    {"shadows-lamps", "Shadows of two lamps in a room", &demo_shadows_lamps, 320, 240},
    {"ambient-ratio", "Ambient to diffuse ratio growing to the right", &demo_ambient_ratio, 320, 80},
    {"specular-grid", "Specular share growing downwards, exponent to the right", &demo_specular_grid, 320, 240},
    {"exponents", "Exponent growing to the right", &demo_exponents, 320, 80},
    {"ambient-only", "A still life in ambient light", &demo_ambient_only, 320, 240},
    {"diffuse-only", "The still life with diffuse reflection alone", &demo_diffuse_only, 320, 240},
    {"full-phong", "The still life with ambient, diffuse and specular reflection", &demo_full_phong, 320, 240},
    {"lights-blue", "A white still life under a blue light", &demo_lights_blue, 320, 240},
    {"lights-blue-red", "The white still life under a blue and a red light", &demo_lights_blue_red, 320, 240},
    {"lights-blue-red-green", "The white still life under a blue, a red and a green light", &demo_lights_blue_red_green,
     320, 240},
    {"three-lights", "A white teapot under three coloured lights", &demo_three_lights, 320, 240},
    {"many-lights", "The diffuse sum of eight dim lights", &demo_many_lights, 320, 240},
};

const uint16_t demo_scene_count = sizeof demo_scenes / sizeof demo_scenes[0];

/* For firmware without a C library. */
static int same(const char *a, const char *b)
{
    while (*a != '\0' && *a == *b) {
        a++;
        b++;
    }
    return *a == *b;
}

const demo_scene *demo_scene_named(const char *name)
{
    for (uint16_t i = 0; name != NULL && i < demo_scene_count; i++) {
        if (same(name, demo_scenes[i].name)) {
            return &demo_scenes[i];
        }
    }
    return NULL;
}
