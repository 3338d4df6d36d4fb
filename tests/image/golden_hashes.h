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
    {"sphere-32x16", {0x94eb35316930a012, 0xec62c965ccc13c5a, 0xd00d4e50dfbd88ef, 0x15fc1cf275aecb65, 0xc61f712fa527b8c9, 0xa979d0d081a14f82}},
    {"sphere-64x32", {0xd23024c00109a5bd, 0x0d2662d3d74166a0, 0x5cc618f978979a20, 0x85787dace18f14a3, 0x3f6c02a8a5ffc751, 0x50c5270958754b0d}},
    {"blinn", {0x87bfa8195f0d51f1, 0x4a16eba70cd2b32f, 0x1abeea0b20d59f1b, 0x770652de7959c7cf, 0xa25edc508ee8c559, 0xd1cbb002392c0e41}},
    {"teapot", {0x5de2747f8dcebbff, 0x3e7f180602e9e863, 0x0e2e65c2e9a48abb, 0x71420053537b1a9e, 0x72597781ff6651a3, 0x5b1ae7db01b8fa7c}},
    {"torus-knot", {0x10ae2809b774999d, 0x538afe4135cdb5d5, 0x119171c47599a754, 0xa1723a9a34cce515, 0xaa7045c5615165ba, 0x997942598b7bfb56}},
    {"room", {0x00c3c17a6f870320, 0xaf47594f768779b2, 0x420e7bd4181b8ecf, 0x00c3c17a6f870320, 0x00c3c17a6f870320, 0x00c3c17a6f870320}},
    {"point-light", {0xf550b5d9c881c38b, 0x2f0f1445ef9c2a49, 0x923ac2bdb1a95c70, 0xf550b5d9c881c38b, 0xf550b5d9c881c38b, 0xf550b5d9c881c38b}},
    {"ambient-ratio", {0xbac51f909dea2057, 0x2d2a0838cfe173be, 0x78a3d09c9c547539, 0xa5c75acfb0f368c0, 0x17933cd8985694cd, 0x7d863ef09fe19bb7}},
    {"specular-grid", {0xb9bda56b043b14ca, 0x0ff0001d885061be, 0xf6db5a80d78bc974, 0xda47831e4caca86e, 0xe7b520aca5819af8, 0x869db90932dd3308}},
    {"ambient-only", {0xa8cddc40d6885ae4, 0xa8cddc40d6885ae4, 0xa8cddc40d6885ae4, 0xa8cddc40d6885ae4, 0xa8cddc40d6885ae4, 0xa8cddc40d6885ae4}},
    {"diffuse-only", {0x6cb6bba0edcb5642, 0x968491346b764850, 0xd1908d934b9a104e, 0xb39713130bd17422, 0x9f232813d9eb57fd, 0xef8f921ea4e25bc5}},
    {"full-phong", {0x810c962544f30563, 0xe54680b77934bd60, 0x951c9c6fad0e3e66, 0xdf35628af8919746, 0x7979b7b8c5a28bd1, 0x08c12f354a45b9ef}},
    {"lights-blue", {0x4ae516cc5ca87a02, 0x1d9f8fd06b16b123, 0xdfdfb9ba87ddaf68, 0x6b9d15118dc7d9cd, 0x287f41173247f4e9, 0x45cedaf4fce5aaab}},
    {"lights-blue-red", {0x449a89065b12c4b0, 0xb828fd685cbd03fd, 0xc575cbf871548fe7, 0x972c55da0410cbd5, 0x4a09b45b184a5f77, 0x4ce5b60500dd45c5}},
    {"lights-blue-red-green", {0x654dbdac3050e5b3, 0x9122727134d729d9, 0x29d1c3bba32b853c, 0xab755f6539ea22e8, 0x6dcb3f8942ac4971, 0x44b9969bbeb30e3a}},
    {"three-lights", {0x6307aeb66acb73f7, 0x0d364cdea6ea1f7b, 0x91090ffefaa4fa7a, 0xf18d2a06b5320d5c, 0xf28b33600c6c3010, 0xff7a2f9535799f45}},
    {"many-lights", {0xd4dc6905685ad513, 0x0f33b05837e51d79, 0xa9fadf07cf452c48, 0xd4dc6905685ad513, 0xd4dc6905685ad513, 0xd4dc6905685ad513}},
};

#define GOLDEN_COUNT (sizeof golden_hashes / sizeof *golden_hashes)

#endif
