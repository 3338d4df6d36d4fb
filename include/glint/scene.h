/* SPDX-License-Identifier: MIT */
/*
 * The scene: camera, objects, materials and lights as plain data in fixed formats. The fixed-point backend, the float
 * backend and the double-precision reference of the tests read these same bits.
 *
 * World space is right-handed, in world units (any length you like). A zeroed field means its stated default.
 *
 * Reflectance model, for each colour channel, at a surface point with unit normal n, unit direction c to the camera,
 * and for each light j of intensity I_j in unit direction s_j, r_j = 2 (n.s_j) n - s_j:
 *
 *     L = r_a I_a + sum_j I_j [ r_d max(0, n.s_j) + r_s max(0, r_j.c)^alpha ]     specular only where n.s_j > 0
 *
 * B. T. Phong, "Illumination for computer generated pictures", CACM 18(6), 1975; in the form of the lecture slides by
 * L. Sigal, CSCD18, 2008. A larger alpha makes the highlight narrower. With GLINT_BLINN, max(0, n.h_j)^alpha stands
 * in the place of max(0, r_j.c)^alpha, h_j the unit vector along s_j + c (J. F. Blinn, SIGGRAPH 1977); where s_j = -c
 * there is no h and no specular term. A point light that stands on the surface point (nearer to it than 2^-15 of the
 * point's distance from the eye) has no direction there and adds neither term. 0^0 is 1: with alpha = 0 the specular
 * term is 1 wherever n.s_j > 0. L is clamped to 0..1 once, after the sum. A displayed code is round(255 L): the model
 * works on display codes, with no gamma conversion.
 *
 * A scene may call for more than that; what it leaves at zero is not there and costs nothing:
 *
 *     L = e + r_a I_a(n) + r_m E(r) + sum_j I_j a_j(d_j) b_j(s_j) [ ... ]      emission, hemisphere, mirror, lights
 *     displayed: (1 - f) L + f F                                               fog
 *
 * and of a surface that lets light through, by glint_material.transmission t and .grazing G:
 *
 *     L = (1 - t) (e + r_a I_a + diffuse terms) + mirror and specular terms, clamped,    phi = (1 - |n.c|)^5, 0 where G
 * is black, t' = t (1 - phi), displayed: min(1, (1 - f) (L + t phi G) + f (1 - t') F + t' behind)      transmission
 *
 * e          emission of the surface, glint_material.emission
 * I_a(n)     ambient light: scene.ambient everywhere, and scene.sky and scene.ground by the normal,
 *            I_a + sky (1 + n.u) / 2 + ground (1 - n.u) / 2, u the world's up: secondary light from a bright sky
 *            above and a ground below, each a hemisphere of one brightness, as a convex surface sees them
 *            (the isotropic sky of B. Y. H. Liu and R. C. Jordan, Solar Energy 7(2), 1963)
 * r_m E(r)   a mirror: the environment's colour in the direction r = 2 (n.c) n - c in which the ray from the eye leaves
 *            the surface, see glint_environment
 * a_j(d)     attenuation with the distance d from a point or spot light, see glint_light
 * b_j(s)     the cone of a spot light, see glint_light
 * f          fog by the depth Z along the view direction, see glint_fog
 * behind     what is displayed there without the surface: its own fog is in it, so f takes no part of it
 *
 * What shines through takes the place of the light that the body of the surface scatters, not of the light that its
 * face mirrors: glass loses its colour with t, but not its highlights. At a grazing angle it mirrors all of the light,
 * by Schlick's approximation of Fresnel's equations with nothing mirrored straight on (C. Schlick, "An inexpensive BRDF
 * model for physically-based rendering", Computer Graphics Forum 13(3), 1994); G stands for the surroundings seen
 * there. In Gouraud and flat shading n is the face's there; c is that of the pixel in every shading.
 *
 * Surfaces that let light through are drawn after the others, from far to near by objects: by |C - eye|^2 - R^2, where
 * the sphere about C of radius R holds the object. Of an object whose both sides are drawn, the insides come before the
 * outsides. So the order is right for objects that such spheres keep apart, each convex and closed; or convex
 * everywhere and seen on one side. Where surfaces of one object, or objects that reach into each other, cover each
 * other the other way, they are mixed in the order of the objects and triangles. They do not hide each other.
 *
 * Where a material has a wire, L is its colour at each pixel of a triangle whose centre is nearer than half the width
 * to the line through one of the triangle's edges on the screen, and nothing passes there (t' = 0). It is not lit; fog
 * does apply. Each triangle draws its half of a line, so the outline of an object has half the width.
 *
 * r_a and r_d may vary over the surface by a texture, see <glint/texture.h>.
 */
#ifndef GLINT_SCENE_H
#define GLINT_SCENE_H

#include <stdbool.h>
#include <stdint.h>

#include <glint/config.h>
#include <glint/mesh.h>
#include <glint/texture.h>

#ifdef __cplusplus
extern "C" {
#endif

/* A colour, reflectance or intensity for each channel in Q14: 16384 is exactly 1. */
typedef struct glint_colour {
    int16_t r_q14, g_q14, b_q14;
} glint_colour;

/* Initialisers of a glint_colour. Arguments are 8-bit codes 0..255; 255 is exactly 1. */
#define GLINT_Q14_FROM_CODE(code) ((int16_t)(((int32_t)(code)*16384 + 127) / 255))
#define GLINT_RGB(r, g, b)                                                                                             \
    {                                                                                                                  \
        GLINT_Q14_FROM_CODE(r), GLINT_Q14_FROM_CODE(g), GLINT_Q14_FROM_CODE(b)                                         \
    }
#define GLINT_GREY(code) GLINT_RGB(code, code, code)
#define GLINT_BLACK GLINT_RGB(0, 0, 0)
#define GLINT_WHITE GLINT_RGB(255, 255, 255)

/* Which cosine the specular term takes to the power alpha. */
enum {
    GLINT_PHONG = 0, /* r.c */
    GLINT_BLINN = 1  /* n.h */
};

/* Which sides of a triangle are drawn. */
enum {
    GLINT_FRONT_SIDE = 0, /* the outside: triangles that turn away are culled */
    GLINT_EACH_SIDE = 1,  /* both, lit by the stored normals: an inside is lit as the outside is */
    GLINT_TWO_SIDED = 2   /* both; where the inside is seen, the normal is taken the other way round */
};

/* What a surface has to do with shadows: bits of glint_material.shadows. */
enum {
    GLINT_CASTS_NO_SHADOW = 1, /* light passes through it unhindered */
    GLINT_TAKES_NO_SHADOW = 2  /* it is lit as if nothing stood between it and the light */
};

/* 256 px */
#define GLINT_MAX_WIRE_Q4 4096

/* What a surface does with light. Reflectances are 0..1 (16384) in each channel. */
typedef struct glint_material {
    glint_colour ambient;         /* r_a */
    glint_colour diffuse;         /* r_d */
    glint_colour specular;        /* r_s */
    uint16_t exponent_q4;         /* alpha in sixteenths: 0..GLINT_MAX_EXPONENT * 16; 32 is written 32 * 16 */
    uint8_t specular_model;       /* GLINT_PHONG (default) or GLINT_BLINN */
    uint8_t sides;                /* GLINT_FRONT_SIDE (default) ... */
    uint8_t shadows;              /* GLINT_CASTS_NO_SHADOW + GLINT_TAKES_NO_SHADOW; 0: casts and takes them */
    glint_colour emission;        /* e: light that the surface sends out whatever falls on it, 0..1 */
    glint_colour mirror;          /* r_m: what part of the environment it mirrors; asks for scene.environment */
    uint16_t transmission_q14;    /* t: how much of the light behind shows through, 0 (opaque)..1 (16384) */
    glint_colour grazing;         /* G: what it mirrors instead at grazing angles, 0..1; black: nothing, t' = t */
    glint_colour wire;            /* colour of the mesh's edges, see above; 0..1 */
    uint16_t wire_width_q4;       /* how wide they are, 1/16 px: 0 (none)..GLINT_MAX_WIRE_Q4 */
    const glint_texture *texture; /* T, by which r_a and r_d are multiplied, see <glint/texture.h>; NULL: none */
} glint_material;

/*
 * Where an object stands: world = linear * model + origin.
 *
 * linear_q16 is row-major, Q16: linear_q16[i][k] multiplies model coordinate k into world coordinate i. Any invertible
 * matrix will do: rotation, uniform or non-uniform scale, shear, mirror. All nine entries zero mean the identity.
 * Normals are transformed by the inverse transpose and renormalised. A mirroring matrix (determinant < 0) keeps the
 * outside of the mesh outside.
 * Range: |linear_q16| <= 2^26 (1024), |origin_q16| <= 2^30 (16384 world units). The matrix counts as singular when
 * |det| < 2^-24 m^3, m its greatest absolute entry.
 *
 * The functions below make and combine places; see place functions in <glint/place.h>.
 */
typedef struct glint_place {
    int32_t linear_q16[3][3];
    int32_t origin_q16[3];
} glint_place;

typedef struct glint_object {
    const glint_mesh *mesh;
    const glint_material *material;
    glint_place place; /* zero: the model as it is, at the world's origin */
} glint_object;

enum {
    GLINT_DIRECTIONAL = 0, /* parallel light, travelling along `direction` */
    GLINT_POINT = 1,       /* light from `position_q16` in all directions */
    GLINT_SPOT = 2,        /* light from `position_q16` within a cone about `direction` */
    GLINT_PANEL = 3,       /* light from a parallelogram about `position_q16` */
    GLINT_BALL = 4         /* light from the surface of a sphere about `position_q16` */
};

/*
 * Attenuation of a point or spot light at the distance d, with t = d / unit:
 *
 *     a(d) = min(1, 1 / (k0 + k1 t + k2 t^2)) w(d),      w(d) = max(0, 1 - (d / range)^4)
 *
 * The quotient is that of the fixed-function pipelines (OpenGL 1.1, section 2.13.1; OBJ and COLLADA files mean it),
 * here never above 1, so that a surface near the light is lit as brightly as `colour` says and no brighter. w(d) lets
 * the light end at `range` (glTF's KHR_lights_punctual recommends this window); beyond it the light is not even looked
 * at. All of k0, k1, k2 zero means no quotient (1), range zero no window (1).
 */
typedef struct glint_attenuation {
    uint16_t k_q14[3];  /* k0, k1, k2 in Q14: 0..3.99994 */
    uint32_t unit_q16;  /* the distance that t counts in, Q16 world units; 0: one world unit */
    uint32_t range_q16; /* Q16 world units; 0: none */
} glint_attenuation;

/* unit_q16 and range_q16: 0, or 2^-8..2^14 world units. */
#define GLINT_LEAST_DISTANCE_Q16 256
#define GLINT_MAX_DISTANCE_Q16 ((uint32_t)1 << 30)

/* The cones of a spot light: at most a right angle from the axis, at least a degree apart. */
#define GLINT_WIDEST_CONE_TURN16 16384
#define GLINT_LEAST_CONE_TURN16 182

/*
 * The cone of a spot light: with x the angle between `direction` and the way from the light to the surface,
 *
 *     b = 1 for x <= inner,  0 for x >= outer,  ((cos x - cos outer) / (cos inner - cos outer))^2 between
 *
 * (as in glTF's KHR_lights_punctual).
 *
 * Extended sources, a panel and a ball, stand for many point lights: their light is the mean of that of point lights
 * spread evenly, by area, over
 *
 *     P(a, b) = position + a edge[0] + b edge[1],  -1 <= a, b <= 1        a panel, seen from both sides alike
 *     P(w) = position + radius w,  |w| = 1                                a ball, of which all is seen from anywhere
 *
 * each with the whole model: its own s, its own clamp at n.s = 0, its own attenuation (the lecture slides' "many light
 * sources to approximate an extended light source"). The renderer takes as few of them as make no visible difference,
 * see glint_plan_source() in <glint/plan.h>, at most `samples`. Edges or a radius of zero leave a segment or a point.
 *
 * Shadows. A light with `casts_shadows` adds neither diffuse nor specular light at a point from which a triangle hides
 * it: one that the straight line from the point to the light (of a directional light: the ray towards it) meets. What
 * counts is the triangle, not the side that it turns, and not the vertices' normals; it need not be seen, nor lie in
 * front of the camera. A surface that lets light through hides it like any other, whatever its transmission. These do
 * not hide the light:
 *
 *  - the triangle itself to which the point belongs, and what lies in its plane or touches it from behind;
 *  - triangles of a material with GLINT_CASTS_NO_SHADOW;
 *  - of the point's own object, if its material has the side GLINT_FRONT_SIDE: triangles that turn their outside to the
 *    light. A point outside of a closed surface is in shadow all the same, since the line leaves the surface by a
 *    triangle that turns its inside to the light; but a rounded surface, whose normals are lit a little beyond the edge
 *    where its triangles turn away, does not get that edge as a jagged shadow.
 *
 * Shadows are hard: a point sees the light or does not. They are drawn in exact shading and within a tolerance; flat
 * and Gouraud shading, which light corners and not points, leave them out. Directional, point and spot lights cast
 * them; a panel or a ball that is to is refused (GLINT_ERROR_LIGHT_SHADOWS): its shadows would be soft.
 */
typedef struct glint_light {
    uint8_t kind;
    uint8_t samples;         /* panel, ball: the greatest number of point lights that may stand for it, 1..64; 0: 16 */
    bool casts_shadows;      /* see above; false: it shines through everything */
    int16_t direction[3];    /* directional, spot: the way the light travels (s = -direction); any length but 0 */
    glint_colour colour;     /* intensity in Q14: 0..1.99994, diffuse and specular alike */
    int32_t position_q16[3]; /* all others: world position, Q16; |position_q16| <= 2^30 */
    glint_attenuation attenuation; /* all but directional; zero: none */
    /* spot: half the angle of the cones, 1/65536 turn: 0 <= inner < outer <= 16384 (90 degrees), and the two at least
     * 182 (1 degree) apart */
    uint16_t inner_turn16, outer_turn16;
    int32_t edge_q16[2][3]; /* panel: half of each edge as a vector, Q16 world units; position and both together within
                             * 2^30 in each coordinate */
    int32_t radius_q16;     /* ball: not negative; position and radius within 2^30 in each coordinate */
} glint_light;

#define GLINT_MAX_SAMPLES 64

/*
 * Fog: f = clamp((Z - begin) / (end - begin)) of the colour F is mixed in at the depth Z, the distance along the view
 * direction. The linear fog of OpenGL 1.1. The background is left as it is.
 */
typedef struct glint_fog {
    glint_colour colour; /* F, 0..1 */
    int32_t begin_q16;   /* world units, Q16: 0..2^30 */
    int32_t end_q16;     /* above begin_q16 by 2^-8 at least, up to 2^30; both 0: no fog */
} glint_fog;

/*
 * A perspective camera. View space: x right, y down, z along the view direction, in world units.
 * A point at view (X, Y, Z) is seen at pixel coordinates
 *     x = width / 2 + f X / Z,   y = height / 2 + f Y / Z,   f = (height / 2) / tan(field_of_view / 2)
 * where pixel (i, j) covers [i, i+1) x [j, j+1), j counted downwards, and is sampled at its centre (i + 1/2, j + 1/2).
 * Right is view direction x up, down completes the frame.
 */
typedef struct glint_camera {
    int32_t eye_q16[3];            /* world position, Q16; |.| <= 2^30 */
    int32_t target_q16[3];         /* a point that the camera looks at, not the eye; |.| <= 2^30 */
    int16_t up[3];                 /* a direction that is up on the display, any length, at least 0.1 degrees off
                                    * the view direction; zero: (0, 1, 0) */
    uint16_t field_of_view_turn16; /* vertical, in 1/65536 turn: 45 degrees is 8192; 182 (1 degree)..30947 (170) */
    int32_t near_q16;              /* distance of the near plane along the view direction, Q16: 64 (1/1024)..2^30.
                                    * Depth is stored as near / Z in 16 bits, so put it as far out as the scene allows. */
} glint_camera;

/*
 * What a mirror shows: the colours of all directions, from infinitely far away (J. F. Blinn and M. E. Newell, "Texture
 * and reflection in computer generated images", CACM 19(10), 1976). Objects of the scene are not seen in it.
 *
 * The map is octahedral (of the family that Z. Cigolle et al. survey, "A survey of efficient representations for
 * independent unit vectors", JCGT 3(2), 2014): a direction (x, y, z) in the world, divided by |x| + |y| + |z|, is seen
 * from above in the middle of the square -1..1 as (u, v) = (x, z), and if y < 0 folded out into the square's corners as
 * (u, v) = ((1 - |z|) sign x, (1 - |x|) sign z). Texel (i, j) of row j has its centre at u = (2 i + 1) / side - 1 and
 * v = (2 j + 1) / side - 1; E is bilinear between centres. Beyond the square's edge lies the texel next to the edge
 * that the fold brings there: of column -1 the texel of column 0 with j turned round, and so for the other edges; so E
 * is continuous all over the sphere.
 *
 * Texels are RGB565: red in bits 15..11 over 31, green in 10..5 over 63, blue in 4..0 over 31.
 */
typedef struct glint_environment {
    const uint16_t *texels; /* side * side, rows of j from 0; on the AVR declare them GLINT_FLASH */
    uint8_t side;           /* 8, 16, 32, 64 or 128 */
    uint8_t steepest;       /* the greatest difference of neighbouring texels, over the edges too, in any channel, in
                             * 1/255, rounded up; 0: 255. What is promised of a mirror's error is by this. */
} glint_environment;

typedef struct glint_scene {
    const glint_camera *camera;
    const glint_object *objects; /* drawn in this order; where two surfaces have equal depth the first stays */
    const glint_light *lights;
    uint16_t object_count;
    uint16_t light_count;
    glint_colour ambient;     /* I_a, Q14, 0..1.99994 */
    glint_colour background;  /* where no object is, Q14, 0..1 */
    glint_colour sky, ground; /* ambient light from above and from below, Q14, 0..1.99994 */
    int16_t up[3];            /* u, which way is above, any length; zero: (0, 1, 0) */
    glint_fog fog;
    const glint_environment *environment; /* what mirrors show; NULL where no material is one */
} glint_scene;

#ifdef __cplusplus
}
#endif

#endif
