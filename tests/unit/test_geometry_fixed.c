/* SPDX-License-Identifier: MIT */
/*
 * The fixed-point vertex stage against a projection in long double.
 */
#include "tests/unit/numeric.h"

#include "geometry/vertex_fixed.h"

/* Budgets, as geometry/vertex_fixed.h states them: four units of at most 2^-29 of the extent; 1/Z to 2^-27.9. */
#define BACKEND_ROUNDING (4 / 536870912.0L)
#define COORDINATE_UNITS 6.0L /* of the last bit, given the camera's axes as they are stored */
#define DEPTH_RELATIVE (2 / 134217728.0L)
#define ORDINARY_STEPS 8.0L /* half a sub-pixel: a vertex snaps to the neighbouring grid point at most */

#include "tests/unit/geometry_vertices.h"

static void coordinates_err_by_few_units(void **state)
{
    long double worst = 0;
    (void)state;
    for (int round = 0; round < 30000; round++) {
        vertex_scene s;
        glint_view view;
        glint_transform t;
        long double linear[3][3];
        random_scene(&s, round);
        glint_view_set_up(&view, &s.camera, s.width, s.height);
        glint_transform_set_up(&t, &view, &s.object);
        exact_linear_of(&s.object.place, linear);
        const long double focal = ldexpl(view.focal_px.m, -view.focal_px.f);
        for (int n = 0; n < 20; n++) {
            long double p[3], world[3], exact[3];
            for (int k = 0; k < 3; k++) {
                s.position[0][k] = (int16_t)(n & 1 ? random_between(-32768, 32767) : random_u32() & 1 ? 32767 : -32768);
                p[k] = ldexpl(s.position[0][k], -s.mesh.fraction_bits);
            }
            for (int i = 0; i < 3; i++) {
                world[i] = dot(linear[i], p) + ((long double)s.object.place.origin_q16[i] - view.eye_q16[i]) / 65536;
            }
            for (int i = 0; i < 3; i++) {
                const long double axis[3] = {view.basis_q30[i][0] * ULP_Q30, view.basis_q30[i][1] * ULP_Q30,
                                             view.basis_q30[i][2] * ULP_Q30};
                exact[i] = dot(axis, world);
            }
            const view_vertex v = vertex_to_view(&t, s.position[0]);
            worst = worse(worst, fabsl(v.x - ldexpl(exact[0] * focal, t.xy_fraction)));
            worst = worse(worst, fabsl(v.y - ldexpl(exact[1] * focal, t.xy_fraction)));
            worst = worse(worst, fabsl(v.z - ldexpl(exact[2], t.z_fraction)));
        }
    }
    expect_at_most("view coordinates, units", worst, COORDINATE_UNITS);
}

int main(void)
{
    const struct CMUnitTest tests[] = {numeric_test(coordinates_err_by_few_units),
                                       numeric_test(vertices_are_where_the_camera_sees_them)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
