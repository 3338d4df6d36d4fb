/* Made by: make golden */
/* SPDX-License-Identifier: MIT */
/* clang-format off */
/* FNV-1a, 64 bits, of each built-in scene at its own size in RGB888: exact, Gouraud, flat;
 * tolerance 1 and 4; q2. */
#ifndef GLINT_TESTS_IMAGE_GOLDEN_HASHES_H
#define GLINT_TESTS_IMAGE_GOLDEN_HASHES_H

#include <stdint.h>

static const struct {
    const char *scene;
    uint64_t hash[6];
} golden_hashes[] = {
    {"sphere-10x6", {0xa9d7451990f60771, 0xf3752c7ebec0ea04, 0x8fb24296d5fe456b, 0xf7a37c1d6e6eb6c9, 0x560beec2c1b975ff, 0x844ab2d8601e5f87}},
    {"sphere-32x16", {0x94eb35316930a012, 0xec62c965ccc13c5a, 0xd00d4e50dfbd88ef, 0x24547ed2d465b089, 0x2fe8e48e4bf0a138, 0x0d12f9dfa771d777}},
    {"sphere-64x32", {0xd23024c00109a5bd, 0x0d2662d3d74166a0, 0x5cc618f978979a20, 0x180d3db249587b1e, 0xd77cf9c65557e163, 0x355af630e3814959}},
    {"blinn", {0x87bfa8195f0d51f1, 0x4a16eba70cd2b32f, 0x1abeea0b20d59f1b, 0x13092b7b86c0c4d5, 0xd774f2842b82797e, 0x6bdd3089a6979162}},
    {"teapot", {0x5de2747f8dcebbff, 0x3e7f180602e9e863, 0x0e2e65c2e9a48abb, 0xf9a489cee9d74d21, 0x3dbf90b9ce531f04, 0x128ae9101e3fd208}},
    {"torus-knot", {0x10ae2809b774999d, 0x538afe4135cdb5d5, 0x119171c47599a754, 0xcb4e0784fc8fc8fb, 0x0db31de036fe1b63, 0xabc97c918cf6fa7c}},
    {"room", {0x00c3c17a6f870320, 0xaf47594f768779b2, 0x420e7bd4181b8ecf, 0x00c3c17a6f870320, 0x00c3c17a6f870320, 0x00c3c17a6f870320}},
    {"point-light", {0xf550b5d9c881c38b, 0x2f0f1445ef9c2a49, 0x923ac2bdb1a95c70, 0xf550b5d9c881c38b, 0xf550b5d9c881c38b, 0xf550b5d9c881c38b}},
    {"ambient-ratio", {0xbac51f909dea2057, 0x2d2a0838cfe173be, 0x78a3d09c9c547539, 0x81b353a618216f82, 0x17933cd8985694cd, 0xc2e4980b058ac9c4}},
    {"specular-grid", {0xb9bda56b043b14ca, 0x0ff0001d885061be, 0xf6db5a80d78bc974, 0xdf16ff01a5d43b59, 0xe7b520aca5819af8, 0xbad55e3546549ba1}},
    {"ambient-only", {0xa8cddc40d6885ae4, 0xa8cddc40d6885ae4, 0xa8cddc40d6885ae4, 0xa8cddc40d6885ae4, 0xa8cddc40d6885ae4, 0xa8cddc40d6885ae4}},
    {"diffuse-only", {0x6cb6bba0edcb5642, 0x968491346b764850, 0xd1908d934b9a104e, 0xeaad76084383fc28, 0x99362e0f79a788fb, 0x647be7660a4f4b53}},
    {"full-phong", {0x810c962544f30563, 0xe54680b77934bd60, 0x951c9c6fad0e3e66, 0x79e946c388eaed24, 0xeff5898125752f68, 0x6ced0ad0720f69a4}},
    {"lights-blue", {0x4ae516cc5ca87a02, 0x1d9f8fd06b16b123, 0xdfdfb9ba87ddaf68, 0x9b41c5a4e636277b, 0x9f3cfa8d5d6abb95, 0x6887098da38871fd}},
    {"lights-blue-red", {0x449a89065b12c4b0, 0xb828fd685cbd03fd, 0xc575cbf871548fe7, 0xa56efb5bf0cef9ef, 0x299b32d33caf0068, 0x1eaeadf447ad6d31}},
    {"lights-blue-red-green", {0x654dbdac3050e5b3, 0x9122727134d729d9, 0x29d1c3bba32b853c, 0x6e9ab5184b40d757, 0xabc0c807b4b4b82f, 0x04f6538c3873201b}},
    {"three-lights", {0x6307aeb66acb73f7, 0x0d364cdea6ea1f7b, 0x91090ffefaa4fa7a, 0x5bc3b6a3c36d1e22, 0xb55007b5f41b04a4, 0x14adb38aa9c1231c}},
    {"many-lights", {0xd4dc6905685ad513, 0x0f33b05837e51d79, 0xa9fadf07cf452c48, 0xd4dc6905685ad513, 0xd4dc6905685ad513, 0xd4dc6905685ad513}},
};

#define GOLDEN_COUNT (sizeof golden_hashes / sizeof *golden_hashes)

#endif
