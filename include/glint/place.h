/* SPDX-License-Identifier: MIT */
/*
 * Making and combining places (affine transforms, see glint_place in <glint/scene.h>).
 */
#ifndef GLINT_PLACE_H
#define GLINT_PLACE_H

#include <glint/scene.h>

#ifdef __cplusplus
extern "C" {
#endif

/*
 * Rotation by an angle in 1/65536 turn, counter-clockwise seen from the tip of the axis. Each entry is the exact value
 * rounded to Q16, within 0.51 ulp.
 */
glint_place glint_turn_x(uint16_t angle_turn16);
glint_place glint_turn_y(uint16_t angle_turn16);
glint_place glint_turn_z(uint16_t angle_turn16);

/* Translation, in Q16 world units. */
glint_place glint_shift(int32_t x_q16, int32_t y_q16, int32_t z_q16);

/* Scale along the model's axes, in Q16; a negative factor mirrors. */
glint_place glint_scale(int32_t x_q16, int32_t y_q16, int32_t z_q16);

/*
 * `first`, then `second`: the place whose effect is second(first(p)). Entries are rounded to Q16 (0.51 ulp from the
 * exact product of the given bits) and saturate at the int32 limits. An all-zero linear part is read as the identity.
 */
glint_place glint_then(const glint_place *first, const glint_place *second);

#ifdef __cplusplus
}
#endif

#endif
