/* SPDX-License-Identifier: MIT */
#include "geometry/view.h"

#include <glint/error.h>

#include "geometry/place.h"

/* a . b; the caller answers for the sum's range. */
static int64_t dot(const int32_t a[3], const int32_t b[3])
{
    int64_t sum = 0;
    for (int k = 0; k < 3; k++) {
        sum += multiply_wide_s32(a[k], b[k]);
    }
    return sum;
}

static void cross(const int32_t a[3], const int32_t b[3], int64_t out[3])
{
    for (int k = 0; k < 3; k++) {
        const int i = k < 2 ? k + 1 : 0, j = k > 0 ? k - 1 : 2;
        out[k] = multiply_wide_s32(a[i], b[j]) - multiply_wide_s32(a[j], b[i]);
    }
}

/* left . right, likewise. */
static void product(const int32_t (*left)[3], const int32_t (*right)[3], int64_t (*out)[3])
{
    for (int k = 0; k < 3; k++) {
        const int32_t column[3] = {right[0][k], right[1][k], right[2][k]};
        for (int i = 0; i < 3; i++) {
            out[i][k] = dot(left[i], column);
        }
    }
}

/* matrix . (point - eye): at most a unit row times a vector, 2^30 2^31 sqrt(3) < 2^62. The difference may have a bit
 * too much for 32. */
static void multiply_offset(const int32_t (*matrix_q30)[3], const int32_t point_q16[3], const glint_view *view,
                            int64_t out_q46[3])
{
    for (int k = 0; k < 3; k++) {
        GLINT_TRACE("offset from the eye q16", (int64_t)point_q16[k] - view->eye_q16[k]); /* <= 2^31 */
        out_q46[k] = dot(matrix_q30[k], point_q16) - dot(matrix_q30[k], view->eye_q16);
        GLINT_TRACE("turned offset q46", out_q46[k]);
    }
}

static bool camera_basis(const glint_camera *camera, int32_t basis_q30[3][3], int *error)
{
    int64_t forward[3], v[3];
    int32_t up[3] = {camera->up[0], camera->up[1], camera->up[2]};
    if (up[0] == 0 && up[1] == 0 && up[2] == 0) {
        up[1] = 1;
    }
    for (int k = 0; k < 3; k++) {
        forward[k] = (int64_t)camera->target_q16[k] - camera->eye_q16[k];
    }
    if (!glint_unit_q30(forward, basis_q30[2])) {
        *error = GLINT_ERROR_CAMERA_DIRECTION;
        return false;
    }
    cross(basis_q30[2], up, v);
    /* parallel: no component of the product reaches 2^-10 of what it could, so the sine is below 0.0017 (0.1 degrees).
     * Nearer, the rounding of the view direction would turn the picture by more than a sub-pixel. */
    uint64_t product = 0, length = 0;
    for (int k = 0; k < 3; k++) {
        product = magnitude64(v[k]) > product ? magnitude64(v[k]) : product;
        length = magnitude32(up[k]) > length ? magnitude32(up[k]) : length;
    }
    const bool parallel = product < length << 20;
    if (parallel || !glint_unit_q30(v, basis_q30[0])) {
        *error = GLINT_ERROR_CAMERA_UP;
        return false;
    }
    cross(basis_q30[2], basis_q30[0], v);
    (void)glint_unit_q30(v, basis_q30[1]);
    return true;
}

int glint_camera_check(const glint_camera *camera)
{
    int32_t basis_q30[3][3];
    int error = GLINT_OK;
    (void)camera_basis(camera, basis_q30, &error);
    return error;
}

void glint_view_set_up(glint_view *view, const glint_camera *camera, uint16_t width_px, uint16_t height_px)
{
    int error;
    (void)camera_basis(camera, view->basis_q30, &error);
    for (int k = 0; k < 3; k++) {
        view->eye_q16[k] = camera->eye_q16[k];
    }
    view->width_px = width_px;
    view->height_px = height_px;
    view->near_units = glint_scaled_from((uint32_t)camera->near_q16, 16);
    /* focal = height / 2 cos / sin */
    int32_t sine_q30, cosine_q30;
    glint_sine_cosine_q30(camera->field_of_view_turn16 >> 1, &sine_q30, &cosine_q30);
    if (camera->field_of_view_turn16 & 1) {
        /* half of an odd angle: sine and cosine half a step (pi / 65536) farther on, by the addition theorem */
        const int32_t step_q30 = 51472, s = sine_q30, c = cosine_q30;
        /* (pi/65536)^2 / 2 = 1.15e-9 is 1 in Q30 */
        sine_q30 = s + glint_multiply_q30(c, step_q30) - (s >> 30);
        cosine_q30 = c - glint_multiply_q30(s, step_q30) - (c >> 30);
    }
    const glint_scaled inverse_sine = glint_scaled_inverse(glint_scaled_from((uint32_t)sine_q30, 30));
    const glint_scaled cotangent = glint_scaled_times(inverse_sine, (uint32_t)cosine_q30, 30);
    view->focal_px = glint_scaled_times(cotangent, height_px, 1);
    view->inverse_focal_px = glint_scaled_inverse(view->focal_px);
}

uint32_t glint_view_pixel_q18(const glint_view *view)
{
    /* 170 degrees and one row: 1 / focal is below 24; no angle is above pi */
    const int64_t angle = glint_shift_round64(view->inverse_focal_px.m, 18 - view->inverse_focal_px.f) + 1;
    return angle > (int64_t)4 << 18 ? (uint32_t)4 << 18 : (uint32_t)angle;
}

/* in 2^shift, rounded to nearest; the caller answers for the range. */
static void shift_vector(const int64_t in[3], int shift, int32_t out[3])
{
    for (int k = 0; k < 3; k++) {
        const int64_t entry = glint_shift_round64(in[k], shift);
        GLINT_TRACE("set-up vector", entry);
        out[k] = (int32_t)entry;
    }
}

static void shift_matrix(int64_t (*in)[3], int shift, int32_t (*out)[3])
{
    for (int i = 0; i < 3; i++) {
        shift_vector(in[i], shift, out[i]);
    }
}

/* A row of 64-bit entries, brought to int32 with so many fractional bits. */
static void scale_row(const int64_t linear_q46[3], int64_t origin_q46, int fraction_bits, int fraction, int32_t row[4])
{
    shift_vector(linear_q46, fraction + 16 - 46 - fraction_bits, row);
    for (int k = 0; k < 3; k++) {
        GLINT_TRACE("row entry", row[k]);
    }
    const int64_t origin = glint_shift_round64(origin_q46, fraction - 46);
    GLINT_TRACE("row origin", origin);
    row[3] = (int32_t)origin;
}

/* Number of bits of |v[0]| + |v[1]| + |v[2]|. */
static int sum_bits(const int64_t v[3])
{
    return bit_length64(magnitude64(v[0]) + magnitude64(v[1]) + magnitude64(v[2]));
}

/* Number of bits that a row's result can have before the binary point (negative for a small one). */
static int row_bits(const int64_t linear_q46[3], int64_t origin_q46, int fraction_bits)
{
    const int linear_bits = sum_bits(linear_q46) - 46 + 15 - fraction_bits; /* |p| <= 2^15 */
    const int origin_bits = bit_length64(magnitude64(origin_q46)) - 46;
    return (linear_bits > origin_bits ? linear_bits : origin_bits) + 1;
}

/* The object's place turned by a matrix of unit rows: `bits` are those before the binary point, row by row. */
typedef struct turned_place {
    int64_t linear_q46[3][3], origin_q46[3];
    int bits[3];
} turned_place;

static void turn_place(turned_place *turned, const int32_t (*matrix_q30)[3], const glint_view *view,
                       const glint_object *object)
{
    int32_t linear_q16[3][3];
    glint_linear_of(&object->place, linear_q16);
    product(matrix_q30, (const int32_t(*)[3])linear_q16, turned->linear_q46); /* <= 2^30 2^26 sqrt(3) */
    multiply_offset(matrix_q30, object->place.origin_q16, view, turned->origin_q46);
    for (int i = 0; i < 3; i++) {
        for (int k = 0; k < 3; k++) {
            GLINT_TRACE("model to view q46", turned->linear_q46[i][k]);
        }
        turned->bits[i] = row_bits(turned->linear_q46[i], turned->origin_q46[i], object->mesh->fraction_bits);
    }
}

static void turned_row(const turned_place *turned, int i, const glint_object *object, int fraction, int32_t row[4])
{
    scale_row(turned->linear_q46[i], turned->origin_q46[i], object->mesh->fraction_bits, fraction, row);
}

/* count numbers times factor / 2^31. */
static void multiply_row(int32_t *row, int count, int32_t factor_m)
{
    for (int k = 0; k < count; k++) {
        row[k] = glint_multiply_q30(row[k], factor_m) >> 1; /* |row| <= 2^30, factor_m < 2^31: below 2^31 first */
    }
}

void glint_transform_set_up(glint_transform *transform, const glint_view *view, const glint_object *object)
{
    turned_place turned;
    turn_place(&turned, view->basis_q30, view, object);
    const int xy_fraction = 30 - (turned.bits[0] > turned.bits[1] ? turned.bits[0] : turned.bits[1]);
    const int z_fraction = 30 - turned.bits[2];
    turned_row(&turned, 0, object, xy_fraction, transform->x);
    turned_row(&turned, 1, object, xy_fraction, transform->y);
    turned_row(&turned, 2, object, z_fraction, transform->z);
    /* X and Y times the focal length m 2^-f: (row m) >> 31 has f - 31 more fractional bits */
    multiply_row(transform->x, 4, view->focal_px.m);
    multiply_row(transform->y, 4, view->focal_px.m);
    transform->xy_fraction = (int16_t)(xy_fraction + view->focal_px.f - 31);
    transform->z_fraction = (int16_t)z_fraction;

    const glint_scaled near = view->near_units;
    const int near_shift = z_fraction - near.f;
    const int32_t near_z = near_shift > 0 ? INT32_MAX : shift_round32(near.m, -near_shift);
    transform->near_z = near_z < 1 ? 1 : near_z;
    GLINT_TRACE("view fraction", transform->xy_fraction);
    GLINT_TRACE("view fraction", transform->z_fraction);
    transform->depth_near = glint_scaled_times(near, (uint32_t)GLINT_DEPTH_SPAN, 0);
}

/* Is linear^T linear = s^2 identity, nearly enough that angles are kept within 2^-13? Gives 3 s^2. */
static bool keeps_angles(int32_t linear_q16[3][3], uint64_t *three_squares_q32)
{
    int32_t transposed_q16[3][3];
    for (int i = 0; i < 3; i++) {
        for (int k = 0; k < 3; k++) {
            transposed_q16[i][k] = linear_q16[k][i];
        }
    }
    const int64_t first_q32 = dot(transposed_q16[0], transposed_q16[0]);
    const uint64_t limit = (uint64_t)first_q32 >> 13;
    *three_squares_q32 = 0;
    for (int i = 0; i < 3; i++) {
        for (int k = 0; k <= i; k++) {
            int64_t entry_q32 = dot(transposed_q16[i], transposed_q16[k]); /* <= 3 2^52 */
            GLINT_TRACE("gram q32", entry_q32);
            if (i == k) {
                *three_squares_q32 += (uint64_t)entry_q32;
                entry_q32 -= first_q32;
            }
            if (magnitude64(entry_q32) > limit) {
                return false;
            }
        }
    }
    return true;
}

/* The cofactor matrix, whose rows are cross products of rows. */
static void cofactors(int32_t linear_q16[3][3], int64_t out[3][3])
{
    for (int i = 0; i < 3; i++) {
        cross(linear_q16[i < 2 ? i + 1 : 0], linear_q16[i > 0 ? i - 1 : 2], out[i]); /* <= 2 2^52 */
    }
}

/* Shifts nine numbers alike so that the sum of magnitudes in each row is below 2^29. */
static void normalise_rows(int64_t in[3][3], int32_t out[3][3])
{
    int bits = 0;
    for (int i = 0; i < 3; i++) {
        const int row = sum_bits(in[i]);
        bits = row > bits ? row : bits;
    }
    shift_matrix(in, 29 - bits, out);
    for (int i = 0; i < 3; i++) {
        GLINT_TRACE("normal row sum", magnitude32(out[i][0]) + magnitude32(out[i][1]) + magnitude32(out[i][2]));
    }
}

/* The cofactors, and the determinant's sign from them: 1 or -1, 0 when |det| < 2^-24 m^3, m the greatest entry. */
static int determinant_sign(int32_t linear_q16[3][3], int64_t cofactor[3][3])
{
    cofactors(linear_q16, cofactor);
    uint32_t greatest = 0;
    for (int i = 0; i < 3; i++) {
        for (int k = 0; k < 3; k++) {
            const uint32_t entry = magnitude32(linear_q16[i][k]);
            greatest = entry > greatest ? entry : greatest;
        }
    }
    /* entries to 27 bits for precision; cofactors, below 2^55 then, to 32 bits for the product */
    const int up = 27 - bit_length64(greatest);
    int64_t determinant = 0;
    for (int k = 0; k < 3; k++) {
        GLINT_TRACE("cofactor q32", cofactor[0][k]);
        determinant += glint_shift_round64(linear_q16[0][k], up) *
                       glint_shift_round64(cofactor[0][k], 2 * up - 23); /* sum < 2^61 */
    }
    /* m in [2^26, 2^27): m^3 2^-24 2^-23 is in [2^31, 2^34) */
    const uint64_t m = (uint64_t)greatest << up;
    const uint64_t limit = (((m * m) >> 32) * m) >> 15;
    GLINT_TRACE("determinant", determinant);
    return magnitude64(determinant) < limit || determinant == 0 ? 0 : determinant > 0 ? 1 : -1;
}

int glint_place_check(const glint_place *place)
{
    int32_t linear_q16[3][3];
    int64_t cofactor[3][3];
    glint_linear_of(place, linear_q16);
    for (int i = 0; i < 3; i++) {
        for (int k = 0; k < 3; k++) {
            if (magnitude32(linear_q16[i][k]) > (uint32_t)1 << 26) {
                return GLINT_ERROR_PLACE_RANGE;
            }
        }
        if (magnitude32(place->origin_q16[i]) > (uint32_t)1 << 30) {
            return GLINT_ERROR_PLACE_RANGE;
        }
    }
    return determinant_sign(linear_q16, cofactor) == 0 ? GLINT_ERROR_PLACE_SINGULAR : GLINT_OK;
}

/* Rays through pixel centres: view components ((x + 1/2 - width/2) / f, (y + 1/2 - height/2) / f, 1), turned by the
 * transpose of `to_view`, whose columns are the lighting frame's axes seen from the camera. */
static void rays_set_up(glint_frame *frame, const glint_view *view, int32_t to_view_q30[3][3])
{
    const glint_scaled inverse = view->inverse_focal_px;
    /* |ray| <= 1 + (width + height) / 2f */
    const int32_t half_px = ((int32_t)view->width_px + view->height_px) / 2 + 1;
    const int64_t extent_q8 = 256 + glint_shift_round64(multiply_wide_s32(half_px, inverse.m), 8 - inverse.f);
    frame->ray_fraction = (int16_t)(29 + 8 - bit_length64((uint64_t)extent_q8));
    const int shift = frame->ray_fraction - 30;
    const int32_t beyond[2] = {1 - (int32_t)view->width_px, 1 - (int32_t)view->height_px};
    for (int k = 0; k < 3; k++) {
        /* from pixel (0, 0): (1 - width) / 2 and (1 - height) / 2 steps */
        int64_t sideways = 0;
        for (int i = 0; i < 2; i++) {
            /* Q30 times m 2^-f; cut to 49 bits for the product */
            const int64_t step = multiply_wide_s32(to_view_q30[i][k], inverse.m);
            const int64_t ray_step = glint_shift_round64(step, shift - inverse.f);
            GLINT_TRACE("ray step product", step);
            GLINT_TRACE("ray step", ray_step);
            frame->ray[i + 1][k] = (int32_t)ray_step;
            sideways += (step >> 13) * beyond[i];
        }
        const int64_t across = glint_shift_round64(sideways, shift - inverse.f + 13 - 1);
        GLINT_TRACE("ray sideways", across);
        frame->ray[0][k] = (int32_t)(across + glint_shift_round64(to_view_q30[2][k], shift));
    }
}

void glint_frame_set_up(glint_frame *frame, const glint_view *view, const glint_object *object)
{
    int32_t linear_q16[3][3], to_view_q30[3][3];
    int64_t wide[3][3];
    uint64_t three_squares_q32;
    glint_linear_of(&object->place, linear_q16);
    frame->mirrored = determinant_sign(linear_q16, wide) < 0;
    frame->model_axes = keeps_angles(linear_q16, &three_squares_q32);
    if (frame->model_axes) {
        /* 1/s = sqrt(3) / sqrt(3 s^2), the square brought to 61 or 62 bits; sqrt(3) = 1859775393 / 2^30 */
        const int up = (62 - bit_length64(three_squares_q32)) & ~1;
        const glint_scaled root = glint_scaled_from(glint_square_root_u64(three_squares_q32 << up), 16 + up / 2);
        const glint_scaled inverse_root = glint_scaled_inverse(root);
        const glint_scaled inverse = glint_scaled_times(inverse_root, 1859775393u, 30);
        for (int i = 0; i < 3; i++) {
            for (int k = 0; k < 3; k++) {
                const int64_t entry =
                    glint_shift_round64(multiply_wide_s32(linear_q16[i][k], inverse.m), 30 - 16 - inverse.f);
                GLINT_TRACE("from world q30", entry);
                frame->from_world_q30[k][i] = (int32_t)entry;
                linear_q16[i][k] = (int32_t)entry; /* Q30 now: axis k of the frame in world components */
            }
        }
        product(view->basis_q30, (const int32_t(*)[3])linear_q16, wide);
        shift_matrix(wide, -30, to_view_q30);
    } else {
        normalise_rows(wide, linear_q16);
        for (int i = 0; i < 3; i++) {
            for (int k = 0; k < 3; k++) {
                linear_q16[i][k] = frame->mirrored ? -linear_q16[i][k] : linear_q16[i][k]; /* cofactors, any scale */
                frame->from_world_q30[i][k] = view->basis_q30[i][k];
                to_view_q30[i][k] = i == k ? (int32_t)1 << 30 : 0;
            }
        }
        product(view->basis_q30, (const int32_t(*)[3])linear_q16, wide);
        normalise_rows(wide, frame->normal_rows);
    }
    for (int i = 0; i < 3; i++) {
        for (int k = 0; k < 3; k++) {
            GLINT_TRACE("frame to view q30", to_view_q30[i][k]);
        }
    }
    rays_set_up(frame, view, to_view_q30);
}

void glint_placement_set_up(glint_placement *placement, const glint_frame *frame, const glint_view *view,
                            const glint_object *object)
{
    turned_place turned;
    turn_place(&turned, frame->from_world_q30, view, object);
    int bits = turned.bits[0];
    for (int i = 1; i < 3; i++) {
        bits = turned.bits[i] > bits ? turned.bits[i] : bits;
    }
    const glint_scaled inverse_near = glint_scaled_inverse(view->near_units);
    for (int i = 0; i < 3; i++) {
        turned_row(&turned, i, object, 30 - bits, placement->rows[i]);
        multiply_row(placement->rows[i], 4, inverse_near.m);
    }
    placement->fraction = (int16_t)(30 - bits + inverse_near.f - 31);
    GLINT_TRACE("placement fraction", placement->fraction);
}

void glint_light_direction(const glint_frame *frame, const glint_light *light, int32_t unit_q30[3])
{
    int64_t turned[3];
    const int32_t towards[3] = {-(int32_t)light->direction[0], -(int32_t)light->direction[1],
                                -(int32_t)light->direction[2]};
    for (int k = 0; k < 3; k++) {
        turned[k] = dot(frame->from_world_q30[k], towards);
    }
    (void)glint_unit_q30(turned, unit_q30);
}

void glint_light_position(const glint_frame *frame, const glint_view *view, const glint_light *light,
                          int32_t position[3], int16_t *fraction)
{
    int64_t turned_q46[3];
    uint64_t any = 1;
    multiply_offset(frame->from_world_q30, light->position_q16, view, turned_q46);
    for (int k = 0; k < 3; k++) {
        any |= magnitude64(turned_q46[k]);
    }
    /* times 1 / near = m 2^-f: the greatest component to 30 bits before and after */
    const glint_scaled inverse_near = glint_scaled_inverse(view->near_units);
    int shift = 30 - bit_length64(any);
    int bits = 46 + shift + inverse_near.f - 31;
    if (bits > 29) {
        shift -= bits - 29;
        bits = 29;
    }
    shift_vector(turned_q46, shift, position);
    multiply_row(position, 3, inverse_near.m);
    for (int k = 0; k < 3; k++) {
        GLINT_TRACE("light position", position[k]);
    }
    GLINT_TRACE("light position fraction", bits);
    *fraction = (int16_t)bits;
}
