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
    {"sphere-32x16", {0xe03a19c126c17927, 0xec62c965ccc13c5a, 0xd00d4e50dfbd88ef, 0x5284cba268c7716c, 0x5fcdd12a3243ce7f, 0x217fac9f928ac3cb}},
    {"sphere-64x32", {0xf2d906325b33c9b0, 0xa71b6257de409ee3, 0x5cc618f978979a20, 0xb689994e6777d114, 0xd977a90c42712786, 0xaf3b70ec5e3e5cca}},
    {"blinn", {0x87bfa8195f0d51f1, 0x1d66fd30dec4db06, 0x1abeea0b20d59f1b, 0x4f107cd0e57c7334, 0xf4826dc3bf0ae91b, 0xd22bf85995bcfa4d}},
    {"teapot", {0x0fe24ca4e4c03052, 0x3e7f180602e9e863, 0x0e2e65c2e9a48abb, 0xe131e27db9c75e88, 0x47a76d014c434174, 0x9d674ec18ab03dce}},
    {"torus-knot", {0x10ae2809b774999d, 0x538afe4135cdb5d5, 0x119171c47599a754, 0x4502009284c18925, 0xd505c25eefc80802, 0x901d4d73986f4618}},
    {"room", {0x0def36e651f3795f, 0xfee462856ed8a088, 0x420e7bd4181b8ecf, 0x837b8f69cee613ed, 0x525966c48f42b2db, 0x53819a62c325a8d7}},
    {"point-light", {0xf550b5d9c881c38b, 0xec6b27271b187050, 0x923ac2bdb1a95c70, 0xe5e5356e6df596d7, 0x78dd15257d992fe5, 0xf550b5d9c881c38b}},
    {"spots", {0x10655a144a80dcaf, 0x4c186d7a7c725961, 0xaaf3e70cd07beeda, 0x10655a144a80dcaf, 0x10655a144a80dcaf, 0x10655a144a80dcaf}},
    {"open-sky", {0x040b994190ab992d, 0x382571208b69b0e7, 0x4785ccc38e5d8d7d, 0x040b994190ab992d, 0x040b994190ab992d, 0x040b994190ab992d}},
    {"lanterns", {0xbe4ec873c9b7067c, 0x7a220a5fa185eb57, 0xa9aa45b507693f02, 0xbe4ec873c9b7067c, 0xbe4ec873c9b7067c, 0xbe4ec873c9b7067c}},
    {"panels", {0x591c4fc9389d16c1, 0xc44d30c1b795475a, 0x7f43d5db3651cfc0, 0x591c4fc9389d16c1, 0x4280f00c30c2dca1, 0x591c4fc9389d16c1}},
    {"globe", {0x1f9b7dc7425211db, 0x9d2ce95d70bd4ed7, 0x958d1f7f378455ec, 0x1f9b7dc7425211db, 0x1f9b7dc7425211db, 0x1f9b7dc7425211db}},
    {"source-directional", {0x8d566cfebb4bf96a, 0x4c2e912aff831db7, 0x74ab7e8756b6873a, 0xa5b2cf34be3e032f, 0x2a6bb141f7929f66, 0xd2a18ea443a22df1}},
    {"source-point", {0xe7b3f62efd819309, 0x50294f6256104e6f, 0x779fcde43fc3112a, 0x6827a2691946e3f8, 0xa8c786426bb023e8, 0xe7b3f62efd819309}},
    {"source-four", {0x87eb097228965103, 0xc1eabe64f14ef90c, 0x04cb83fb524744b5, 0xd3a92bdf6e42a2e9, 0x23c107edf3cb9351, 0x87eb097228965103}},
    {"source-panel", {0x4e977f0dd48b22ea, 0x264e4099cc388919, 0xfa55777bf33f47c9, 0x4e977f0dd48b22ea, 0xe87fb58273c70c09, 0x4e977f0dd48b22ea}},
    {"eight-lamps", {0x467d30166e87c9aa, 0x0f9e557f90cbb4e3, 0xe4c8c608588e20c5, 0x467d30166e87c9aa, 0x467d30166e87c9aa, 0x467d30166e87c9aa}},
    {"chrome", {0xad1d808ad458c79b, 0x20d329b8feb58cbd, 0x4bffa1f25fea80bf, 0xad1d808ad458c79b, 0xad1d808ad458c79b, 0xad1d808ad458c79b}},
    {"gilded", {0x9d6c23827f5342be, 0xcfd73ef22377202a, 0xdb36eb1ee944ec72, 0x9d6c23827f5342be, 0x9d6c23827f5342be, 0x9d6c23827f5342be}},
    {"bowls", {0x3e3a2e1107d0ba01, 0x1026c05e3901b88b, 0xa538998e2cce39fb, 0x0530497d982038e2, 0x9fb2ccca182156e2, 0x0c7772d4500055f2}},
    {"avenue", {0x39e77226e965bb5d, 0xc4f59419dca6640e, 0xc7479e395a1988e2, 0x5ee2b9aa85992159, 0x796efa85894ba80a, 0x9998182810d8ba58}},
    {"glass", {0x8ce33c5efba6fbf9, 0xc16a315d7125da56, 0x0a79d7afcbc0262c, 0x1a9963fda986178a, 0x1a9963fda986178a, 0x8ce33c5efba6fbf9}},
    {"pond", {0x79181ebf44c95bbb, 0x4a1e4ad8b5617b55, 0x7395501ff7dd3e64, 0x3108a7baf7e8a469, 0xb42bfad1f24bf703, 0x5fec7d586cef899c}},
    {"mesh", {0x41889ba76e926546, 0x504dc6df1aae7e87, 0xce86971e5ac18e67, 0x09edf61309a764a6, 0x2f5369e85d31e4ba, 0x9e990c0dceabc7d0}},
    {"tiles", {0xd4b594251e82296b, 0xa3c34d844413740e, 0x56f338789f096465, 0xdad6696ebf004ede, 0xf6734d629737383d, 0xd19aa0032b2a15c0}},
    {"planet", {0x0f02fc529ba874cf, 0x61b18bccd21df99c, 0x80b6b721416b4db6, 0xb34dc9dc6396a6f0, 0x6dba87a5cdf8e1a8, 0x0f02fc529ba874cf}},
    {"shadows-sun", {0x9053cada316608d4, 0xefe5957e6657d539, 0x32e420a3424233f2, 0x2f1e1d524b102ce3, 0x54d1f513dc6a92bf, 0x408c11b2766c3786}},
    {"shadows-lamps", {0x6954616b6880f799, 0xecf9769441879957, 0x137da3b24123c53b, 0x6954616b6880f799, 0x6954616b6880f799, 0x6954616b6880f799}},
    {"ambient-ratio", {0xbac51f909dea2057, 0x2d2a0838cfe173be, 0x78a3d09c9c547539, 0xe678392132759c83, 0x0458f261354c62ef, 0xf5c6406b5a2c0e0f}},
    {"specular-grid", {0x3637bd8cf74d7c31, 0x0ff0001d885061be, 0xf6db5a80d78bc974, 0x531286395398f687, 0x5bf255f2b772ff0e, 0x234b2f9ff0408677}},
    {"exponents", {0x7591742feba964ef, 0x86812b3181e4ce3a, 0x902dcb1d10985869, 0x1231aaa667851e9b, 0xaae7a061a44e5e5f, 0x17174875feac5934}},
    {"ambient-only", {0xa8cddc40d6885ae4, 0xa8cddc40d6885ae4, 0xa8cddc40d6885ae4, 0xa8cddc40d6885ae4, 0xa8cddc40d6885ae4, 0xa8cddc40d6885ae4}},
    {"diffuse-only", {0x6cb6bba0edcb5642, 0x968491346b764850, 0xd1908d934b9a104e, 0xe658b71dc525e450, 0xc8d5c5a4a07d8471, 0x10c27b758a8bdc42}},
    {"full-phong", {0x810c962544f30563, 0x41b5b0b58334f53b, 0x951c9c6fad0e3e66, 0x3b742515a460e411, 0xa8cb604b695c8c70, 0xf79067ed36984ee4}},
    {"lights-blue", {0x4ae516cc5ca87a02, 0x1d9f8fd06b16b123, 0xdfdfb9ba87ddaf68, 0x7faf13412656da41, 0x7de3f4b131c8015e, 0xc160c0ca41b0a84d}},
    {"lights-blue-red", {0x449a89065b12c4b0, 0xb828fd685cbd03fd, 0xc575cbf871548fe7, 0x34ff4fa60d85e6f8, 0x5530d39848166cae, 0xe676b5b9d34e34e7}},
    {"lights-blue-red-green", {0xace1e90df8e2542a, 0x9122727134d729d9, 0x29d1c3bba32b853c, 0x4fa01c6c2147bf58, 0x72b234be12ee68b7, 0xe5f0b6847045fdeb}},
    {"three-lights", {0x6e104862ed1478b1, 0x0d364cdea6ea1f7b, 0x91090ffefaa4fa7a, 0x4717beb5336ec0d2, 0x37470c6f32177d92, 0x2928e93bf10264b7}},
    {"many-lights", {0xd4dc6905685ad513, 0x0f33b05837e51d79, 0xa9fadf07cf452c48, 0x3e4bee1c8ace5b8e, 0xd7a3cc0c9f7f9b1a, 0xf0392346e32b31eb}},
};

#define GOLDEN_COUNT (sizeof golden_hashes / sizeof *golden_hashes)

#endif
