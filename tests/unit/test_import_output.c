/* SPDX-License-Identifier: MIT */
/*
 * What the importer makes: the quantisation report against a computation of its own, parts and ranges of models that
 * are made here, and glint-import: its C source compiled and compared with the import bit by bit, its options and
 * failures.
 */
#include <dlfcn.h>
#include <sys/wait.h>

#include "tests/unit/import_checks.h"

/* glint-import itself. Returns its exit status; what it says is in `said`. */
static int run(char *said, size_t bytes, const char *arguments)
{
    char command[4096];
    const char *output = scratch("said.txt");
    snprintf(command, sizeof command, "'%s' %s > '%s' 2>&1", setting("GLINT_IMPORT", "build/glint-import"), arguments,
             output);
    int status = system(command); /* NOLINT(cert-env33-c): a test of programs */
    FILE *file = fopen(output, "r");
    assert_non_null(file);
    said[fread(said, 1, bytes - 1, file)] = '\0';
    fclose(file);
    assert_true(WIFEXITED(status));
    return WEXITSTATUS(status);
}

static bool exists(const char *path)
{
    struct stat status;
    return stat(path, &status) == 0;
}

#ifndef GLINT_HAVE_ASSIMP

/* Without assimp glint-import says what to install. */
static void test_tool_without_assimp(void **state)
{
    (void)state;
    char said[4096], arguments[2048];
    snprintf(arguments, sizeof arguments, MODELS "cube.obj -o %s", scratch("none.c"));
    assert_int_equal(run(said, sizeof said, arguments), 1);
    assert_non_null(strstr(said, "libassimp-dev"));
    assert_false(exists(scratch("none.c")));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_tool_without_assimp),
    };
    return cmocka_run_group_tests(tests, make_folder, NULL);
}

#else

/* Random triangles with normals: each vertex stays apart, in the order of the file, so errors can be found again. */
static void test_quantisation_report(void **state)
{
    (void)state;
    enum { TRIANGLES = 300 };
    static float position[3 * TRIANGLES][3], normal[3 * TRIANGLES][3];
    const char *path = scratch("random.obj");
    FILE *file = create(path);
    uint32_t random = 12345; /* the seed */
    for (int v = 0; v < 3 * TRIANGLES; v++) {
        for (int k = 0; k < 3; k++) {
            random = random * 1664525u + 1013904223u;
            position[v][k] = (float)((double)(random >> 8) / (1 << 24) * 14 - 7);
            random = random * 1664525u + 1013904223u;
            normal[v][k] = (float)((double)(random >> 8) / (1 << 24) - 0.5);
        }
        fprintf(file, "v %.9g %.9g %.9g\nvn %.9g %.9g %.9g\n", (double)position[v][0], (double)position[v][1],
                (double)position[v][2], (double)normal[v][0], (double)normal[v][1], (double)normal[v][2]);
    }
    for (int t = 0; t < TRIANGLES; t++) {
        fprintf(file, "f %d//%d %d//%d %d//%d\n", 3 * t + 1, 3 * t + 1, 3 * t + 2, 3 * t + 2, 3 * t + 3, 3 * t + 3);
    }
    fclose(file);
    imported_scene *imported = import_or_fail(path);
    const glint_mesh *mesh = imported_scene_view(imported)->objects[0].mesh;
    const import_report *report = imported_scene_report(imported);
    assert_int_equal(mesh->fraction_bits, 12); /* 7 is 28672 */
    assert_int_equal(mesh->vertex_count, 3 * TRIANGLES);

    double worst = 0, sum = 0, worst_cosine = 1, low[3] = {9, 9, 9}, high[3] = {-9, -9, -9}, diagonal = 0;
    for (int v = 0; v < 3 * TRIANGLES; v++) {
        double square = 0, dot = 0, lengths[2] = {0, 0};
        for (int k = 0; k < 3; k++) {
            double given = (double)position[v][k], error = mesh->positions[v][k] / 4096.0 - given;
            square += error * error;
            low[k] = fmin(low[k], given);
            high[k] = fmax(high[k], given);
            dot += (double)normal[v][k] * mesh->normals_q14[v][k];
            lengths[0] += (double)normal[v][k] * (double)normal[v][k];
            lengths[1] += (double)mesh->normals_q14[v][k] * mesh->normals_q14[v][k];
        }
        worst = fmax(worst, square);
        sum += square;
        worst_cosine = fmin(worst_cosine, dot / sqrt(lengths[0] * lengths[1]));
    }
    for (int k = 0; k < 3; k++) {
        diagonal += (high[k] - low[k]) * (high[k] - low[k]);
    }
    /* assimp reads decimals within an ulp of float, 5e-7 here */
    assert_true(fabs(report->position_max_units - sqrt(worst)) < 1e-6);
    assert_true(fabs(report->position_rms_units - sqrt(sum / (3 * TRIANGLES))) < 1e-6);
    assert_true(fabs(report->position_max_relative - sqrt(worst / diagonal)) < 1e-7);
    assert_true(report->position_max_units <= sqrt(3) / 2 / 4096 + 1e-6);
    assert_true(report->position_max_units > 0.25 / 4096);
    double degrees = acos(worst_cosine) * (180 / 3.14159265358979);
    assert_true(fabs(report->normal_max_degrees - degrees) < 1e-4);
    assert_true(report->normal_max_degrees < 0.00304); /* sqrt(3)/2 of a step of 2^-14 */
    imported_scene_free(imported);
}

/* A wavy field of side x side vertices: too many for one glint_mesh. */
static void test_large_mesh(void **state)
{
    (void)state;
    enum { SIDE = 300 };
    const char *path = scratch("large.obj");
    FILE *file = create(path);
    for (int y = 0; y < SIDE; y++) {
        for (int x = 0; x < SIDE; x++) {
            fprintf(file, "v %d %d %g\n", x, y, 5 * sin(x * 0.1));
        }
    }
    for (int y = 0; y + 1 < SIDE; y++) {
        for (int x = 1; x < SIDE; x++) {
            int corner = y * SIDE + x;
            fprintf(file, "f %d %d %d %d\n", corner, corner + 1, corner + 1 + SIDE, corner + SIDE);
        }
    }
    fclose(file);
    imported_scene *imported = import_or_fail(path);
    const glint_scene *scene = imported_scene_view(imported);
    assert_sound(scene);
    assert_true(scene->object_count >= 3); /* 178,802 triangles */
    unsigned long triangles = 0;
    double area = 0; /* seen from z: exact in integers */
    for (unsigned o = 0; o < scene->object_count; o++) {
        const glint_mesh *mesh = scene->objects[o].mesh;
        triangles += mesh->triangle_count;
        assert_int_equal(mesh->fraction_bits, scene->objects[0].mesh->fraction_bits);
        for (unsigned t = 0; t < mesh->triangle_count; t++) {
            const int16_t *a = mesh->positions[mesh->triangles[t][0]], *b = mesh->positions[mesh->triangles[t][1]],
                          *c = mesh->positions[mesh->triangles[t][2]];
            double twice = (double)(b[0] - a[0]) * (c[1] - a[1]) - (double)(b[1] - a[1]) * (c[0] - a[0]);
            assert_true(twice > 0);
            area += ldexp(twice / 2, -2 * mesh->fraction_bits);
        }
    }
    assert_int_equal(triangles, 2 * (SIDE - 1) * (SIDE - 1));
    assert_true(fabs(area - (SIDE - 1) * (SIDE - 1)) < 1e-6);
    assert_int_equal(imported_scene_report(imported)->triangles, triangles);
    imported_scene_free(imported);
}

/* Two triangles at a given place, one thrice as high as the other, with different materials and a common edge. */
static imported_scene *import_pair(double origin, double size)
{
    const char *path = scratch("pair.obj");
    FILE *file = create(path);
    fprintf(file, "v %.9g 0 0\nv %.9g 0 0\nv %.9g %.9g 0\nv %.9g %.9g 0\nusemtl a\nf 1 2 3\nusemtl b\nf 1 3 4\n",
            origin, origin + size, origin + size, size, origin, 3 * size);
    fclose(file);
    return import_or_fail(path);
}

static void test_ranges(void **state)
{
    (void)state;
    static const struct {
        double origin, size;
    } cases[] = {{0, 1e-6}, {0, 0.01}, {0, 1}, {1000, 1}, {0, 20000}, {0, 1e9}, {-1e9, 1e8}, {0, 1e30}};
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        imported_scene *imported = import_pair(cases[i].origin, cases[i].size);
        const glint_scene *scene = imported_scene_view(imported);
        const import_report *report = imported_scene_report(imported);
        assert_sound(scene);
        assert_framed(scene);
        assert_int_equal(scene->object_count, 2);
        /* one grid and one place, so that the common edge has the same bits on both sides */
        assert_memory_equal(&scene->objects[0].place, &scene->objects[1].place, sizeof(glint_place));
        assert_int_equal(scene->objects[0].mesh->fraction_bits, scene->objects[1].mesh->fraction_bits);
        assert_memory_equal(scene->objects[0].mesh->positions[0], scene->objects[1].mesh->positions[0], 6);
        assert_memory_equal(scene->objects[0].mesh->positions[2], scene->objects[1].mesh->positions[1], 6);
        double corners[2][3];
        for (unsigned v = 0; v < 2; v++) {
            world_point(&scene->objects[0], v, corners[v]);
        }
        /* The edge from vertex 0 to 1: half a step of the grid at each end, the rounding of the matrix, and that of the
         * file's floats, which have 24 bits for origin and size together. */
        double expected = cases[i].size * report->world_scale;
        double step = ldexp(scene->objects[0].place.linear_q16[0][0] / 65536.0, -scene->objects[0].mesh->fraction_bits);
        double tolerance = step + expected / 65536 + fabs(cases[i].origin) * report->world_scale * 1.2e-7;
        assert_true(step <= 3 * expected / 16384 + fabs(cases[i].origin) * report->world_scale * 1.2e-7);
        assert_true(fabs(corners[1][0] - corners[0][0] - expected) <= tolerance);
        assert_true(report->position_max_relative <= sqrt(3) / 2 * 3 / 16384 / sqrt(2));
        bool plain = cases[i].size >= 0.5 && cases[i].size <= 1000;
        assert_true(plain == (report->world_scale <= 1 && report->world_scale >= 1));
        imported_scene_free(imported);
    }
}

static void test_compiled_source(void **state)
{
    (void)state;
    static const char *const names[] = {"cube.obj",  "corner.gltf", "tile.dae",  "no-normals.obj", "rough.obj",
                                        "panes.obj", "panes.gltf",  "lamps.dae", "textured.obj",   "textured.gltf"};
    for (int i = 0; i < (int)(sizeof names / sizeof *names); i++) {
        char arguments[2048], said[4096], command[4096], model[256];
        snprintf(model, sizeof model, MODELS "%s", names[i]);
        snprintf(arguments, sizeof arguments, "%s -o %s/model%d.c --name model %s%s%s", model, folder, i,
                 i % 2 ? "--header " : "", i % 2 ? folder : "", i % 2 ? "/model.h" : "");
        if (run(said, sizeof said, arguments)) {
            fail_msg("%s", said);
        }
        assert_non_null(strstr(said, "position error: max "));
        assert_non_null(strstr(said, "normal error: max "));
        assert_non_null(strstr(said, " bytes of flash"));
        snprintf(
            command, sizeof command,
            "%s -std=c99 -pedantic -Wall -Wextra -Wconversion -Wmissing-declarations -Werror -Iinclude -fPIC -shared "
            "-o %s/model%d.so %s/model%d.c",
            setting("CC", "cc"), folder, i, folder, i);
        assert_int_equal(system(command), 0); /* NOLINT(cert-env33-c): a test of programs */

        char library[1024];
        snprintf(library, sizeof library, "%s%s/model%d.so", folder[0] == '/' ? "" : "./", folder, i);
        void *handle = dlopen(library, RTLD_NOW | RTLD_LOCAL);
        if (!handle) {
            fail_msg("%s", dlerror());
            return;
        }
        const glint_scene *compiled = dlsym(handle, "model_scene");
        assert_non_null(compiled);
        imported_scene *imported = import_or_fail(model);
        assert_same_scene(imported_scene_view(imported), compiled);
        imported_scene_free(imported);
        dlclose(handle);

        char first[2048];
        FILE *source = fopen(scratch("model0.c"), "r");
        assert_non_null(source);
        assert_non_null(fgets(first, sizeof first, source));
        fclose(source);
        assert_int_equal(strncmp(first, "/* glint-import tests/models/cube.obj -o ", 41), 0);
    }
}

static void test_tool_options(void **state)
{
    (void)state;
    static const struct {
        const char *arguments, *message;
    } cases[] = {
        {"", "FILE expected"},
        {MODELS "cube.obj", "-o OUT.c expected"},
        {MODELS "cube.obj -o", "a value is expected after: -o"},
        {MODELS "cube.obj -o a.c -o b.c", "given twice: -o"},
        {MODELS "cube.obj " MODELS "tile.dae -o a.c", "a second one given"},
        {MODELS "cube.obj --what -o a.c", "unknown option: --what"},
        {MODELS "cube.obj -o a.c --name 2cubes", "C identifier"},
        {MODELS "cube.obj -o a.c --name 'a b'", "C identifier"},
        {MODELS "cube.obj -o a.c --header a.c", "the same file"},
        {MODELS "cube.obj -o " MODELS "cube.obj", "would overwrite FILE"},
    };
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        char said[4096];
        assert_int_equal(run(said, sizeof said, cases[i].arguments), 2);
        if (!strstr(said, cases[i].message) || !strstr(said, "usage:")) {
            fail_msg("%s: expected '%s' in '%s'", cases[i].arguments, cases[i].message, said);
        }
        assert_false(exists("a.c"));
    }
}

static void test_tool_failures(void **state)
{
    (void)state;
    char said[4096], arguments[2048];
    const char *kept = scratch("kept.c");
    FILE *file = create(kept);
    fputs("kept\n", file);
    fclose(file);
    snprintf(arguments, sizeof arguments, MODELS "corrupt-nan.obj -o %s", kept);
    assert_int_equal(run(said, sizeof said, arguments), 1);
    assert_non_null(strstr(said, "not finite"));
    file = fopen(kept, "r");
    assert_non_null(file);
    char text[16] = "";
    assert_non_null(fgets(text, sizeof text, file));
    fclose(file);
    assert_string_equal(text, "kept\n");

    /* folders: one that is not there, and one where the file should be */
    snprintf(arguments, sizeof arguments, MODELS "cube.obj -o %s", scratch("no/folder.c"));
    assert_int_equal(run(said, sizeof said, arguments), 1);
    assert_non_null(strstr(said, "cannot write: No such file or directory"));
    mkdir(scratch("folder.c"), 0777);
    snprintf(arguments, sizeof arguments, MODELS "cube.obj -o %s", scratch("folder.c"));
    assert_int_equal(run(said, sizeof said, arguments), 1);
    assert_non_null(strstr(said, "cannot write: Is a directory"));
    assert_false(exists(scratch("folder.c.part")));

    /* a header that cannot be written leaves no source either */
    const char *source = scratch("alone.c");
    remove(source);
    snprintf(arguments, sizeof arguments, MODELS "cube.obj -o %s --header %s", source, scratch("no/alone.h"));
    assert_int_equal(run(said, sizeof said, arguments), 1);
    assert_false(exists(source));
    assert_false(exists(scratch("alone.c.part")));

    /* a full device */
    file = fopen("/dev/full", "w");
    if (file) {
        imported_scene *imported = import_or_fail(MODELS "cube.obj");
        assert_int_equal(import_write_c(file, imported_scene_view(imported), "cube", "test", NULL), -1);
        imported_scene_free(imported);
        fclose(file);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_quantisation_report),
        cmocka_unit_test(test_large_mesh),
        cmocka_unit_test(test_ranges),
        cmocka_unit_test(test_compiled_source),
        cmocka_unit_test(test_tool_options),
        cmocka_unit_test(test_tool_failures),
    };
    return cmocka_run_group_tests(tests, make_folder, NULL);
}

#endif
