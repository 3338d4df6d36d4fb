/* SPDX-License-Identifier: MIT */
/*
 * Places, camera, focal length, lighting frames and lights against the formulas of <glint/scene.h> in long double.
 */
#include "tests/unit/geometry_world.h"

/* Budgets. Those of <glint/place.h>: */
#define TURN_ULP 0.51L /* of Q16 */
#define THEN_ULP 0.51L
/* Of <glint/scene.h>: singular where |det| < 2^-24 m^3. Cofactors are rounded, which moves the limit by 6 % at most. */
#define SINGULAR_BAND 0.06L
/* Of geometry/vertex_fixed.h: the last bit of a view coordinate, of the object's extent (times the focal length). */
#define UNIT_XY_LOG2 (-27.0L) /* of extent times focal length */
#define UNIT_Z_LOG2 (-28.0L)  /* of the extent */
/* geometry/view.h states none for these: */
#define FOCAL_RELATIVE (1 / 4194304.0L) /* 1/4096 px at 1024 px from the centre */
#define RAY_ERROR_LOG2                                                                                                 \
    (-17.0L) /* of a ray's greatest length: half a unit of 2^-29 for each of 4096 steps, and 2^-27                     \
              */
#define NORMAL_ERROR_LOG2 (-26.0L) /* of the rows' greatest length */
#define LIGHT_ULP 12.0L            /* of Q30: a unit vector turned by an axis that is another */
#define POSITION_LOG2 (-26.0L)     /* of the light's distance */

static void turns_are_rotations_counter_clockwise(void **state)
{
    long double worst = 0;
    (void)state;
    for (uint32_t angle = 0; angle < 65536; angle++) {
        const long double s = sinl(angle * PI / 32768), c = cosl(angle * PI / 32768);
        const glint_place turn[3] = {glint_turn_x((uint16_t)angle), glint_turn_y((uint16_t)angle),
                                     glint_turn_z((uint16_t)angle)};
        for (int axis = 0; axis < 3; axis++) {
            /* counter-clockwise from the tip: the next axis turns towards the one after it */
            const int i = (axis + 1) % 3, j = (axis + 2) % 3;
            long double exact[3][3] = {{0}};
            exact[axis][axis] = 1;
            exact[i][i] = exact[j][j] = c;
            exact[j][i] = s;
            exact[i][j] = -s;
            for (int k = 0; k < 9; k++) {
                worst = worse(worst, fabsl(turn[axis].linear_q16[k / 3][k % 3] - 65536 * exact[k / 3][k % 3]));
            }
            assert_true(!turn[axis].origin_q16[0] && !turn[axis].origin_q16[1] && !turn[axis].origin_q16[2]);
        }
    }
    expect_at_most("glint_turn, ulp of Q16", worst, TURN_ULP);
}

static glint_place random_bits_place(int bits)
{
    glint_place place;
    for (int i = 0; i < 9; i++) {
        place.linear_q16[i / 3][i % 3] = random_any_size(bits);
    }
    for (int k = 0; k < 3; k++) {
        place.origin_q16[k] = random_any_size(bits > 26 ? 31 : 30);
    }
    if (random_between(0, 9) == 0) {
        memset(place.linear_q16, 0, sizeof place.linear_q16);
    }
    return place;
}

/* One entry against the exact sum / 2^16 + plus, saturated. */
static long double entry_error(int32_t actual, wide sum, int32_t plus)
{
    const long double exact = (long double)sum / 65536 + plus;
    return fabsl(actual - fminl(fmaxl(exact, INT32_MIN), INT32_MAX));
}

static void places_combine_and_saturate(void **state)
{
    long double worst = 0;
    long saturated = 0;
    (void)state;
    for (int round = 0; round < 500000; round++) {
        const glint_place a = random_bits_place(round & 1 ? 31 : 20), b = random_bits_place(round & 2 ? 31 : 20);
        const glint_place ab = glint_then(&a, &b);
        int32_t la[3][3], lb[3][3];
        glint_linear_of(&a, la);
        glint_linear_of(&b, lb);
        for (int i = 0; i < 3; i++) {
            wide origin = 0;
            for (int k = 0; k < 3; k++) {
                wide sum = 0;
                for (int j = 0; j < 3; j++) {
                    sum += (wide)lb[i][j] * la[j][k];
                }
                origin += (wide)lb[i][k] * a.origin_q16[k];
                worst = worse(worst, entry_error(ab.linear_q16[i][k], sum, 0));
                saturated += ab.linear_q16[i][k] == INT32_MAX || ab.linear_q16[i][k] == INT32_MIN;
            }
            worst = worse(worst, entry_error(ab.origin_q16[i], origin, b.origin_q16[i]));
        }
    }
    assert_true(saturated > 1000);
    expect_at_most("glint_then, ulp of Q16", worst, THEN_ULP);
}

static void zero_places_are_identities(void **state)
{
    const glint_place zero = {{{0}}, {0}}, one = glint_scale(ONE_Q16, ONE_Q16, ONE_Q16);
    (void)state;
    for (int round = 0; round < 1000; round++) {
        const glint_place a = random_place(round & 1);
        const glint_place before = glint_then(&zero, &a), after = glint_then(&a, &zero);
        assert_memory_equal(&before, &a, sizeof a);
        assert_memory_equal(&after, &a, sizeof a);
    }
    const glint_place both = glint_then(&zero, &zero), shift = glint_shift(3, -4, INT32_MIN);
    assert_memory_equal(&both, &one, sizeof one);
    assert_memory_equal(shift.linear_q16, one.linear_q16, sizeof one.linear_q16);
    assert_true(shift.origin_q16[0] == 3 && shift.origin_q16[1] == -4 && shift.origin_q16[2] == INT32_MIN);
    assert_int_equal(glint_place_check(&zero), GLINT_OK);
}

/* Three columns whose determinant is near the limit: the third a mix of the others and a little. */
static void places_are_singular_below_the_limit(void **state)
{
    long counts[3] = {0};
    (void)state;
    for (int round = 0; round < 500000; round++) {
        glint_place place;
        memset(&place, 0, sizeof place);
        const int bits = random_between(2, 26);
        wide det = 0, m = 0;
        int32_t(*l)[3] = place.linear_q16;
        for (int i = 0; i < 3; i++) {
            l[i][0] = random_any_size(bits);
            l[i][1] = random_any_size(bits);
            l[i][2] = (l[i][0] - l[i][1]) / 2 + random_any_size(round % 3 == 0 ? bits - 1 : bits / 3);
        }
        for (int k = 0; k < 3; k++) {
            det += (wide)l[0][k] *
                   ((wide)l[1][(k + 1) % 3] * l[2][(k + 2) % 3] - (wide)l[1][(k + 2) % 3] * l[2][(k + 1) % 3]);
        }
        for (int i = 0; i < 9; i++) {
            m = magnitude32(l[i / 3][i % 3]) > m ? (wide)magnitude32(l[i / 3][i % 3]) : m;
        }
        if (m == 0 || m > (wide)1 << 26) {
            continue;
        }
        const long double ratio = fabsl((long double)det) / ((long double)(m * m * m) / 16777216);
        const int error = glint_place_check(&place);
        if (ratio >= 1 + SINGULAR_BAND ? error != GLINT_OK
                                       : ratio <= 1 - SINGULAR_BAND && error != GLINT_ERROR_PLACE_SINGULAR) {
            fail_msg("|det| is %.4Lf of the limit, entries up to %d: %d", ratio, (int)m, error);
        }
        counts[ratio >= 1 + SINGULAR_BAND ? 0 : ratio <= 1 - SINGULAR_BAND ? 1 : 2]++;
    }
    print_message("    %ld regular, %ld singular, %ld about the limit\n", counts[0], counts[1], counts[2]);
    assert_true(counts[0] > 1000 && counts[1] > 1000);
}

static void places_keep_their_range(void **state)
{
    const int32_t most = (int32_t)1 << 26, farthest = (int32_t)1 << 30;
    const glint_place largest = glint_scale(most, -most, most), smallest = glint_scale(1, 1, -1);
    const glint_place flat = glint_scale(most, most, 1); /* |det| is a quarter of the limit */
    (void)state;
    assert_int_equal(glint_place_check(&flat), GLINT_ERROR_PLACE_SINGULAR);
    assert_int_equal(glint_place_check(&largest), GLINT_OK);
    assert_int_equal(glint_place_check(&smallest), GLINT_OK);
    for (int i = 0; i < 9; i++) {
        glint_place place = largest;
        place.linear_q16[i / 3][i % 3] = i & 1 ? most + 1 : INT32_MIN;
        assert_int_equal(glint_place_check(&place), GLINT_ERROR_PLACE_RANGE);
    }
    for (int k = 0; k < 3; k++) {
        glint_place place = largest;
        place.origin_q16[k] = k & 1 ? farthest : -farthest;
        assert_int_equal(glint_place_check(&place), GLINT_OK);
        place.origin_q16[k] += k & 1 ? 1 : -1;
        assert_int_equal(glint_place_check(&place), GLINT_ERROR_PLACE_RANGE);
    }
}

static void cameras_are_checked(void **state)
{
    glint_camera camera;
    (void)state;
    memset(&camera, 0, sizeof camera);
    assert_int_equal(glint_camera_check(&camera), GLINT_ERROR_CAMERA_DIRECTION);
    camera.target_q16[2] = 1; /* the least distance; up by default */
    assert_int_equal(glint_camera_check(&camera), GLINT_OK);
    camera.target_q16[2] = (int32_t)1 << 30;
    camera.eye_q16[2] = -((int32_t)1 << 30);
    assert_int_equal(glint_camera_check(&camera), GLINT_OK);
    for (int sign = -1; sign <= 1; sign += 2) {
        memset(&camera, 0, sizeof camera);
        camera.target_q16[1] = sign * ONE_Q16; /* along the default up */
        assert_int_equal(glint_camera_check(&camera), GLINT_ERROR_CAMERA_UP);
        camera.up[0] = 1;
        assert_int_equal(glint_camera_check(&camera), GLINT_OK);
        camera.up[0] = 0;
        camera.up[1] = (int16_t)(sign * 32767);
        assert_int_equal(glint_camera_check(&camera), GLINT_ERROR_CAMERA_UP);
    }
    for (int round = 0; round < 10000; round++) { /* parallel, of any direction and lengths */
        memset(&camera, 0, sizeof camera);
        const int times = random_between(1, 30000) * (round & 1 ? 1 : -1);
        for (int k = 0; k < 3; k++) {
            camera.up[k] = (int16_t)(random_any_size(15) | (k == 0));
            camera.target_q16[k] = camera.up[k] * times;
        }
        assert_int_equal(glint_camera_check(&camera), GLINT_ERROR_CAMERA_UP);
    }
}

/* <glint/scene.h>: "any length". A camera that looks down steeply is as valid with a short up as with a long one. */
static void up_may_have_any_length(void **state)
{
    glint_camera camera;
    (void)state;
    for (int down = 1; down <= 1000; down++) {
        memset(&camera, 0, sizeof camera);
        camera.target_q16[1] = -down * ONE_Q16;
        camera.target_q16[2] = ONE_Q16;
        camera.up[1] = 32767;
        const int with_long = glint_camera_check(&camera);
        camera.up[1] = 1;
        const int with_short = glint_camera_check(&camera);
        if (with_long != with_short) {
            fail_msg("looking down at 1:%d, up of length 32767 gives %d, of length 1 gives %d", down, with_long,
                     with_short);
        }
    }
}

static void focal_lengths_are_those_of_the_field(void **state)
{
    static const uint16_t heights[6] = {1, 7, 64, 240, 1000, 2048};
    long double worst = 0, worst_inverse = 0;
    glint_camera camera;
    (void)state;
    memset(&camera, 0, sizeof camera);
    camera.target_q16[2] = ONE_Q16;
    camera.near_q16 = 64;
    for (int field = 182; field <= 30947; field++) {
        glint_view view;
        camera.field_of_view_turn16 = (uint16_t)field;
        const uint16_t height = heights[field % 6];
        glint_view_set_up(&view, &camera, 100, height);
        const long double exact = height / 2.0L / tanl(field * PI / 65536);
        worst = worse(worst, fabsl(ldexpl(view.focal_px.m, -view.focal_px.f) / exact - 1));
        worst_inverse =
            worse(worst_inverse, fabsl(ldexpl(view.inverse_focal_px.m, -view.inverse_focal_px.f) * exact - 1));
        assert_true(ldexpl(view.near_units.m, -view.near_units.f) == 64 / 65536.0L);
    }
    expect_at_most("focal_px, relative", worst, FOCAL_RELATIVE);
    expect_at_most("inverse_focal_px, relative", worst_inverse, FOCAL_RELATIVE);
}

typedef struct lit_world {
    glint_camera camera;
    glint_object object;
    glint_mesh mesh;
    glint_view view;
    glint_frame frame;
    exact_view exact;
    long double linear[3][3], from_world[3][3]; /* of the place; rows: the lighting frame's axes in the world */
} lit_world;

static void random_world(lit_world *w, bool uniform)
{
    memset(w, 0, sizeof *w);
    w->camera = random_camera();
    w->camera.field_of_view_turn16 = (uint16_t)random_between(2731, 30947);
    w->object.mesh = &w->mesh;
    w->object.place = random_place(uniform);
    glint_view_set_up(&w->view, &w->camera, (uint16_t)random_between(1, 2048), (uint16_t)random_between(1, 2048));
    glint_frame_set_up(&w->frame, &w->view, &w->object);
    w->exact = exact_view_of(&w->camera, w->view.height_px);
    exact_linear_of(&w->object.place, w->linear);
    long double square = 0;
    for (int i = 0; i < 9; i++) {
        square += w->linear[i / 3][i % 3] * w->linear[i / 3][i % 3] / 3;
    }
    for (int i = 0; i < 9; i++) {
        w->from_world[i / 3][i % 3] =
            w->frame.model_axes ? w->linear[i % 3][i / 3] / sqrtl(square) : w->exact.basis[i / 3][i % 3];
    }
}

static bool determinant_is_negative(long double m[3][3])
{
    long double rows[3];
    cross_product(m[1], m[2], rows);
    return dot(m[0], rows) < 0;
}

static void model_axes_are_chosen_where_angles_are_kept(void **state)
{
    long mirrored = 0, own = 0;
    (void)state;
    for (int round = 0; round < 20000; round++) {
        lit_world w;
        random_world(&w, true);
        assert_true(w.frame.model_axes);
        assert_int_equal(w.frame.mirrored, determinant_is_negative(w.linear));
        mirrored += w.frame.mirrored;
        long double r[3][3];
        random_rotation(r);
        const long double uneven[3] = {1, 1, 1.001L};
        w.object.place = place_of(r, uneven);
        glint_frame_set_up(&w.frame, &w.view, &w.object);
        assert_false(w.frame.model_axes);
        const long double even[3] = {2, 2, 2};
        w.object.place = place_of(r, even);
        for (int i = 0; i < 3; i++) { /* a shear of 1/1000 */
            w.object.place.linear_q16[i][1] += w.object.place.linear_q16[i][0] / 1000;
        }
        glint_frame_set_up(&w.frame, &w.view, &w.object);
        assert_false(w.frame.model_axes);
        random_world(&w, false);
        assert_int_equal(w.frame.mirrored, determinant_is_negative(w.linear));
        own += w.frame.model_axes;
    }
    assert_true(mirrored > 5000 && own < 100);
}

static void rays_pass_through_pixel_centres(void **state)
{
    long double worst = 0;
    (void)state;
    for (int round = 0; round < 20000; round++) {
        lit_world w;
        random_world(&w, round & 1);
        const long double reach = 1 + (w.view.width_px + w.view.height_px) / (2 * w.exact.focal);
        for (int pixel = 0; pixel < 4; pixel++) {
            const int x = pixel & 1 ? w.view.width_px - 1 : 0, y = pixel & 2 ? w.view.height_px - 1 : 0;
            const long double seen[3] = {(x + 0.5L - w.view.width_px / 2.0L) / w.exact.focal,
                                         (y + 0.5L - w.view.height_px / 2.0L) / w.exact.focal, 1};
            long double world[3];
            for (int k = 0; k < 3; k++) {
                world[k] = w.exact.basis[0][k] * seen[0] + w.exact.basis[1][k] * seen[1] + w.exact.basis[2][k];
            }
            for (int k = 0; k < 3; k++) {
                const int64_t ray =
                    (int64_t)w.frame.ray[0][k] + (int64_t)x * w.frame.ray[1][k] + (int64_t)y * w.frame.ray[2][k];
                assert_true(magnitude64(ray) < (uint64_t)1 << 30);
                worst =
                    worse(worst,
                          fabsl(ldexpl((long double)ray, -w.frame.ray_fraction) - dot(w.from_world[k], world)) / reach);
            }
        }
    }
    expect_at_most("rays, of their greatest length", worst, exp2l(RAY_ERROR_LOG2));
}

static void normals_take_the_inverse_transpose(void **state)
{
    long double worst = 0;
    (void)state;
    for (int round = 0; round < 20000; round++) {
        lit_world w;
        random_world(&w, false);
        if (w.frame.model_axes) {
            continue;
        }
        long double cofactor[3][3], rows[3][3], square = 0, product = 0;
        const int sign = w.frame.mirrored ? -1 : 1;
        for (int i = 0; i < 3; i++) {
            cross_product(w.linear[(i + 1) % 3], w.linear[(i + 2) % 3], cofactor[i]);
        }
        multiply_exactly(w.exact.basis, cofactor, rows);
        for (int i = 0; i < 9; i++) {
            square += rows[i / 3][i % 3] * rows[i / 3][i % 3];
            product += sign * rows[i / 3][i % 3] * w.frame.normal_rows[i / 3][i % 3];
        }
        assert_true(product > 0); /* the outside stays outside */
        const long double scale = product / square, length = sqrtl(square) * scale;
        for (int i = 0; i < 3; i++) {
            uint64_t sum = 0;
            for (int k = 0; k < 3; k++) {
                worst = worse(worst, fabsl(w.frame.normal_rows[i][k] - sign * scale * rows[i][k]) / length);
                sum += magnitude32(w.frame.normal_rows[i][k]);
            }
            assert_true(sum < (uint64_t)1 << 30);
        }
    }
    expect_at_most("normal_rows, of their length", worst, exp2l(NORMAL_ERROR_LOG2));
}

static void lights_are_turned_into_the_frame(void **state)
{
    long double worst = 0, worst_position = 0;
    (void)state;
    for (int round = 0; round < 50000; round++) {
        lit_world w;
        glint_light light;
        long double exact[3], offset[3], direction[3];
        int32_t unit_q30[3], position[3];
        int16_t fraction;
        random_world(&w, round & 1);
        memset(&light, 0, sizeof light);
        for (int k = 0; k < 3; k++) {
            light.direction[k] = (int16_t)(random_any_size(15) | (k == 0));
            light.position_q16[k] = random_any_size(30);
            direction[k] = -light.direction[k];
            offset[k] = light.position_q16[k] / 65536.0L - w.exact.eye[k];
        }
        glint_light_direction(&w.frame, &light, unit_q30);
        glint_light_position(&w.frame, &w.view, &light, position, &fraction);
        const long double distance = sqrtl(dot(offset, offset)) / w.exact.near;
        uint32_t greatest = 0;
        for (int k = 0; k < 3; k++) {
            exact[k] = dot(w.from_world[k], direction);
            const long double at = dot(w.from_world[k], offset) / w.exact.near;
            const long double error = fabsl(ldexpl(position[k], -fraction) - at);
            worst_position = worse(worst_position, (error - ldexpl(2, -fraction)) / distance);
            greatest = magnitude32(position[k]) > greatest ? magnitude32(position[k]) : greatest;
        }
        (void)normalise(exact);
        for (int k = 0; k < 3; k++) {
            /* the camera's axes, where they are the frame's, err more where up is uncertain */
            const long double error = fabsl(unit_q30[k] - 1073741824 * exact[k]);
            worst = worse(worst, w.frame.model_axes ? error : error * w.exact.up_sine);
        }
        assert_true(fraction <= 29 && greatest <= (uint32_t)1 << 30);
        assert_true(fraction == 29 || greatest >= (uint32_t)1 << 28); /* precision is not given away */
    }
    expect_at_most("glint_light_direction, ulp of Q30", worst, LIGHT_ULP);
    expect_at_most("glint_light_position, of its distance, less 2 units", worst_position, exp2l(POSITION_LOG2));
}

/* Rows as coarse as geometry/view.h lets them be: their last bits against the object's extent. */
static void transforms_use_their_bits(void **state)
{
    long double worst_xy = 0, worst_z = 0;
    (void)state;
    for (int round = 0; round < 50000; round++) {
        lit_world w;
        glint_transform t;
        long double extent = 0;
        random_world(&w, round & 1);
        w.mesh.fraction_bits = (int8_t)(round % 25);
        for (int k = 0; k < 3; k++) {
            w.object.place.origin_q16[k] = random_any_size(30);
        }
        glint_transform_set_up(&t, &w.view, &w.object);
        for (int corner = 0; corner < 8; corner++) {
            long double p[3], at[3];
            int64_t sums[3] = {t.x[3], t.y[3], t.z[3]};
            for (int k = 0; k < 3; k++) {
                const int32_t c = corner >> k & 1 ? 32767 : -32768;
                p[k] = ldexpl(c, -w.mesh.fraction_bits);
                sums[0] += ((int64_t)t.x[k] * c) >> 16;
                sums[1] += ((int64_t)t.y[k] * c) >> 16;
                sums[2] += ((int64_t)t.z[k] * c) >> 16;
            }
            for (int i = 0; i < 3; i++) {
                assert_true(magnitude64(sums[i]) < (uint64_t)1 << 30);
                at[i] = dot(w.linear[i], p) + w.object.place.origin_q16[i] / 65536.0L - w.exact.eye[i];
            }
            extent = fmaxl(extent, sqrtl(dot(at, at)));
        }
        worst_xy = worse(worst_xy, ldexpl(1, -t.xy_fraction) / (extent * w.exact.focal));
        worst_z = worse(worst_z, ldexpl(1, -t.z_fraction) / extent);
        assert_true(t.near_z >= 1);
    }
    print_message("    last bits: 2^%.2Lf and 2^%.2Lf of the extent\n", log2l(worst_xy), log2l(worst_z));
    expect_at_most("last bit of X and Y, of extent times focal", worst_xy, exp2l(UNIT_XY_LOG2));
    expect_at_most("last bit of Z, of extent", worst_z, exp2l(UNIT_Z_LOG2));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        numeric_test(turns_are_rotations_counter_clockwise),
        numeric_test(places_combine_and_saturate),
        numeric_test(zero_places_are_identities),
        numeric_test(places_are_singular_below_the_limit),
        numeric_test(places_keep_their_range),
        numeric_test(cameras_are_checked),
        numeric_test(up_may_have_any_length),
        numeric_test(focal_lengths_are_those_of_the_field),
        numeric_test(model_axes_are_chosen_where_angles_are_kept),
        numeric_test(rays_pass_through_pixel_centres),
        numeric_test(normals_take_the_inverse_transpose),
        numeric_test(lights_are_turned_into_the_frame),
        numeric_test(transforms_use_their_bits),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
