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
    {"sphere-10x6", {0x0ecc639d6ce0ffa8, 0x971d018ab5d1e329, 0x8fb24296d5fe456b, 0x7e5d1836cc520b8d, 0xe728a1b6688cb4ec, 0x54917f687d2a945b}},
    {"sphere-32x16", {0xe03a19c126c17927, 0xec62c965ccc13c5a, 0xd00d4e50dfbd88ef, 0xeca73cec0ea1db32, 0xfc9f1cc02dcea995, 0x217fac9f928ac3cb}},
    {"sphere-64x32", {0xf2d906325b33c9b0, 0xa71b6257de409ee3, 0x5cc618f978979a20, 0xaf48a93288125d32, 0x767e47b483a60d7c, 0xaf3b70ec5e3e5cca}},
    {"blinn", {0x87bfa8195f0d51f1, 0x1d66fd30dec4db06, 0x1abeea0b20d59f1b, 0xfdd0c14b5768f806, 0x2c7462878f8dd79d, 0xd22bf85995bcfa4d}},
    {"teapot", {0x0fe24ca4e4c03052, 0x3e7f180602e9e863, 0x0e2e65c2e9a48abb, 0xaae6d224e5dc42ae, 0xf7308215a1d50c93, 0x9d674ec18ab03dce}},
    {"torus-knot", {0x10ae2809b774999d, 0x538afe4135cdb5d5, 0x119171c47599a754, 0x122eb8a066e0000c, 0x6374fb44920e8e9d, 0x901d4d73986f4618}},
    {"room", {0x0def36e651f3795f, 0xfee462856ed8a088, 0x420e7bd4181b8ecf, 0x02e8b05445d8f158, 0x52ebdb3576f88c49, 0x53819a62c325a8d7}},
    {"point-light", {0xf550b5d9c881c38b, 0xec6b27271b187050, 0x923ac2bdb1a95c70, 0xb389bde7bb361779, 0x3220a165cbb3f9e4, 0xf550b5d9c881c38b}},
    {"ambient-ratio", {0xbac51f909dea2057, 0x2d2a0838cfe173be, 0x78a3d09c9c547539, 0xc104d8f6e035b1b6, 0x32a13b5639996118, 0xcfca9219044f9bd0}},
    {"specular-grid", {0x3637bd8cf74d7c31, 0x0ff0001d885061be, 0xf6db5a80d78bc974, 0xcb66260ee083a26f, 0x3959c0defda6c67e, 0x2615dedc2cbfc419}},
    {"ambient-only", {0xa8cddc40d6885ae4, 0xa8cddc40d6885ae4, 0xa8cddc40d6885ae4, 0xa8cddc40d6885ae4, 0xa8cddc40d6885ae4, 0xa8cddc40d6885ae4}},
    {"diffuse-only", {0x6cb6bba0edcb5642, 0x968491346b764850, 0xd1908d934b9a104e, 0xae6a5739e39c881e, 0xaf47e130254c3614, 0xccd5ac37b796403e}},
    {"full-phong", {0x810c962544f30563, 0x41b5b0b58334f53b, 0x951c9c6fad0e3e66, 0xddd6a9ace96e1ab6, 0x5c3ea35a0f2c963e, 0xf79067ed36984ee4}},
    {"lights-blue", {0x4ae516cc5ca87a02, 0x1d9f8fd06b16b123, 0xdfdfb9ba87ddaf68, 0x8b5c86aff25c0eae, 0xe667ce3a09f2aeea, 0xc160c0ca41b0a84d}},
    {"lights-blue-red", {0x449a89065b12c4b0, 0xb828fd685cbd03fd, 0xc575cbf871548fe7, 0x967932682e9655af, 0xf76a53d4f866ecdd, 0xe676b5b9d34e34e7}},
    {"lights-blue-red-green", {0xace1e90df8e2542a, 0x9122727134d729d9, 0x29d1c3bba32b853c, 0x1c16b944310fbb5e, 0x7f7d78975c54c929, 0xe5f0b6847045fdeb}},
    {"three-lights", {0x6e104862ed1478b1, 0x0d364cdea6ea1f7b, 0x91090ffefaa4fa7a, 0x91b1eba0093d9d4b, 0x4687e52d6a5e3c36, 0x2928e93bf10264b7}},
    {"many-lights", {0xd4dc6905685ad513, 0x0f33b05837e51d79, 0xa9fadf07cf452c48, 0x90eca34d4d5b4370, 0xea67be68699b026f, 0xf0392346e32b31eb}},
};

#define GOLDEN_COUNT (sizeof golden_hashes / sizeof *golden_hashes)

#endif
