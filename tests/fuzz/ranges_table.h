/* SPDX-License-Identifier: MIT */
/*
 * The documented range of each quantity that the fixed backend traces, both ends allowed, and the type that it is kept
 * in. `where` is the file under src/ whose comment says so (or which the stated argument is about), or docs/formats.md.
 */
#ifndef GLINT_TESTS_FUZZ_RANGES_TABLE_H
#define GLINT_TESTS_FUZZ_RANGES_TABLE_H

#include <stddef.h>
#include <stdint.h>

typedef struct documented_range {
    const char *quantity;
    int8_t bits; /* of its type; below 0: a signed type; BITS: the quantity is itself a number of bits */
    int64_t least, greatest;
    const char *where;
} documented_range;

enum { S16 = -16, S32 = -32, S64 = -64, U16 = 16, U32 = 32, U64 = 64, BITS = 0 };

#define TWO(n) ((int64_t)1 << (n))
#define WITHIN(most) -(most), (most)
#define BELOW(end) 1 - (end), (end)-1 /* in magnitude */

static const documented_range documented[] = {
    /* number/ */
    {"16-bit factor", S32, WITHIN(TWO(15)), "number/integer.h"},
    {"shifted left, bits", BITS, 0, 63, "number/integer.h: the caller sees to it"},
    {"shifted right", S64, BELOW(TWO(62)), "number/integer.h"},
    {"reciprocal residual q30", S32, BELOW(TWO(23)), "number/fixed.c"},
    {"reciprocal residual q31", S32, BELOW(TWO(17)), "number/fixed.c"},
    {"reciprocal q31", U32, TWO(30), TWO(31) - 1, "number/fixed.h"},
    {"power t q26", U32, 0, 31 * TWO(26), "number/fixed.c"},
    {"power a t q14", U32, 0, TWO(31) - 1, "number/fixed.c"},
    {"sine q30", S32, 0, TWO(30) + 6, "formats.md"},
    {"cosine q30", S32, 0, TWO(30) + 6, "formats.md"},
    {"unit q30 sum of squares", U64, TWO(58), TWO(62) - 1, "number/fixed.c"},
    {"unit vector q30", S32, WITHIN(TWO(30) + 6), "formats.md"},
    {"scaled mantissa", S32, TWO(30), TWO(31) - 1, "number/fixed.h"},
    {"scaled exponent", S16, INT16_MIN, INT16_MAX, "its type"},
    /* geometry/ */
    {"place sum", S64, WITHIN(3 * TWO(60)), "geometry/place.c: three products of 2^62, over 4"},
    {"offset from the eye q16", S64, WITHIN(TWO(31)), "geometry/view.c"},
    {"model to view q46", S64, WITHIN(TWO(57) - 1), "geometry/view.c: 2^56 sqrt(3)"},
    {"turned offset q46", S64, BELOW(TWO(62)), "geometry/view.c"},
    {"set-up vector", S32, WITHIN(TWO(30) + TWO(17)), "geometry/view.c: rows and axes of frames"},
    {"row entry", S32, WITHIN(TWO(30)), "geometry/view.h"},
    {"row origin", S32, WITHIN(TWO(30)), "geometry/view.h"},
    {"view fraction", S16, INT16_MIN, INT16_MAX, "its type"},
    {"gram q32", S64, WITHIN(3 * TWO(52)), "geometry/view.c"},
    {"cofactor q32", S64, WITHIN(2 * TWO(52)), "geometry/view.c"},
    {"determinant", S64, BELOW(TWO(61)), "geometry/view.c"},
    {"from world q30", S32, WITHIN(TWO(30) + TWO(17)), "geometry/view.c: angles within 2^-13"},
    {"frame to view q30", S32, WITHIN(TWO(30) + TWO(17)), "geometry/view.c: the same"},
    {"normal row sum", U32, 0, TWO(30) - 1, "geometry/view.h"},
    {"ray step product", S64, BELOW(TWO(62)), "geometry/view.c"},
    {"ray step", S32, BELOW(TWO(30)), "geometry/view.h"},
    {"ray sideways", S32, BELOW(TWO(30)), "geometry/view.h"},
    {"ray", S32, BELOW(TWO(30)), "geometry/view.h"},
    {"ray through a vertex", S32, BELOW(TWO(30)), "raster/attribute_fixed.h"},
    {"folded steps q29", S32, BELOW(TWO(30)), "lighting/light_fixed.h"},
    {"gap at a lattice point", S32, BELOW(TWO(26) + 1), "lighting/gloss_fixed.h"},
    {"part of a square at a lattice point", S32, BELOW(TWO(30)), "lighting/gloss_fixed.h"},
    {"value at a lattice point", S32, BELOW(TWO(30)), "raster/lattice_fixed.h"},
    {"placement fraction", S16, INT16_MIN, INT16_MAX, "its type"},
    {"light position", S32, BELOW(TWO(30)), "geometry/view.h"},
    {"light position fraction", S16, INT16_MIN, 29, "geometry/view.h"},
    {"view x y", S32, BELOW(TWO(30)), "geometry/vertex_fixed.h"},
    {"view z", S32, BELOW(TWO(30)), "geometry/vertex_fixed.h"},
    {"projection product", S64, BELOW(TWO(61)), "geometry/vertex_fixed.h"},
    {"screen from centre q12", S32, WITHIN(1440 * 4096), "formats.md"},
    {"inverse depth q30", S32, TWO(20), TWO(30) - TWO(20), "formats.md"},
    {"clip ratio q30", S32, 0, TWO(30), "geometry/vertex_fixed.h"},
    {"clip way", S32, BELOW(TWO(31)), "its type"},
    {"face normal product", S64, BELOW(TWO(33)), "geometry/object.inc"},
    {"face normal", S16, WITHIN(TWO(14)), "geometry/object.inc: 14 bits and the carry"},
    {"normal square q28", U32, 0, 3 * TWO(30), "geometry/object.inc"},
    /* raster/ */
    {"triangle number", U16, 0, 65534, "raster/bands.h"},
    {"signed area q16", S64, WITHIN(TWO(40) - 1), "raster/edges.h: 41 bits"},
    {"edge step", S32, BELOW(TWO(20)), "raster/edges.c"},
    {"edge part", S32, BELOW(TWO(21)), "raster/edges.c"},
    {"edge function", S32, BELOW(TWO(31)), "raster/edges.h"},
    {"gradient difference q12", S32, BELOW(TWO(24)), "raster/gradients.c"},
    {"gradient area q24", S64, BELOW(TWO(48)), "raster/gradients.c"},
    {"gradient", S32, WITHIN(TWO(30)), "raster/gradients.c: 2^excess, 30 - excess bits"},
    {"sliver weight q30", S32, 0, TWO(30) + 8, "raster/gradients.h: 2^-27 before clamping"},
    {"sliver way", S32, WITHIN(TWO(30)), "raster/plane.h"},
    {"plane difference", S32, WITHIN(TWO(30)), "raster/plane.c"},
    {"plane step", S32, BELOW(TWO(31)), "its type"},
    {"interpolated depth q30", U32, 1, TWO(30) - 1, "geometry/view.h"},
    {"inverse distance", S32, 0, TWO(30), "lighting/light_fixed.h"},
    {"corner weight q30", S32, 0, TWO(30) - 1, "raster/attribute_fixed.h: 30 bits"},
    {"weighted normal", S32, WITHIN(TWO(29) + TWO(25)), "raster/plane.h: a sixteenth beyond 2^29"},
    {"colour attribute", S32, -TWO(25), TWO(29) + TWO(25), "raster/plane.h: the same"},
    {"placement", S32, BELOW(TWO(30)), "geometry/view.h"},
    /* lighting/, display/ */
    {"light product q15", U32, 0, TWO(16), "formats.md"},
    {"light factor q15", S32, 0, TWO(15) + 7, "lighting/light_fixed.h"},
    {"light sum q16", U32, 0, TWO(30) + TWO(18) - 1, "formats.md"},
    {"light direction q15", S32, WITHIN(TWO(15)), "formats.md"},
    {"unit vector q15", S32, WITHIN(TWO(15) + 1), "formats.md"},
    {"mirrored direction q15", S32, BELOW(TWO(15) + 16), "lighting/light_fixed.h"},
    {"mirror's square", U32, 0, 3 * TWO(28), "lighting/mirror_fixed.h"},
    {"mirror's product", S32, BELOW(6 * TWO(28)), "lighting/mirror_fixed.h"},
    {"mirrored ray", S32, BELOW(TWO(29)), "formats.md"},
    {"environment q15", U32, 0, TWO(15), "formats.md"},
    {"specular gap q31", U32, 0, TWO(31), "formats.md"},
    {"light times inverse", S32, BELOW(TWO(28) + TWO(20)), "lighting/light_fixed.h"},
    {"towards a light", S32, BELOW(TWO(31)), "its type"},
    {"level product", U32, 0, TWO(15) * 256, "display/pack.c"},
    {"luma q15", U32, 0, TWO(15), "display/pack.c"},
    /* attenuation and cones, effects/ */
    {"distance's fraction", S16, INT16_MIN, INT16_MAX, "its type"},
    {"distance along its direction", S32, WITHIN(464943848 + 16384),
     "lighting/reach_fixed.h: sqrt(3) 2^28, the direction's rounding"},
    {"attenuation's divisor", U32, 0, 3 * (TWO(30) - 1), "lighting/reach_fixed.h: three terms below 2^30"},
    {"difference from a cone's axis q28", S32, WITHIN(TWO(29) + 8), "lighting/reach_fixed.h: two unit vectors"},
    {"half a cone's square", U32, 0, 3 * TWO(28) - 1, "lighting/reach_fixed.h"},
    {"reach factor q15", U32, 0, TWO(15), "lighting/reach_fixed.h"},
    {"fog shift", S32, 1, 51, "effects/fog.c"},
    {"fog's steepness q4", U32, 16, TWO(27), "effects/fog.c"},
    {"fog's fraction", S16, 5, 27, "effects/fog.h"},
    {"fog's begin", U32, 0, TWO(28) - 1, "effects/fog.h"},
    {"fog's share", U32, 0, TWO(28), "effects/fog.c: but for rounding"},
    {"mixed colour q15", U16, 0, TWO(15), "effects/fog.h"},
    {"grazing share q15", U32, 0, TWO(15), "effects/through.h"},
    {"layered colour q15", U32, 0, TWO(16), "effects/through.c"},
    {"sphere's nearest distance", S64, BELOW(TWO(48)), "effects/through.c"},
    {"sphere's farthest distance", S64, 0, TWO(48) - 1, "effects/through.c"},
    {"order of layers", S32, BELOW(TWO(30)), "effects/through.c: 10 and 20 bits"},
    {"wire edge", S64, BELOW(TWO(41)), "effects/wire.c"},
    {"wire limit", U32, 0, TWO(28), "effects/wire.h"},
    {"gradient's rest", S64, BELOW(TWO(31)), "effects/texture.c"},
    {"gradient q48", S64, WITHIN(TWO(48)), "effects/texture.c"},
    {"texture plane's difference q16", S64, WITHIN(TWO(46)), "effects/texture.c"},
    {"weighted texture coordinate", S64, WITHIN(TWO(58)), "effects/texture.c"},
    {"texture coordinate q22", S32, WITHIN(TWO(28)), "formats.md"},
    {"position in a texture q22", U32, 0, TWO(32) - 1, "effects/texture.c"},
    {"texture's colour q15", U16, 0, TWO(15), "formats.md"},
    {"light before a texture q16", U32, 0, TWO(31) - 1, "effects/texture_fixed.h"},
    {"shadow position", S32, BELOW(TWO(29)), "effects/shadow.h"},
    {"shadow sheared", S32, BELOW(TWO(30)), "effects/shadow.h"},
    {"shadow vector", S32, WITHIN(TWO(29)), "effects/shadow_plane.h"},
    {"shadow height", S64, BELOW(TWO(62)), "effects/shadow_plane.h"},
    {"shadow line", S32, BELOW(TWO(30)), "effects/shadow_mask.h"},
};

enum { DOCUMENTED = sizeof documented / sizeof *documented };

#endif
