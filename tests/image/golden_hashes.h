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
    {"sphere-10x6", {0x93d59a0188988c45, 0xf3752c7ebec0ea04, 0x8fb24296d5fe456b}},
    {"sphere-32x16", {0xf2fe3cf7ccfa7fdc, 0x733d899b55ab41d2, 0xd00d4e50dfbd88ef}},
    {"sphere-64x32", {0x4bba999b10e3d6a1, 0x8ff42643b324f877, 0x73c7edd46a23607a}},
    {"blinn", {0xfe7e3c9e52cbb6ae, 0xe98239fe3090dab4, 0x1abeea0b20d59f1b}},
    {"teapot", {0x05d9916aa1404f7a, 0x8a68a67b181442e4, 0x01645372a9c46cc1}},
    {"torus-knot", {0xd0c7367e8af9b737, 0x3e4fc03d39f51082, 0x494361fd95f20e22}},
    {"room", {0x8e3c9e2ced7777c7, 0x51d97ac0a9eef369, 0x50f0afae019fa7d3}},
    {"point-light", {0xc1276976a8fc0c3f, 0xb6e20184ef1dc770, 0xa005b120177e80e1}},
    {"ambient-ratio", {0x23411819ada4980a, 0x9172ac8b4c52282b, 0x29c2a8257e82e6a9}},
    {"specular-grid", {0x58db4b19550dde56, 0xcabee5f18597d336, 0x605c7851b131d755}},
    {"ambient-only", {0xa8cddc40d6885ae4, 0xa8cddc40d6885ae4, 0xa8cddc40d6885ae4}},
    {"diffuse-only", {0x5f530b949e2337af, 0x474da0041ff52b3f, 0xd1675c36d73f2c7f}},
    {"full-phong", {0x41f5cf703bad2f2f, 0xf7abd64c7d461dc1, 0xc54815ea8b50a360}},
    {"lights-blue", {0xf3f1461997cddac9, 0x50c3c1cc568bbb8e, 0xbaf8eb5546674df4}},
    {"lights-blue-red", {0x97bb2dda6c65f1be, 0x8fbcab88e444ebb4, 0xfba3c32f067114a5}},
    {"lights-blue-red-green", {0x8b715870f4c62998, 0x2a84f5ea5fce2bf7, 0xec0ff109e5d96441}},
    {"three-lights", {0xec6184b9b502219a, 0x67dbd84541a955a7, 0x532b04cb766aa3b4}},
    {"many-lights", {0x95e9f84d1e26aecc, 0xe1335c52734f007d, 0xa220fc0ac9520376}},
};

#define GOLDEN_COUNT (sizeof golden_hashes / sizeof *golden_hashes)

#endif
