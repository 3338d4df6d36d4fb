/* SPDX-License-Identifier: MIT */
/*
 * glint-render --without and --explain: scenes without some of their effects, and what is told of the plan and of what
 * was evaluated.
 */
#include "render_cli.h"

#include <glint/quality.h>

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

/* ----------------------------------------------------------------------------------------------------------- explain
 */

/* The number that stands before `word` on the line that begins at `line`, or 0. */
static double count_before(const char *line, const char *word)
{
    const char *end = strchr(line, '\n'), *at = strstr(line, word);
    assert_non_null(end);
    if (at == NULL || at > end) {
        return 0;
    }
    while (at > line && at[-1] >= '0' && at[-1] <= '9') {
        at--;
    }
    return strtod(at, NULL);
}

/* And the number after it. */
static double count_after(const char *line, const char *word)
{
    const char *end = strchr(line, '\n'), *at = strstr(line, word);
    assert_non_null(end);
    return at == NULL || at > end ? 0 : strtod(at + strlen(word), NULL);
}

static const char *object_line(const char *text, unsigned object)
{
    char begin[32];
    (void)snprintf(begin, sizeof begin, "\n  object %u, ", object);
    const char *line = strstr(text, begin);
    assert_non_null(line);
    return line + 1;
}

/* The line of a light below an object's, or NULL. */
static const char *light_line(const char *text, unsigned object, unsigned light)
{
    char begin[32];
    const char *line = strchr(object_line(text, object), '\n') + 1;
    (void)snprintf(begin, sizeof begin, "    light %u: ", light);
    while (strncmp(line, "    light ", strlen("    light ")) == 0) {
        if (strncmp(line, begin, strlen(begin)) == 0) {
            return line;
        }
        line = strchr(line, '\n') + 1;
    }
    return NULL;
}

/* The sum of what stands after `word` on all lines of lights. */
static double light_sum(const char *text, const char *word)
{
    double sum = 0;
    for (const char *line = strstr(text, "\n    light "); line != NULL; line = strstr(line + 1, "\n    light ")) {
        sum += count_after(line + 1, word);
    }
    return sum;
}

/* The plan in words: on standard output, with a picture or without one. */
static void explain_tells_reasons(void **state)
{
    (void)state;
    outcome o = RUN("spots", "--explain", "--size", "64x48");
    assert_int_equal(o.status, 0);
    assert_non_null(strstr(o.standard_output, "the scene: 4 objects, 3 lights\n"));
    assert_non_null(strstr(o.standard_output, "the scene has no sky, ground, emission, texture, mirror, fog, "));
    assert_non_null(strstr(o.standard_output, "\nobjects 0, 2\n  needs ambient\n"));
    assert_non_null(
        strstr(o.standard_output, "  light 1, spot: left out: the object is outside of the light's cone\n"));
    assert_non_null(strstr(o.standard_output, "  light 0, spot: diffuse and specular, attenuated, in a cone\n"));
    assert_non_null(strstr(o.standard_output, "  its material has no specular reflection\n"));
    assert_non_null(strstr(o.standard_output, "\n  object 1, 960 triangles: "));
    free_outcome(&o);
    o = RUN("avenue", "--explain", "--size", "64x48");
    assert_non_null(strstr(o.standard_output, "  no fog: the object is in front of it\n"));
    free_outcome(&o);
    o = RUN("panels", "--explain", "--size", "64x48");
    assert_non_null(strstr(o.standard_output, "panel: diffuse, as 53 point lights, which leave out "));
    free_outcome(&o);
    o = RUN("shadows-sun", "--explain", "--size", "64x48", "--shading", "flat");
    assert_non_null(strstr(o.standard_output, "shadows are left out: flat and gouraud shading"));
    assert_null(strstr(o.standard_output, "with shadows"));
    free_outcome(&o);
}

static void explaining_changes_no_pixel(void **state)
{
    static const char *const names[] = {"room", "glass", "shadows-lamps", "tiles"};
    static const char *const backends[] = {"fixed", "float"};
    (void)state;
    for (size_t i = 0; i < 2 * sizeof names / sizeof names[0]; i++) {
        assert_good(RUN(names[i / 2], "-o", in_folder("a.ppm"), "--size", "96x72", "--backend", backends[i % 2]));
        outcome o =
            RUN(names[i / 2], "-o", in_folder("b.ppm"), "--size", "96x72", "--backend", backends[i % 2], "--explain");
        assert_int_equal(o.status, 0);
        free_outcome(&o);
        assert_equal_pictures(in_folder("a.ppm"), in_folder("b.ppm"));
    }
}

/* What the observing copy counts by object comes to what the library counts of the frame; in every scene, at a
 * tolerance, exact, in bands, and where corners are lit. */
static void counts_of_objects_are_those_of_the_frame(void **state)
{
    static const char *const tiers[GLINT_TIERS] = {" unlit", " flat", " gouraud", " curved", " q1", " q2", " exact"};
    static const char *const keys[GLINT_TIERS] = {"unlit", "flat", "gouraud", "curved", "q1", "q2", "exact"};
    static const char *const ways[][4] = {{"--tolerance", "1", "--backend", "fixed"},
                                          {"--tolerance", "2", "--backend", "float"},
                                          {"--tolerance", "1", "--band", "16"},
                                          {"--shading", "exact", "--backend", "fixed"},
                                          {"--shading", "gouraud", "--backend", "float"}};
    (void)state;
    for (unsigned n = 0; n < demo_scene_count * (sizeof ways / sizeof ways[0]); n++) {
        const demo_scene *demo = &demo_scenes[n % demo_scene_count];
        const char *const *way = ways[n / demo_scene_count];
        outcome o = RUN(demo->name, "--explain", "--size", "120x90", "--report", in_folder("r.json"), way[0], way[1],
                        way[2], way[3]);
        assert_int_equal(o.status, 0);
        cJSON *report = read_report("r.json");
        const cJSON *by_tier = cJSON_GetObjectItemCaseSensitive(report, "tier_pixels");
        double pixels = 0, of_tier[GLINT_TIERS] = {0}, highlights = 0, shadowed = 0;
        for (unsigned i = 0; i < demo->scene->object_count; i++) {
            const char *line = object_line(o.standard_output, i);
            pixels += count_before(line, " pixels");
            highlights += count_after(line, "highlights on ");
            shadowed += count_before(line, " in some shadow");
            for (int tier = 0; tier < GLINT_TIERS; tier++) {
                of_tier[tier] += count_before(line, tiers[tier]);
            }
        }
        assert_true(pixels == number(report, "pixels_shaded"));
        if (way[1] != ways[4][1]) { /* corners count no pixel */
            assert_true(highlights == number(report, "pixels_specular"));
        }
        assert_true(shadowed == number(report, "pixels_shadowed"));
        assert_true(light_sum(o.standard_output, "shadows thrown by single triangles ") ==
                    number(report, "shadow_tests"));
        for (int tier = 0; tier < GLINT_TIERS; tier++) {
            assert_true(of_tier[tier] == number(by_tier, keys[tier]));
        }
        cJSON_Delete(report);
        free_outcome(&o);
    }
}

/* Where every pixel is shaded exactly, each looks at each light that the plan leaves, once for each of its points. */
static void exact_pixels_evaluate_each_light(void **state)
{
    static const struct {
        const char *scene;
        unsigned lights, points;
    } cases[] = {{"sphere-32x16", 1, 1}, {"chrome", 1, 1},       {"full-phong", 1, 1},  {"open-sky", 1, 1},
                 {"room", 3, 1},         {"lanterns", 2, 1},     {"many-lights", 8, 1}, {"exponents", 1, 1},
                 {"source-four", 4, 1},  {"source-panel", 1, 53}};
    (void)state;
    for (size_t n = 0; n < sizeof cases / sizeof cases[0]; n++) {
        outcome o = RUN(cases[n].scene, "--explain", "--size", "96x72", "--shading", "exact");
        const demo_scene *demo = demo_scene_named(cases[n].scene);
        assert_int_equal(o.status, 0);
        for (unsigned i = 0; i < demo->scene->object_count; i++) {
            const char *line = object_line(o.standard_output, i);
            double highlights = 0;
            for (unsigned k = 0; k < cases[n].lights && count_before(line, " pixels") > 0; k++) {
                const char *light = light_line(o.standard_output, i, k);
                assert_non_null(light);
                assert_true(count_after(light, "n.s ") == cases[n].points * count_before(line, " pixels"));
                highlights += count_after(light, "highlight ");
            }
            if (cases[n].lights == 1 && cases[n].points == 1) { /* then it is one a pixel */
                assert_true(highlights == count_after(line, "highlights on "));
            }
        }
        free_outcome(&o);
    }
}

/* Nearest textures read one texel a pixel, bilinear ones four; so does a mirror of the environment. */
static void texels_are_counted(void **state)
{
    static const struct {
        const char *scene;
        unsigned object;
        double a_pixel;
        const char *word;
    } cases[] = {{"tiles", 0, 1, " texels read"},    {"tiles", 1, 4, " texels read"},
                 {"tiles", 2, 0, " texels read"},    {"planet", 0, 4, " texels read"},
                 {"chrome", 0, 4, " texels of the"}, {"gilded", 1, 4, " texels of the"}};
    (void)state;
    for (size_t n = 0; n < 2 * sizeof cases / sizeof cases[0]; n++) {
        outcome o =
            RUN(cases[n / 2].scene, "--explain", "--size", "96x72", "--backend", n % 2 == 0 ? "fixed" : "float");
        const char *line = object_line(o.standard_output, cases[n / 2].object);
        assert_true(count_before(line, " pixels") > 0);
        assert_true(count_before(line, cases[n / 2].word) == cases[n / 2].a_pixel * count_before(line, " pixels"));
        free_outcome(&o);
    }
}

/* A pixel that shows a shadow is darker than without; every such pixel is among those counted. */
static void shadows_are_counted_by_light(void **state)
{
    char error[256];
    picture with = {0}, without = {0};
    double different = 0;
    (void)state;
    outcome o = RUN("shadows-sun", "--explain", "-o", in_folder("a.ppm"), "--shading", "exact");
    assert_good(RUN("shadows-sun", "-o", in_folder("b.ppm"), "--shading", "exact", "--without", "shadows"));
    assert_int_equal(picture_read(in_folder("a.ppm"), &with, error, sizeof error), 0);
    assert_int_equal(picture_read(in_folder("b.ppm"), &without, error, sizeof error), 0);
    for (int i = 0; i < with.width * with.height; i++) {
        different += memcmp(with.rgb + (size_t)i * 3, without.rgb + (size_t)i * 3, 3) != 0;
    }
    const char *frame = strstr(o.standard_output, "\nthe frame: ");
    assert_non_null(frame);
    const double counted = count_before(frame + 1, " in some shadow");
    printf("%.0f pixels differ by shadows, %.0f counted\n", different, counted);
    assert_true(different > 1000 && different <= counted);
    /* the rest faces away from the sun, or is covered later; and a pixel in the shadow of the only light looks at none
     */
    for (unsigned i = 0; i < demo_shadows_sun.object_count; i++) {
        const char *line = object_line(o.standard_output, i);
        assert_true(count_before(line, " pixels") - count_after(light_line(o.standard_output, i, 0), "n.s ") ==
                    count_before(line, " in some shadow"));
    }
    picture_free(&with);
    picture_free(&without);
    free_outcome(&o);
    o = RUN("shadows-lamps", "--explain", "--size", "96x72");
    assert_true(count_after(light_line(o.standard_output, 0, 0), "single triangles ") > 0);
    assert_true(count_after(light_line(o.standard_output, 0, 1), "single triangles ") > 0);
    assert_true(count_after(light_line(o.standard_output, 0, 2), "single triangles ") <=
                0); /* a spot that casts none */
    free_outcome(&o);
}

/* Of eight lights two reach the knot, and no pixel of it looks at another. */
static void eight_lamps_cost_two(void **state)
{
    (void)state;
    outcome o = RUN("eight-lamps", "--explain");
    const char *line = object_line(o.standard_output, 0);
    for (unsigned i = 0; i < 8; i++) {
        const char *light = light_line(o.standard_output, 0, i);
        assert_true((light != NULL) == (i == 3 || i == 4));
        if (light != NULL) {
            assert_true(count_after(light, "n.s ") == count_before(line, " pixels"));
        }
    }
    assert_non_null(
        strstr(o.standard_output, "  lights 0 to 2, point: left out: the object is beyond the light's range\n"));
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
        cmocka_unit_test(effects_can_be_left_out),          cmocka_unit_test(explain_tells_reasons),
        cmocka_unit_test(explaining_changes_no_pixel),      cmocka_unit_test(counts_of_objects_are_those_of_the_frame),
        cmocka_unit_test(exact_pixels_evaluate_each_light), cmocka_unit_test(texels_are_counted),
        cmocka_unit_test(shadows_are_counted_by_light),     cmocka_unit_test(eight_lamps_cost_two),
    };
    return cmocka_run_group_tests(tests, make_folder, remove_folder);
}
