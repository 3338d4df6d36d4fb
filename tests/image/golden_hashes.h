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
    {"sphere-10x6", {0xa9d7451990f60771, 0xf3752c7ebec0ea04, 0x8fb24296d5fe456b, 0x25e78bc752d250d4, 0xc650131aada95ad0, 0xfc819e7bc00681b1}},
    {"sphere-32x16", {0x94eb35316930a012, 0xec62c965ccc13c5a, 0xd00d4e50dfbd88ef, 0x15fc1cf275aecb65, 0xf5f62acf1d7e5115, 0xa979d0d081a14f82}},
    {"sphere-64x32", {0xd23024c00109a5bd, 0x0d2662d3d74166a0, 0x5cc618f978979a20, 0x1527e14eeb28d138, 0xa92d65efff1c0486, 0x50c5270958754b0d}},
    {"blinn", {0x87bfa8195f0d51f1, 0x4a16eba70cd2b32f, 0x1abeea0b20d59f1b, 0xf726e8b07c8fec6a, 0x6d635ecf9a99fdf9, 0xd1cbb002392c0e41}},
    {"teapot", {0x5de2747f8dcebbff, 0x3e7f180602e9e863, 0x0e2e65c2e9a48abb, 0xa69d06942592f76a, 0x043ab92c2a0d3b75, 0xfe83cd5aa58b1266}},
    {"torus-knot", {0x10ae2809b774999d, 0x538afe4135cdb5d5, 0x119171c47599a754, 0x3945f2d96a9a2dc6, 0xe3d163e09b9ae414, 0x6a679542ef872e12}},
    {"room", {0x00c3c17a6f870320, 0xaf47594f768779b2, 0x420e7bd4181b8ecf, 0x00c3c17a6f870320, 0x00c3c17a6f870320, 0x00c3c17a6f870320}},
    {"point-light", {0xf550b5d9c881c38b, 0x2f0f1445ef9c2a49, 0x923ac2bdb1a95c70, 0xf550b5d9c881c38b, 0xf550b5d9c881c38b, 0xf550b5d9c881c38b}},
    {"ambient-ratio", {0xbac51f909dea2057, 0x2d2a0838cfe173be, 0x78a3d09c9c547539, 0xa5c75acfb0f368c0, 0x546a90bf31c751b5, 0x7d863ef09fe19bb7}},
    {"specular-grid", {0xb9bda56b043b14ca, 0x0ff0001d885061be, 0xf6db5a80d78bc974, 0xceec70a68ff6ac1e, 0x3c9590c8cd575c46, 0xeb58245b07a9772f}},
    {"ambient-only", {0xa8cddc40d6885ae4, 0xa8cddc40d6885ae4, 0xa8cddc40d6885ae4, 0xa8cddc40d6885ae4, 0xa8cddc40d6885ae4, 0xa8cddc40d6885ae4}},
    {"diffuse-only", {0x6cb6bba0edcb5642, 0x968491346b764850, 0xd1908d934b9a104e, 0x224de7b031f37c59, 0x44b71a5308f2c3ea, 0x58eaa489f064940e}},
    {"full-phong", {0x810c962544f30563, 0xe54680b77934bd60, 0x951c9c6fad0e3e66, 0xea423554c0b5eda8, 0x1ca3e0e2aa1cd313, 0x1b27f42c692c4df1}},
    {"lights-blue", {0x4ae516cc5ca87a02, 0x1d9f8fd06b16b123, 0xdfdfb9ba87ddaf68, 0x1f5a1c3a1a023a20, 0xbddb9b70c65b76c1, 0xb034dc2fbe807733}},
    {"lights-blue-red", {0x449a89065b12c4b0, 0xb828fd685cbd03fd, 0xc575cbf871548fe7, 0x0b0ea65e10080652, 0xd4b04f064feea1c3, 0xd8ad75a460ed8277}},
    {"lights-blue-red-green", {0x654dbdac3050e5b3, 0x9122727134d729d9, 0x29d1c3bba32b853c, 0x2a30512cd7e69e28, 0x35a09754004759c9, 0x5a895473e57ea1bf}},
    {"three-lights", {0x6307aeb66acb73f7, 0x0d364cdea6ea1f7b, 0x91090ffefaa4fa7a, 0xadbcf8207f2feadb, 0x0c68df6ddd173bc0, 0xbf7a768ed08b88a1}},
    {"many-lights", {0xd4dc6905685ad513, 0x0f33b05837e51d79, 0xa9fadf07cf452c48, 0xd4dc6905685ad513, 0xd4dc6905685ad513, 0xd4dc6905685ad513}},
};

#define GOLDEN_COUNT (sizeof golden_hashes / sizeof *golden_hashes)

#endif
