/* Made by: make golden */
/* SPDX-License-Identifier: MIT */
/* clang-format off */
/* FNV-1a, 64 bits, of each built-in scene at its own size in RGB888: exact, Gouraud, flat shading. */
#ifndef GLINT_TESTS_IMAGE_GOLDEN_HASHES_H
#define GLINT_TESTS_IMAGE_GOLDEN_HASHES_H

#include <stdint.h>

static const struct {
    const char *scene;
    uint64_t hash[3];
} golden_hashes[] = {
    {"sphere-10x6", {0x2928cd33bedfe21c, 0xf3752c7ebec0ea04, 0x8fb24296d5fe456b}},
    {"sphere-32x16", {0x94eb35316930a012, 0xec62c965ccc13c5a, 0xd00d4e50dfbd88ef}},
    {"sphere-64x32", {0xd23024c00109a5bd, 0x0d2662d3d74166a0, 0x5cc618f978979a20}},
    {"blinn", {0x87bfa8195f0d51f1, 0x170410583e698410, 0x1abeea0b20d59f1b}},
    {"teapot", {0x5de2747f8dcebbff, 0x3e7f180602e9e863, 0x0e2e65c2e9a48abb}},
    {"torus-knot", {0x10ae2809b774999d, 0x538afe4135cdb5d5, 0x119171c47599a754}},
    {"room", {0x00c3c17a6f870320, 0xaf47594f768779b2, 0x420e7bd4181b8ecf}},
    {"point-light", {0xf550b5d9c881c38b, 0x2f0f1445ef9c2a49, 0x923ac2bdb1a95c70}},
    {"ambient-ratio", {0xe8f2c1e3201e1f00, 0x9e320d4746a48175, 0x78a3d09c9c547539}},
    {"specular-grid", {0xb9bda56b043b14ca, 0x0ff0001d885061be, 0xf6db5a80d78bc974}},
    {"ambient-only", {0xa8cddc40d6885ae4, 0xa8cddc40d6885ae4, 0xa8cddc40d6885ae4}},
    {"diffuse-only", {0x6cb6bba0edcb5642, 0x968491346b764850, 0xd1908d934b9a104e}},
    {"full-phong", {0x810c962544f30563, 0xe54680b77934bd60, 0x951c9c6fad0e3e66}},
    {"lights-blue", {0x4ae516cc5ca87a02, 0x1d9f8fd06b16b123, 0xdfdfb9ba87ddaf68}},
    {"lights-blue-red", {0x449a89065b12c4b0, 0xb828fd685cbd03fd, 0xc575cbf871548fe7}},
    {"lights-blue-red-green", {0x654dbdac3050e5b3, 0x9122727134d729d9, 0x29d1c3bba32b853c}},
    {"three-lights", {0x6307aeb66acb73f7, 0x0d364cdea6ea1f7b, 0x91090ffefaa4fa7a}},
    {"many-lights", {0xd4dc6905685ad513, 0x0f33b05837e51d79, 0xa9fadf07cf452c48}},
};

#define GOLDEN_COUNT (sizeof golden_hashes / sizeof *golden_hashes)

#endif
