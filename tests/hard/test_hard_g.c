/* SPDX-License-Identifier: MIT */
/*
 * Hard cases G: the float backend. docs/hard-cases.md has the defined behaviour; hard.h the form of a test.
 *
 * G3 and G5 call the compiler that CC names (cc when unset) on files in the directory that GLINT_BUILD names.
 *
 * Budgets: none.
 */
#define corner backend_corner /* a name that the tests' headers give to a variable */
#include "backend/float.c"    /* for its static functions; it takes the place of the library's own copy */
#undef corner

#include <sys/wait.h>

#include "examples/scenes/scenes.h"
#include "tests/hard/hard.h"

#if defined(__SSE2__)
#include <xmmintrin.h>
#define HAVE_FLUSH 1
#else
#define HAVE_FLUSH 0
#endif

#define FLUSH_BITS 0x8040u /* MXCSR: flush to zero, denormals are zero */

/* A compiler's or another program's exit status; what it prints goes to `said`. */
static int run(const char *command, char *said, size_t bytes)
{
    FILE *pipe = popen(command, "r"); /* NOLINT(cert-env33-c): runs a compiler */
    assert_non_null(pipe);
    said[fread(said, 1, bytes - 1, pipe)] = '\0';
    const int status = pclose(pipe);
    assert_true(WIFEXITED(status));
    return WEXITSTATUS(status);
}

/* What becomes of a triangle before it is clipped. */
static enum triangle_fate fate_of(frame_state *drawn, const object_state *object, uint16_t triangle)
{
    triangle_corners corners;
    enum triangle_fate fate;
    triangle_fetch(drawn, object, triangle, &corners);
    (void)needs_clipping(corners.screen, &fate);
    return fate;
}

static void test_G1_not_finite_in_a_vertex(void **state)
{
    (void)state;
    static const float bad[] = {NAN, INFINITY, -INFINITY};
    /* Naive: limits by comparison, which NaN passes. */
    float naive = NAN;
    naive = naive < 0.0f ? 0.0f : naive;
    naive = naive > 100.0f ? 100.0f : naive;
    assert_true(isnan(naive)); /* the column that would be written to */
    int refused = 0;
    for (size_t i = 0; i < sizeof bad / sizeof *bad; i++) {
        for (int k = 0; k < 9; k++) {
            board b;
            frame_state drawn;
            object_state object;
            light_state lights[BOARD_LIGHTS];
            board_set_up(&b);
            memset(&drawn, 0, sizeof drawn);
            glint_view_set_up(&drawn.view, &b.camera, 64, 48);
            object_prepare(&object, lights, NULL, &b.scene, 0, &drawn.view, GLINT_SHADING_EXACT);
            object.vertices = NULL;
            drawn.objects = &object;
            drawn.object_count = 1;
            assert_int_equal(fate_of(&drawn, &object, 0), TRIANGLE_DRAWN);
            /* positions are int16, so a number that is not finite can come from the place's numbers alone */
            float *const row = k / 3 == 0 ? object.transform.x : k / 3 == 1 ? object.transform.y : object.transform.z;
            row[k % 3 == 2 ? 3 : k % 3] = bad[i];
            for (uint16_t t = 0; t < 2; t++) {
                const triangle_extent extent = {false, 0, 0};
                const enum triangle_fate fate = fate_of(&drawn, &object, t);
                triangle_count(&drawn.report, fate, &extent);
                assert_int_equal(fate, TRIANGLE_REFUSED);
                refused++;
            }
            assert_int_equal(drawn.report.triangles_refused, 2);
            assert_int_equal(drawn.report.triangles_drawn, 0);
        }
        const view_vertex v[4] = {{bad[i], 0, 1}, {0, bad[i], 1}, {0, 0, bad[i]}, {0, 0, 1}};
        assert_true(!vertex_is_finite(&v[0]) && !vertex_is_finite(&v[1]) && !vertex_is_finite(&v[2]));
        assert_true(vertex_is_finite(&v[3]));
    }
    /* what a caller can hand in: the greatest valid numbers are finite, greater ones are refused */
    board b;
    const glint_display display = {.width_px = 16, .height_px = 16};
    board_set_up(&b);
    for (int k = 0; k < 3; k++) {
        b.object.place.linear_q16[k][k] = 1 << 26;
    }
    b.object.place.origin_q16[0] = 1 << 30;
    for (int backend = 0; backend < FRAME_BACKENDS; backend++) {
        frame f = hard_draw(&b.scene, 16, 16, GLINT_RGB888, GLINT_SHADING_EXACT, backend);
        assert_int_equal(f.report.triangles_refused, 0);
        frame_free(&f);
    }
    b.object.place.linear_q16[1][1] = (1 << 26) + 1;
    expect_refused(&b.scene, display, GLINT_ERROR_PLACE_RANGE);
    hard_pass("G1", "NaN or infinity in a vertex (float)", "a clamp by < and > lets NaN through to the column number",
              text("%d triangles refused and counted; no scene that validates has one", refused));
}

static void test_G2_denormals(void **state)
{
    (void)state;
#if HAVE_FLUSH
    const unsigned normal = _mm_getcsr();
    const volatile float small = 1e-38f, half = 0.25f;
    const float kept = small * half;
    _mm_setcsr(normal | FLUSH_BITS);
    const float flushed = small * half;
    _mm_setcsr(normal);
    assert_true(kept > 0.0f && !(flushed > 0.0f));
    int pictures = 0;
    for (uint16_t i = 0; i < demo_scene_count; i++) {
        for (uint8_t shading = 0; shading < HARD_SHADINGS; shading++) {
            frame plain = hard_draw(demo_scenes[i].scene, 96, 72, GLINT_RGB888, shading, FRAME_FLOAT);
            _mm_setcsr(normal | FLUSH_BITS);
            frame flush = hard_draw(demo_scenes[i].scene, 96, 72, GLINT_RGB888, shading, FRAME_FLOAT);
            _mm_setcsr(normal);
            assert_memory_equal(plain.pixels, flush.pixels, plain.bytes);
            frame_free(&plain);
            frame_free(&flush);
            pictures++;
        }
    }
    for (int round = 0; round < 200; round++) { /* the faintest light, the least vectors, the greatest distances */
        board b;
        board_set_up(&b);
        b.material.diffuse = b.material.specular = board_grey(1);
        b.material.exponent_q4 = 16384;
        b.light[0].colour = board_grey(1);
        board_normals(&b, hard_between(-1, 1), hard_between(-1, 1), hard_between(-1, 1));
        b.light[0].kind = (uint8_t)(round & 1);
        b.light[0].position_q16[2] = hard_between(0, 2);
        b.object.place = glint_scale(round % 5 + 1, round % 7 + 1, round % 3 + 1);
        b.camera.near_q16 = 64;
        frame plain = hard_draw(&b.scene, 32, 32, GLINT_RGB888, GLINT_SHADING_EXACT, FRAME_FLOAT);
        _mm_setcsr(normal | FLUSH_BITS);
        frame flush = hard_draw(&b.scene, 32, 32, GLINT_RGB888, GLINT_SHADING_EXACT, FRAME_FLOAT);
        _mm_setcsr(normal);
        assert_memory_equal(plain.pixels, flush.pixels, plain.bytes);
        frame_free(&plain);
        frame_free(&flush);
        pictures++;
    }
    hard_pass("G2", "denormals (float)",
              text("%.1e times 0.25 is %.1e or %.0f", (double)small, (double)kept, (double)flushed),
              text("%d pictures alike with and without flush to zero", pictures));
#else
    hard_line("G2", "denormals (float)", "skipped", "skipped: this processor has no SSE2 control of denormals", "skip");
#endif
}

static void test_G3_contraction(void **state)
{
    (void)state;
    static char said[400];
    int naive = 0;
    for (int round = 0; round < 100000; round++) {
        const volatile float a = (float)hard_random() * 1e-9f, b = (float)hard_random() * 1e-9f, product = a * b;
        naive += fmaf(a, b, -product) < 0.0f || fmaf(a, b, -product) > 0.0f; /* a b - a b, the latter rounded before */
    }
    assert_true(naive > 90000);
    /* the flags of this build, and what they keep out of the code on a processor that has the instruction */
    FILE *file = fopen(text("%s/library-flags", setting("GLINT_BUILD", "build")), "r");
    assert_non_null(file);
    static char flags[4000];
    flags[fread(flags, 1, sizeof flags - 1, file)] = '\0';
    (void)fclose(file);
    assert_non_null(strstr(flags, "-ffp-contract=off"));
#if defined(__x86_64__)
    int fused[2];
    for (int fast = 0; fast < 2; fast++) {
        const char *command =
            text("%s -std=gnu99 -O2 -mfma -ffp-contract=%s -Iinclude -Isrc -S -o - src/backend/float.c "
                 "| grep -c -E '\\svfn?m(add|sub)' || true",
                 setting("CC", "cc"), fast ? "fast" : "off");
        assert_int_equal(run(command, said, sizeof said), 0);
        fused[fast] = atoi(said); /* NOLINT(cert-err34-c): grep -c prints a number */
    }
    assert_true(fused[0] == 0 && fused[1] > 10);
    const char *glint =
        text("-ffp-contract=off in the flags; fused instructions in the backend: 0 (%d with fast)", fused[1]);
#else
    (void)said;
    const char *glint = "-ffp-contract=off in the flags; the code was not looked at: not x86-64";
#endif
    hard_pass("G3", "contraction to fused multiply-add", text("%d of 100000 products round otherwise", naive), glint);
}

static void test_G4_float_to_int_out_of_range(void **state)
{
    (void)state;
    static const float values[] = {3e9f, -3e9f, 1e30f, -1e30f, INFINITY, -INFINITY, NAN, 2147483648.0f, 1e-40f};
    enum { COUNT = sizeof values / sizeof *values };
    int naive = 0, checked = 0;
    for (int i = 0; i < COUNT; i++) {
        naive += !(values[i] >= -2147483648.0f && values[i] < 2147483648.0f); /* (int32_t) of these is undefined */
        for (int k = 0; k < COUNT; k++) {
            int32_t screen = 12345;
            const bool inside = project_coordinate(values[i], values[k], 1000, &screen);
            const float fine = values[i] * values[k] * (float)GLINT_FINE;
            assert_true(inside == (fine >= -5898240.0f && fine <= 5898240.0f));
            assert_true(inside || screen == 12345);
            checked++;
        }
        assert_true(light_clamp(values[i]) == (values[i] >= 1.0f ? 32768 : 0));
        assert_true(attribute_to_colour(values[i]) == (values[i] >= 1.0f ? 32768 : 0));
        checked += 2;
    }
    for (int step = -15; step < 120000; step++) {
        const float x = (float)step * 0.37f;
        assert_true(attribute_to_colour(x) <= 32768 && light_clamp(x / 30000.0f) <= 32768);
        checked += 2;
    }
    assert_true(naive >= 8);
    hard_pass("G4", "float to int out of range", text("%d of %d casts to int32_t undefined", naive, COUNT),
              text("clamped before each cast: %d calls; test-asan runs all tests with float-cast-overflow", checked));
}

static void test_G5_fast_math(void **state)
{
    (void)state;
    static char said[4000];
    const char *compiler = setting("CC", "cc");
    char path[300];
    (void)snprintf(path, sizeof path, "%s/hard-g5.c", setting("GLINT_BUILD", "build"));
    FILE *file = fopen(path, "w");
    assert_non_null(file);
    (void)fputs("int is_nan(float x);\nint is_nan(float x)\n{\n    return x != x;\n}\n", file);
    (void)fclose(file);
    /* Naive: a check that the option takes away without a word. */
    assert_int_equal(
        run(text("%s -O2 -ffast-math -S -o - %s | grep -c -i -E 'ucomis|fucomi|vcmp|fcmp|feq'", compiler, path), said,
            sizeof said),
        1); /* grep finds no comparison */
    const int plain =
        run(text("%s -O2 -S -o - %s | grep -c -i -E 'ucomis|fucomi|vcmp|fcmp|feq'", compiler, path), said, sizeof said);
    file = fopen(path, "w");
    assert_non_null(file);
    (void)fputs("#include <glint/glint.h>\ntypedef int nothing;\n", file);
    (void)fclose(file);
    assert_int_equal(run(text("%s -Iinclude -c -o /dev/null %s 2>&1", compiler, path), said, sizeof said), 0);
    assert_int_not_equal(
        run(text("%s -ffast-math -Iinclude -c -o /dev/null %s 2>&1", compiler, path), said, sizeof said), 0);
    assert_non_null(strstr(said, "does not work under -ffast-math"));
    assert_int_not_equal(run(text("%s -ffast-math -Iinclude -Isrc -c -o /dev/null src/backend/float.c 2>&1", compiler),
                             said, sizeof said),
                         0);
    assert_non_null(strstr(said, "does not work under -ffast-math"));
    (void)remove(path);
    assert_int_equal(plain, 0);
    hard_pass("G5", "-ffast-math", "x != x is compiled to no comparison at all", "does not compile, and says why");
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        hard_test(test_G1_not_finite_in_a_vertex),    hard_test(test_G2_denormals), hard_test(test_G3_contraction),
        hard_test(test_G4_float_to_int_out_of_range), hard_test(test_G5_fast_math),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
