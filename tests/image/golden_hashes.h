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
    {"sphere-10x6", {0x0ecc639d6ce0ffa8, 0x971d018ab5d1e329, 0x8fb24296d5fe456b, 0x42ce438058cf4746, 0x941293da3e993237, 0x54917f687d2a945b}},
    {"sphere-32x16", {0xe03a19c126c17927, 0xec62c965ccc13c5a, 0xd00d4e50dfbd88ef, 0x43b1e3b6a1faff25, 0x6aa4899fe60a110e, 0x217fac9f928ac3cb}},
    {"sphere-64x32", {0xf2d906325b33c9b0, 0xa71b6257de409ee3, 0x5cc618f978979a20, 0x60f2bf9394e3412a, 0x4a39f1667e0ac438, 0xaf3b70ec5e3e5cca}},
    {"blinn", {0x87bfa8195f0d51f1, 0x1d66fd30dec4db06, 0x1abeea0b20d59f1b, 0x4f107cd0e57c7334, 0xf4826dc3bf0ae91b, 0xd22bf85995bcfa4d}},
    {"teapot", {0x0fe24ca4e4c03052, 0x3e7f180602e9e863, 0x0e2e65c2e9a48abb, 0x919f2048fd05e88d, 0x9f749191433d61cf, 0x9d674ec18ab03dce}},
    {"torus-knot", {0x10ae2809b774999d, 0x538afe4135cdb5d5, 0x119171c47599a754, 0x4502009284c18925, 0x8b76fb492f59723a, 0x901d4d73986f4618}},
    {"room", {0x0def36e651f3795f, 0xfee462856ed8a088, 0x420e7bd4181b8ecf, 0x837b8f69cee613ed, 0x525966c48f42b2db, 0x53819a62c325a8d7}},
    {"point-light", {0xf550b5d9c881c38b, 0xec6b27271b187050, 0x923ac2bdb1a95c70, 0xe5e5356e6df596d7, 0x78dd15257d992fe5, 0xf550b5d9c881c38b}},
    {"ambient-ratio", {0xbac51f909dea2057, 0x2d2a0838cfe173be, 0x78a3d09c9c547539, 0x3e00ac19923d2f6b, 0x6fe52be9e37c9d12, 0xcfca9219044f9bd0}},
    {"specular-grid", {0x3637bd8cf74d7c31, 0x0ff0001d885061be, 0xf6db5a80d78bc974, 0x0eab510f3f829bef, 0x70adfd77b6933832, 0x2615dedc2cbfc419}},
    {"ambient-only", {0xa8cddc40d6885ae4, 0xa8cddc40d6885ae4, 0xa8cddc40d6885ae4, 0xa8cddc40d6885ae4, 0xa8cddc40d6885ae4, 0xa8cddc40d6885ae4}},
    {"diffuse-only", {0x6cb6bba0edcb5642, 0x968491346b764850, 0xd1908d934b9a104e, 0x0dcf5eb1f194aef5, 0xc7c40f7d1ac477da, 0xccd5ac37b796403e}},
    {"full-phong", {0x810c962544f30563, 0x41b5b0b58334f53b, 0x951c9c6fad0e3e66, 0xc3a929230ea05257, 0x75cbe580ba22eaeb, 0xf79067ed36984ee4}},
    {"lights-blue", {0x4ae516cc5ca87a02, 0x1d9f8fd06b16b123, 0xdfdfb9ba87ddaf68, 0x092ffd2267a5ef18, 0x02841c23b48432e2, 0xc160c0ca41b0a84d}},
    {"lights-blue-red", {0x449a89065b12c4b0, 0xb828fd685cbd03fd, 0xc575cbf871548fe7, 0x56a2ae8532b2ab39, 0x3bb2b2eb9033451a, 0xe676b5b9d34e34e7}},
    {"lights-blue-red-green", {0xace1e90df8e2542a, 0x9122727134d729d9, 0x29d1c3bba32b853c, 0x935db0fd97f6125d, 0x5b78c9e817b45a9a, 0xe5f0b6847045fdeb}},
    {"three-lights", {0x6e104862ed1478b1, 0x0d364cdea6ea1f7b, 0x91090ffefaa4fa7a, 0x8bd6062b4d28a67b, 0xbfd0c5e12bfa37f0, 0x2928e93bf10264b7}},
    {"many-lights", {0xd4dc6905685ad513, 0x0f33b05837e51d79, 0xa9fadf07cf452c48, 0xf86eb86449675386, 0x06d4f2b41bb936e8, 0xf0392346e32b31eb}},
};

#define GOLDEN_COUNT (sizeof golden_hashes / sizeof *golden_hashes)

#endif
