/* SPDX-License-Identifier: MIT */
/*
 * The model importer: values of small models written by hand (tests/models), and broken files. Expected numbers are
 * worked out by hand from the files and from the table in tools/import/README.md.
 */
#include "tests/unit/import_checks.h"

#include "tools/picture/picture.h"

#ifndef GLINT_HAVE_ASSIMP

static void test_without_assimp(void **state)
{
    (void)state;
    imported_scene *scene = (imported_scene *)(void *)folder;
    char error[512];
    assert_int_equal(import_scene(MODELS "cube.obj", &scene, error, sizeof error), -1);
    assert_null(scene);
    assert_non_null(strstr(error, "libassimp-dev"));
    assert_non_null(strstr(error, "built-in scenes"));
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_without_assimp)};
    return cmocka_run_group_tests(tests, make_folder, NULL);
}

#else

static void assert_material(const glint_material *material, const int codes[9], int exponent_q4, int model)
{
    assert_colour(&material->ambient, codes[0], codes[1], codes[2]);
    assert_colour(&material->diffuse, codes[3], codes[4], codes[5]);
    assert_colour(&material->specular, codes[6], codes[7], codes[8]);
    assert_int_equal(material->exponent_q4, exponent_q4);
    assert_int_equal(material->specular_model, model);
}

static void test_obj(void **state)
{
    (void)state;
    imported_scene *imported = import_or_fail(MODELS "cube.obj");
    const glint_scene *scene = imported_scene_view(imported);
    assert_sound(scene);
    assert_framed(scene);
    assert_int_equal(scene->object_count, 3);
    static const int copper[9] = {4096, 2048, 1024, 12288, 8192, 4096, 8192, 6554, 4915};
    static const int slate[9] = {1638, 3277, 4915, 6554, 8192, 9830, 0, 0, 0};
    static const int glare[9] = {0, 0, 0, 16384, 16384, 16384, 16384, 16384, 16384};
    assert_material(scene->objects[0].material, copper, 32 * 16, GLINT_PHONG);
    assert_material(scene->objects[1].material, slate, 0, GLINT_PHONG);
    assert_material(scene->objects[2].material, glare, GLINT_MAX_EXPONENT * 16, GLINT_PHONG);
    for (unsigned o = 0; o < 3; o++) {
        const glint_mesh *mesh = scene->objects[o].mesh;
        assert_int_equal(mesh->vertex_count, 8);
        assert_int_equal(mesh->triangle_count, 4);
        assert_int_equal(mesh->fraction_bits, 14); /* 1 is 16384; 32768 would not fit */
        for (unsigned v = 0; v < 8; v++) {
            for (int k = 0; k < 3; k++) {
                assert_int_equal(abs(mesh->positions[v][k]), 16384);
            }
        }
        assert_int_equal(scene->objects[o].place.linear_q16[0][0], 65536);
        assert_int_equal(scene->objects[o].place.linear_q16[0][1], 0);
        assert_int32s(scene->objects[o].place.origin_q16, 0, 0, 0);
    }
    assert_int_equal(scene->objects[0].material->transmission_q14, 0);
    assert_int_equal(scene->objects[1].material->transmission_q14, 8192);
    assert_true(warned(imported, "'slate': Ks"));
    assert_true(warned(imported, "'glare': the diffuse reflectance (1.5, 1, 1)"));
    assert_true(warned(imported, "'glare': the specular exponent 5000"));
    assert_int_equal(imported_scene_warning_count(imported), 3);

    /* no light and no camera in the file */
    assert_colour(&scene->ambient, 1638, 1638, 1638);
    assert_int_equal(scene->light_count, 1);
    assert_int_equal(scene->lights[0].kind, GLINT_DIRECTIONAL);
    assert_colour(&scene->lights[0].colour, 16384, 16384, 16384);
    assert_true(scene->lights[0].direction[1] < 0);
    assert_int_equal(scene->camera->field_of_view_turn16, 8192);

    const import_report *report = imported_scene_report(imported);
    assert_int_equal(report->vertices, 24);
    assert_int_equal(report->triangles, 12);
    assert_int_equal(report->flash_bytes, 24 * 12 + 12 * 6);
    assert_true(report->position_max_units <= 0);
    assert_true(fabs(report->radius - sqrt(3)) < 1e-12);
    imported_scene_free(imported);
}

static void test_made_normals(void **state)
{
    (void)state;
    imported_scene *imported = import_or_fail(MODELS "no-normals.obj");
    const glint_scene *scene = imported_scene_view(imported);
    assert_sound(scene);
    const glint_mesh *mesh = scene->objects[0].mesh;
    assert_int_equal(mesh->vertex_count, 9); /* the tip, and the corners once for the sides, once for the base */
    unsigned tips = 0, base = 0, corners = 0;
    for (unsigned v = 0; v < mesh->vertex_count; v++) {
        const int16_t *normal = mesh->normals_q14[v];
        if (mesh->positions[v][1]) {
            assert_direction(normal, 0, 16384, 0);
            tips++;
        } else if (normal[1] < 0) {
            assert_direction(normal, 0, -16384, 0);
            base++;
        } else { /* the mean of two sides' normals, along (1, 8, 1) up to signs */
            assert_in_range(abs(normal[0]), 2016, 2018);
            assert_in_range(abs(normal[2]), 2016, 2018);
            assert_true((normal[0] > 0) == (mesh->positions[v][0] > 0));
            corners++;
        }
    }
    assert_int_equal(tips, 1);
    assert_int_equal(base, 4);
    assert_int_equal(corners, 4);
    imported_scene_free(imported);
}

static void test_gltf(void **state)
{
    (void)state;
    imported_scene *imported = import_or_fail(MODELS "corner.gltf");
    const glint_scene *scene = imported_scene_view(imported);
    assert_sound(scene);
    assert_int_equal(scene->object_count, 2);
    assert_ptr_equal(scene->objects[0].mesh, scene->objects[1].mesh);
    assert_ptr_equal(scene->objects[0].material, scene->objects[1].material);

    /* a quarter turn about z after the scale (1, 2, 0.5); then a mirror inside a moved group */
    static const int32_t stretched[3][3] = {{0, -131072, 0}, {65536, 0, 0}, {0, 0, 32768}};
    static const int32_t mirrored[3][3] = {{-65536, 0, 0}, {0, 65536, 0}, {0, 0, 65536}};
    for (int i = 0; i < 3; i++) {
        assert_int32s(scene->objects[0].place.linear_q16[i], stretched[i][0], stretched[i][1], stretched[i][2]);
        assert_int32s(scene->objects[1].place.linear_q16[i], mirrored[i][0], mirrored[i][1], mirrored[i][2]);
    }
    assert_int32s(scene->objects[0].place.origin_q16, 1 << 16, 2 << 16, 3 << 16);
    assert_int32s(scene->objects[1].place.origin_q16, -(4 << 16), 0, 0);

    /* alpha = 2 / 0.5^4 - 2 = 30; F = 0.03 + 0.25 c; r_s = 4.75 F */
    static const int plastic[9] = {13107, 6554, 3277, 9830, 4915, 2458, 16384, 10117, 6226};
    assert_material(scene->objects[0].material, plastic, 30 * 16, GLINT_BLINN);

    /* The centre is (-2, 1.5, 1.75): the sun brings 50, the lamp 100 / 40.5625, the torch 25 / 9.3125. */
    assert_int_equal(scene->light_count, 3);
    assert_int_equal(scene->lights[0].kind, GLINT_DIRECTIONAL);
    assert_direction(scene->lights[0].direction, 0, -32767, 0);
    assert_colour(&scene->lights[0].colour, 16384, 16384, 8192);
    assert_int_equal(scene->lights[1].kind, GLINT_POINT);
    assert_int32s(scene->lights[1].position_q16, 1 << 15, 6 << 16, -(2 << 16));
    assert_arrives(&scene->lights[1], sqrt(40.5625), 404, 202, 808);
    assert_int_equal(scene->lights[2].kind, GLINT_SPOT);
    assert_arrives(&scene->lights[2], sqrt(9.3125), 880, 0, 0);
    assert_colour(&scene->ambient, 0, 0, 0);

    assert_int32s(scene->camera->eye_q16, 1 << 16, 2 << 16, 12 << 16);
    assert_int_equal(scene->camera->target_q16[0], 1 << 16);
    assert_int_equal(scene->camera->target_q16[1], 2 << 16);
    assert_true(scene->camera->target_q16[2] < 11 << 16);
    assert_direction(scene->camera->up, 0, 32767, 0);
    assert_int_equal(scene->camera->field_of_view_turn16, 8192);
    assert_in_range(scene->camera->near_q16, 1 << 15, (12 << 16) - 229376); /* the file's 0.5 .. the nearest point */
    imported_scene_free(imported);
}

static void test_collada(void **state)
{
    (void)state;
    imported_scene *imported = import_or_fail(MODELS "tile.dae");
    const glint_scene *scene = imported_scene_view(imported);
    assert_sound(scene);
    assert_int_equal(scene->object_count, 3);
    static const int gloss[9] = {1638, 3277, 4915, 8192, 4096, 2048, 12288, 8192, 4096};
    static const int chalk[9] = {4915, 4915, 4915, 9830, 9830, 9830, 0, 0, 0};
    static const int satin[9] = {0, 0, 0, 4096, 8192, 12288, 8192, 8192, 8192};
    assert_material(scene->objects[0].material, gloss, 20 * 16, GLINT_PHONG);
    assert_material(scene->objects[1].material, chalk, 0, GLINT_PHONG);
    assert_material(scene->objects[2].material, satin, 648, GLINT_BLINN);

    /* 100 units times 0.01: a matrix of 0.64 over a unit of 1/64 keeps its precision */
    static const int32_t origins[3][3] = {{0, 0, 0}, {2 << 16, 0, 0}, {0, 1 << 16, 0}};
    for (unsigned o = 0; o < 3; o++) {
        const glint_object *object = &scene->objects[o];
        assert_int32s(object->place.origin_q16, origins[o][0], origins[o][1], origins[o][2]);
        assert_int_equal(object->place.linear_q16[0][0], 41943);
        assert_int_equal(object->mesh->fraction_bits, 14);
        assert_int_equal(object->mesh->vertex_count, 4);
        for (unsigned v = 0; v < 4; v++) {
            double point[3];
            world_point(object, v, point);
            for (int k = 0; k < 3; k++) {
                double exact = object->mesh->positions[v][k] / 25600.0 + origins[o][k] / 65536.0;
                assert_true(fabs(point[k] - exact) <= 1.0 / 131072 * 25600 / 16384);
            }
        }
    }

    assert_colour(&scene->ambient, 2048, 4096, 6144);
    assert_int_equal(scene->light_count, 2);
    assert_int_equal(scene->lights[0].kind, GLINT_DIRECTIONAL);
    assert_direction(scene->lights[0].direction, 0, -32767, 0);
    assert_colour(&scene->lights[0].colour, 16384, 8192, 4096);
    assert_int_equal(scene->lights[1].kind, GLINT_POINT);
    assert_int32s(scene->lights[1].position_q16, -98304, 4 << 16, 2 << 16);
    assert_colour(&scene->lights[1].colour, 4096, 8192, 12288);

    assert_int32s(scene->camera->eye_q16, 1 << 16, 3 << 16, 0);
    int32_t down = scene->camera->target_q16[1] - (3 << 16);
    assert_int_equal(scene->camera->target_q16[0], 1 << 16);
    assert_true(down < -65536);
    assert_true(abs(down - scene->camera->target_q16[2]) <= 1);
    assert_direction(scene->camera->up, 0, 32767, -32767);
    assert_int_equal(scene->camera->field_of_view_turn16, 5461); /* 30 degrees */
    assert_int_equal(imported_scene_warning_count(imported), 0);
    imported_scene_free(imported);
}

static void test_gltf_containers(void **state)
{
    (void)state;
    static const char *const others[] = {MODELS "corner-external.gltf", MODELS "corner.glb"};
    imported_scene *embedded = import_or_fail(MODELS "corner.gltf");
    for (int i = 0; i < 2; i++) {
        imported_scene *other = import_or_fail(others[i]);
        assert_same_scene(imported_scene_view(embedded), imported_scene_view(other));
        imported_scene_free(other);
    }
    imported_scene_free(embedded);
}

static void test_broken_files(void **state)
{
    (void)state;
    static const struct {
        const char *path, *message;
    } cases[] = {
        {MODELS "corrupt-index.obj", "index out of range"},
        {MODELS "corrupt-nan.obj", "vertex 1: the position (nan, 0, 0) is not finite"},
        {MODELS "corrupt-range.obj", "vertex 1: the position (inf, 0, 0) is not finite"},
        {MODELS "no-faces.obj", "no faces"},
        {MODELS "lines.obj", "at least one triangle expected"},
        {MODELS "corrupt-json.gltf", "not a glTF 2.0 file"},
        {MODELS "corrupt-accessor.gltf", "out of range"},
        {MODELS "corrupt-index.gltf", "index out of range"},
        {MODELS "corrupt-nan.gltf", "mesh 'corner', vertex 0: the position (nan, 0, 0) is not finite"},
        {MODELS "corrupt-xml.dae", "not a COLLADA file"},
        {MODELS "empty.obj", "empty"},
        {MODELS "empty.dae", "empty"},
        {MODELS "not-there.obj", "No such file"},
        {MODELS "cube.mtl", ".obj, .gltf, .glb or .dae expected"},
        {"", ".obj, .gltf, .glb or .dae expected"},
    };
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        imported_scene *scene = (imported_scene *)(void *)folder;
        char error[1024] = "";
        assert_int_equal(import_scene(cases[i].path, &scene, error, sizeof error), -1);
        assert_null(scene);
        if (!strstr(error, cases[i].message) || strchr(error, '\n')) {
            fail_msg("%s: expected '%s' in '%s'", cases[i].path, cases[i].message, error);
        }
        /* a short buffer is not exceeded */
        char brief[8] = "1234567";
        assert_int_equal(import_scene(cases[i].path, &scene, brief, 4), -1);
        assert_int_equal(brief[3], '\0');
        assert_string_equal(brief + 4, "567");
    }
    const char *directory = scratch("directory.obj");
    mkdir(directory, 0777);
    imported_scene *scene;
    char error[1024];
    assert_int_equal(import_scene(directory, &scene, error, sizeof error), -1);
    assert_non_null(strstr(error, "directory"));
}

/* Every prefix of a good file: an error or a scene, never a crash. */
static void test_cut_files(void **state)
{
    (void)state;
    static const char *const names[] = {"cube.obj", "corner.gltf", "corner.glb", "tile.dae"};
    for (int i = 0; i < 4; i++) {
        char path[256];
        snprintf(path, sizeof path, MODELS "%s", names[i]);
        FILE *file = fopen(path, "rb");
        assert_non_null(file);
        static char bytes[1 << 14];
        size_t size = fread(bytes, 1, sizeof bytes, file);
        fclose(file);
        assert_in_range(size, 100, sizeof bytes - 1);
        char cut[64];
        snprintf(cut, sizeof cut, "cut-%s", names[i]);
        const char *output = scratch(cut);
        unsigned failed = 0;
        for (size_t length = 1; length < size; length += 37) {
            file = fopen(output, "wb");
            assert_non_null(file);
            assert_int_equal(fwrite(bytes, 1, length, file), length);
            fclose(file);
            imported_scene *scene;
            char error[1024] = "";
            if (import_scene(output, &scene, error, sizeof error)) {
                assert_true(strlen(error) > strlen(output) + 10);
                failed++;
            } else {
                assert_sound(imported_scene_view(scene));
                imported_scene_free(scene);
            }
        }
        assert_true(failed > 1);
    }
}

static void test_warnings(void **state)
{
    (void)state;
    imported_scene *imported = import_or_fail(MODELS "missing-mtl.obj");
    assert_true(warned(imported, "not-there.mtl"));
    imported_scene_free(imported);

    imported = import_or_fail(MODELS "rough.obj");
    assert_sound(imported_scene_view(imported));
    assert_true(warned(imported, "1 points and lines"));
    assert_true(warned(imported, "1 triangles without area"));
    assert_true(warned(imported, "normals of length zero"));
    assert_true(warned(imported, "1 T-junctions"));
    assert_int_equal(imported_scene_report(imported)->dropped, 1);
    assert_int_equal(imported_scene_report(imported)->t_junctions, 1);
    assert_int_equal(imported_scene_view(imported)->objects[0].mesh->triangle_count, 4);
    imported_scene_free(imported);
}

/* Copies a model with two of its texts replaced. */
static const char *edit_model(const char *path, const char *const change[2][2])
{
    static char text[1 << 14];
    FILE *file = fopen(path, "r");
    assert_non_null(file);
    text[fread(text, 1, sizeof text - 1, file)] = '\0';
    fclose(file);
    const char *output = scratch("edited.dae");
    file = create(output);
    const char *from = text;
    for (int i = 0; i < 2; i++) {
        const char *place = strstr(from, change[i][0]);
        assert_non_null(place);
        fwrite(from, 1, (size_t)(place - from), file);
        fputs(change[i][1], file);
        from = place + strlen(change[i][0]);
    }
    fputs(from, file);
    fclose(file);
    return output;
}

/* Lights brighter than the format holds are scaled together; an object without volume or area in space is left out. */
static void test_bright_and_flat(void **state)
{
    (void)state;
    static const char *const change[2][2] = {{"<color>1 0.5 0.25</color>", "<color>4 2 1</color>"},
                                             {"<scale>0.01 0.01 0.01</scale>", "<scale>0.01 0.01 0</scale>"}};
    imported_scene *imported = import_or_fail(edit_model(MODELS "tile.dae", change));
    const glint_scene *scene = imported_scene_view(imported);
    assert_sound(scene);
    assert_int_equal(scene->object_count, 2);
    assert_true(warned(imported, "node 'a': its matrix flattens the object"));
    assert_colour(&scene->lights[0].colour, 16384, 8192, 4096);
    assert_colour(&scene->lights[1].colour, 1024, 2048, 3072);
    assert_colour(&scene->ambient, 2048, 4096, 6144);
    assert_true(warned(imported, "scaled by 0.25"));
    imported_scene_free(imported);

    static const char *const infinite[2][2] = {{"<color>1 0.5 0.25</color>", "<color>1e39 2 1</color>"},
                                               {"<translate>2 0 0</translate>", "<translate>2 0 0</translate>"}};
    char error[1024] = "";
    assert_int_equal(import_scene(edit_model(MODELS "tile.dae", infinite), &imported, error, sizeof error), -1);
    assert_non_null(strstr(error, "light 'sun-node': a number is not finite"));

    static const char *const lost[2][2] = {{"<color>0.5 0.25 0.125 1</color>", "<color>nan 0 0 1</color>"},
                                           {"<translate>2 0 0</translate>", "<translate>2 0 0</translate>"}};
    assert_int_equal(import_scene(edit_model(MODELS "tile.dae", lost), &imported, error, sizeof error), -1);
    assert_non_null(strstr(error, "material 'gloss': the diffuse reflectance is not finite"));

    static const char *const away[2][2] = {{"<translate>2 0 0</translate>", "<translate>inf 0 0</translate>"},
                                           {"<translate>0 1 0</translate>", "<translate>0 1 0</translate>"}};
    assert_int_equal(import_scene(edit_model(MODELS "tile.dae", away), &imported, error, sizeof error), -1);
    assert_non_null(strstr(error, "node 'b': its matrix is not finite"));
}

/* The texture of tests/models/flag.png: 4 x 2 texels, red first. */
static void assert_flag(const glint_texture *texture)
{
    static const uint16_t colours[8] = {0xf800, 0x07e0, 0x001f, 0xffff, 0x0000, 0xffe0, 0x07ff, 0xf81f};
    assert_non_null(texture);
    assert_int_equal(texture->width_px, 4);
    assert_int_equal(texture->height_px, 2);
    assert_int_equal(texture->format, GLINT_TEXTURE_PALETTE8);
    assert_int_equal(texture->palette_count, 8);
    for (int i = 0; i < 8; i++) {
        assert_int_equal(texture->palette[((const uint8_t *)texture->texels)[i]], colours[i]);
    }
}

/* The first row is the top one: an OBJ's v = 0 is the bottom of the picture, v = 1 here. */
static void test_textures_of_obj(void **state)
{
    (void)state;
    if (!picture_has_png()) {
        skip();
    }
    imported_scene *imported = import_or_fail(MODELS "textured.obj");
    const glint_scene *scene = imported_scene_view(imported);
    assert_int_equal(scene->object_count, 3);
    const glint_mesh *mesh = scene->objects[0].mesh;
    const glint_texture *texture = scene->objects[0].material->texture;
    assert_flag(texture);
    assert_int_equal(texture->filter, GLINT_BILINEAR);
    assert_int_equal(texture->wrap_u, GLINT_REPEAT);
    assert_int_equal(mesh->texcoord_bits, 13); /* the greatest is 2 */
    for (int v = 0; v < 4; v++) {
        assert_int_equal(mesh->texcoords[v][0], mesh->positions[v][0] > 0 ? 2 << 13 : 0);
        assert_int_equal(mesh->texcoords[v][1], mesh->positions[v][1] > 0 ? 0 : 1 << 13);
    }
    assert_null(scene->objects[1].material->texture);
    assert_true(warned(imported, "nowhere.png"));
    assert_null(scene->objects[2].material->texture);
    assert_null(scene->objects[2].mesh->texcoords);
    assert_true(warned(imported, "no texture coordinates"));
    imported_scene_free(imported);
}

/* A picture within the file, its sampler, and v as glTF counts it. */
static void test_textures_of_gltf(void **state)
{
    (void)state;
    if (!picture_has_png()) {
        skip();
    }
    imported_scene *imported = import_or_fail(MODELS "textured.gltf");
    const glint_scene *scene = imported_scene_view(imported);
    const glint_mesh *mesh = scene->objects[0].mesh;
    const glint_texture *texture = scene->objects[0].material->texture;
    assert_flag(texture);
    assert_int_equal(texture->filter, GLINT_NEAREST);
    assert_int_equal(texture->wrap_u, GLINT_CLAMP);
    assert_int_equal(texture->wrap_v, GLINT_REPEAT);
    for (int v = 0; v < 4; v++) {
        assert_int_equal(mesh->texcoords[v][0], mesh->positions[v][0] > 0 ? 1 << mesh->texcoord_bits : 0);
        assert_int_equal(mesh->texcoords[v][1], mesh->positions[v][1] > 0 ? 0 : 1 << mesh->texcoord_bits);
    }
    imported_scene_free(imported);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_obj),
        cmocka_unit_test(test_made_normals),
        cmocka_unit_test(test_gltf),
        cmocka_unit_test(test_collada),
        cmocka_unit_test(test_gltf_containers),
        cmocka_unit_test(test_broken_files),
        cmocka_unit_test(test_cut_files),
        cmocka_unit_test(test_warnings),
        cmocka_unit_test(test_bright_and_flat),
        cmocka_unit_test(test_textures_of_obj),
        cmocka_unit_test(test_textures_of_gltf),
    };
    return cmocka_run_group_tests(tests, make_folder, NULL);
}

#endif
