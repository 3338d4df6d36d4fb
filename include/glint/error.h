/* SPDX-License-Identifier: MIT */
/*
 * Error codes. Every function that can fail returns 0 (GLINT_OK) or one of these negative values. A positive or
 * negative value that a caller's flush function returns is passed through unchanged.
 */
#ifndef GLINT_ERROR_H
#define GLINT_ERROR_H

#ifdef __cplusplus
extern "C" {
#endif

typedef enum glint_error {
    GLINT_OK = 0,

    /* a pointer that has to be there is NULL */
    GLINT_ERROR_NULL_ARGUMENT = -1, /* scene, display, quality or memory */
    GLINT_ERROR_NULL_CAMERA = -2,
    GLINT_ERROR_NULL_OBJECTS = -3, /* object_count > 0, objects NULL */
    GLINT_ERROR_NULL_LIGHTS = -4,  /* light_count > 0, lights NULL */
    GLINT_ERROR_NULL_MESH = -5,    /* an object without mesh, or a mesh without one of its arrays */
    GLINT_ERROR_NULL_MATERIAL = -6,
    GLINT_ERROR_NULL_FLUSH = -7,

    /* mesh */
    GLINT_ERROR_MESH_EMPTY = -10,    /* fewer than 3 vertices, or no triangle */
    GLINT_ERROR_MESH_INDEX = -11,    /* a triangle names a vertex that is not there */
    GLINT_ERROR_MESH_FRACTION = -12, /* fraction_bits out of range */

    /* object */
    GLINT_ERROR_PLACE_SINGULAR = -20, /* the linear part flattens the object: determinant 0 or nearly so */
    GLINT_ERROR_PLACE_RANGE = -21,    /* an entry of the linear part or of the origin out of range */

    /* material */
    GLINT_ERROR_REFLECTANCE = -30, /* below 0 or above 1 */
    GLINT_ERROR_EXPONENT = -31,    /* above GLINT_MAX_EXPONENT */
    GLINT_ERROR_SPECULAR_MODEL = -32,
    GLINT_ERROR_EMISSION = -33,     /* below 0 or above 1 */
    GLINT_ERROR_SIDES = -34,        /* unknown choice of sides */
    GLINT_ERROR_SHADOWS = -35,      /* unknown bits of glint_material.shadows */
    GLINT_ERROR_TRANSMISSION = -37, /* above 1 */
    GLINT_ERROR_GRAZING = -38,      /* below 0 or above 1 */
    GLINT_ERROR_WIRE = -39,         /* wider than GLINT_MAX_WIRE_Q4, or of a colour below 0 or above 1 */

    /* lights */
    GLINT_ERROR_LIGHT_KIND = -40,
    GLINT_ERROR_LIGHT_DIRECTION = -41, /* zero vector */
    GLINT_ERROR_LIGHT_COLOUR = -42,    /* negative */
    GLINT_ERROR_LIGHT_POSITION = -43,  /* out of range */
    GLINT_ERROR_AMBIENT = -44,         /* the scene's ambient, sky or ground light negative */
    GLINT_ERROR_BACKGROUND = -45,      /* background colour below 0 or above 1 */
    GLINT_ERROR_LIGHT_COUNT = -46,     /* more than GLINT_MAX_LIGHTS, samples of extended sources counted each */
    GLINT_ERROR_LIGHT_DISTANCE = -47,  /* a distance of the attenuation out of range */
    GLINT_ERROR_LIGHT_CONE = -48,      /* a spot light's cones: inner not below outer, less than a degree apart, wider
                                        * than a right angle */
    GLINT_ERROR_FOG = -49,             /* fog that ends before it begins, out of range, or of a colour that is */

    /* camera */
    GLINT_ERROR_CAMERA_DIRECTION = -50, /* eye equals target */
    GLINT_ERROR_CAMERA_UP = -51,        /* up lies within 0.1 degrees of the view direction */
    GLINT_ERROR_CAMERA_FIELD = -52,     /* field of view outside 1..170 degrees */
    GLINT_ERROR_CAMERA_NEAR = -53,      /* near plane not in front of the eye, or out of range */
    GLINT_ERROR_CAMERA_RANGE = -54,     /* eye or target out of range */

    /* display and quality */
    GLINT_ERROR_DISPLAY_SIZE = -60,    /* width or height 0 or above GLINT_MAX_SIZE_PX */
    GLINT_ERROR_DISPLAY_BAND = -61,    /* GLINT_MONO_PAGES wants bands of whole pages of 8 rows */
    GLINT_ERROR_DISPLAY_FORMAT = -62,  /* unknown pixel format */
    GLINT_ERROR_DISPLAY_DITHER = -63,  /* unknown dither */
    GLINT_ERROR_DISPLAY_BUFFERS = -64, /* more than 2 buffers, or 2 without `transfers` */
    GLINT_ERROR_DISPLAY_STRIDE = -65,  /* stride_bytes shorter than a row, or odd with 16-bit pixels */
    GLINT_ERROR_DISPLAY_AREA = -69,    /* rows that are not on the display, or not whole pages of GLINT_MONO_PAGES */
    GLINT_ERROR_SHADING = -66,         /* unknown shading */
    GLINT_ERROR_PART = -68,            /* the variant of the backend has no specular term, report ... (fixed.h) */
    GLINT_ERROR_TOLERANCE = -67,       /* below GLINT_LEAST_TOLERANCE, or together with a shading */

    /* extended sources */
    GLINT_ERROR_LIGHT_EXTENT = -90,  /* a radius below 0, or a panel or ball that reaches out of range */
    GLINT_ERROR_LIGHT_SAMPLES = -91, /* more samples than GLINT_MAX_SAMPLES */
    GLINT_ERROR_LIGHT_SHADOWS = -95, /* a panel or ball that is to cast shadows: they cannot */

    /* mirrors */
    GLINT_ERROR_MIRROR = -92,           /* a mirror's reflectance below 0 or above 1 */
    GLINT_ERROR_NULL_ENVIRONMENT = -93, /* a mirror without an environment, or an environment without texels */
    GLINT_ERROR_ENVIRONMENT_SIDE = -94, /* not 8, 16, 32, 64 or 128 */

    /* texture of a material */
    GLINT_ERROR_TEXTURE_SIZE = -100, /* width or height 0 or above GLINT_MAX_TEXTURE_PX, or more than memory can hold */
    GLINT_ERROR_TEXTURE_TEXELS = -101,    /* NULL */
    GLINT_ERROR_TEXTURE_PALETTE = -102,   /* NULL, without a colour, or with more than GLINT_MAX_PALETTE */
    GLINT_ERROR_TEXTURE_FORMAT = -103,    /* unknown */
    GLINT_ERROR_TEXTURE_FILTER = -104,    /* unknown */
    GLINT_ERROR_TEXTURE_WRAP = -105,      /* unknown */
    GLINT_ERROR_TEXTURE_TEXCOORDS = -106, /* the mesh has no texcoords */
    GLINT_ERROR_TEXCOORD_BITS = -107,     /* the mesh's texcoord_bits out of range */

    /* memory */
    GLINT_ERROR_MEMORY_SIZE = -70,     /* less than glint_*_memory_least_bytes() */
    GLINT_ERROR_MEMORY_ALIGNMENT = -71 /* not aligned like a uint32_t */
} glint_error;

/* A sentence in English for an error code, never NULL; "unknown error" for any other number. The sentences take 2 KB of
 * flash where this is called; on the AVR, whose constant strings live in RAM, 2 KB of RAM. */
const char *glint_error_text(int error);

#ifdef __cplusplus
}
#endif

#endif
