/* SPDX-License-Identifier: MIT */
/*
 * glint-render --without and --explain: scenes without some of their effects, and what is told of the plan and of what
 * was evaluated.
 */
#include "render_cli.h"

#include "examples/scenes/scenes.h"

/* A scene without its effects is the scene that has their fields at zero; also turned, and drawn by the reference. */
static void effects_can_be_left_out(void **state)
{
    (void)state;
    assert_good(RUN("chrome", "-o", in_folder("a.ppm"), "--size", "64x48"));
    assert_good(RUN("chrome", "-o", in_folder("b.ppm"), "--size", "64x48", "--without", "mirror"));
    assert_different_pictures(in_folder("a.ppm"), in_folder("b.ppm"));
    /* the parts of the still life */
    assert_good(RUN("full-phong", "-o", in_folder("a.ppm"), "--size", "64x48", "--without", "specular,diffuse"));
    assert_good(RUN("full-phong", "-o", in_folder("b.ppm"), "--size", "64x48", "--without", "diffuse,specular",
                    "--turn", "360"));
    assert_equal_pictures(in_folder("a.ppm"), in_folder("b.ppm"));
    /* the yardstick with n.h is the one with r.c where nothing is specular */
    assert_good(RUN("blinn", "-o", in_folder("a.ppm"), "--size", "64x48", "--without", "specular"));
    assert_good(RUN("sphere-32x16", "-o", in_folder("b.ppm"), "--size", "64x48", "--without", "specular"));
    assert_equal_pictures(in_folder("a.ppm"), in_folder("b.ppm"));
    assert_good(
        RUN("open-sky", "-o", in_folder("a.ppm"), "--size", "64x48", "--without", "sky", "--backend", "reference"));
    static const char *const with[][2] = {
        {"source-point", "ambient"}, {"room", "diffuse"},        {"room", "specular"}, {"open-sky", "sky"},
        {"lanterns", "emission"},    {"gilded", "mirror"},       {"tiles", "texture"}, {"globe", "attenuation"},
        {"spots", "cones"},          {"panels", "extents"},      {"globe", "extents"}, {"shadows-sun", "shadows"},
        {"avenue", "fog"},           {"glass", "transmission"},  {"glass", "grazing"}, {"mesh", "wire"},
        {"bowls", "sides"},          {"lanterns", "attenuation"}};
    for (size_t i = 0; i < sizeof with / sizeof with[0]; i++) {
        assert_good(RUN(with[i][0], "-o", in_folder("a.ppm"), "--size", "64x48"));
        assert_good(RUN(with[i][0], "-o", in_folder("b.ppm"), "--size", "64x48", "--without", with[i][1]));
        assert_different_pictures(in_folder("a.ppm"), in_folder("b.ppm"));
        /* what has been taken away is not there any more */
        outcome o = RUN(with[i][0], "--explain", "--size", "64x48", "--without", with[i][1]);
        assert_int_equal(o.status, 0);
        free_outcome(&o);
    }
    assert_refused(RUN("teapot", "-o", in_folder("none.ppm"), "--without", "fog"), 2,
                   "--without fog: the scene has none of it");
    assert_refused(RUN("avenue", "-o", in_folder("none.ppm"), "--without", "fog,shadows"), 2,
                   "--without shadows: the scene has none of it");
    assert_refused(RUN("avenue", "-o", in_folder("none.ppm"), "--without", "fog,"), 2,
                   "expected one of ambient, diffuse");
    assert_refused(RUN("avenue", "-o", in_folder("none.ppm"), "--without", "mist"), 2,
                   "--without mist: expected one of ambient, diffuse");
    assert_nothing_at("none.ppm");
}

/* The plan in words: on standard output, with a picture or without one. */
static void explain_tells_reasons(void **state)
{
    (void)state;
    outcome o = RUN("spots", "--explain", "--size", "64x48");
    assert_int_equal(o.status, 0);
    assert_non_null(strstr(o.standard_output, "object 1: 960 triangles, 482 vertices"));
    assert_non_null(strstr(o.standard_output, "light 1    spot: left out: the object is outside of the light's cone"));
    assert_non_null(strstr(o.standard_output, "(no specular: the material has none of it), attenuated, in a cone"));
    assert_non_null(strstr(o.standard_output, "  2 of 3 lights\n"));
    assert_non_null(strstr(o.standard_output, "pixels shaded\n"));
    free_outcome(&o);
    o = RUN("teapot", "--explain", "-o", in_folder("explained.ppm"), "--size", "64x48");
    assert_int_equal(o.status, 0);
    assert_true(exists(in_folder("explained.ppm")));
    assert_non_null(strstr(o.standard_output, "emission   no: the material has none of it"));
    free_outcome(&o);
}

static int remove_folder(void **state)
{
    static const char *const names[] = {"a.ppm", "b.ppm", "explained.ppm", "r.json", NULL};
    (void)state;
    return remove_folder_with(names);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(effects_can_be_left_out),
        cmocka_unit_test(explain_tells_reasons),
    };
    return cmocka_run_group_tests(tests, make_folder, remove_folder);
}
