/* SPDX-License-Identifier: MIT */
/*
 * Hard cases H: processors, shared state, bad scenes. docs/hard-cases.md has the defined behaviour; hard.h the form of
 * a test.
 *
 * H1 and H3 call avr-gcc, H2 the compiler that CC names (cc when unset); objects go to the directory that GLINT_BUILD
 * names. The library itself runs on emulated processors elsewhere.
 *
 * Budgets: none.
 */
#include <sys/wait.h>

#include "examples/scenes/scenes.h"
#include "tests/hard/hard.h"

#define AVR                                                                                                            \
    "avr-gcc -mmcu=atmega1284p -std=c99 -pedantic -Wall -Wextra -Wconversion -Wshadow -Werror -Os "                    \
    "-ffreestanding -ffunction-sections -fdata-sections -ffp-contract=off -Iinclude -Isrc"

/* A command's exit status; what it prints goes to `said`. */
static int run(const char *command, char *said, size_t bytes)
{
    FILE *pipe = popen(command, "r"); /* NOLINT(cert-env33-c): runs a compiler */
    assert_non_null(pipe);
    said[fread(said, 1, bytes - 1, pipe)] = '\0';
    const int status = pclose(pipe);
    assert_true(WIFEXITED(status));
    return WEXITSTATUS(status);
}

static void write_file(const char *path, const char *content)
{
    FILE *file = fopen(path, "w");
    assert_non_null(file);
    (void)fputs(content, file);
    (void)fclose(file);
}

static bool have(const char *program)
{
    char said[1000];
    return run(text("command -v %s 2>&1", program), said, sizeof said) == 0;
}

static void test_H1_int_of_16_bits(void **state)
{
    (void)state;
    static char said[4000];
    if (!have("avr-gcc")) {
        hard_line("H1", "16-bit int", "skipped", "skipped: avr-gcc is not installed", "skip");
        skip();
    }
    /* Naive: u16 * u16 is taken in 16 bits there: 65535 * 65535 is 1. It compiles only if so. */
    char path[300];
    (void)snprintf(path, sizeof path, "%s/hard-h1.c", setting("GLINT_BUILD", "build"));
    write_file(path, "#include <stdint.h>\n"
                     "typedef char product_is_1[(uint16_t)65535 * (uint16_t)65535 == 1 ? 1 : -1];\n"
                     "typedef char int_is_short[sizeof(int) == 2 ? 1 : -1];\n");
    assert_int_equal(run(text("avr-gcc -mmcu=atmega1284p -w -c -o /dev/null %s 2>&1", path), said, sizeof said), 0);
    (void)remove(path);
    if (run("for f in $(find src -name '*.c'); do " AVR " -c -o /dev/null $f 2>&1 || exit 1; done", said,
            sizeof said)) {
        fail_msg("%s", said);
    }
    const int files = run("exit $(find src -name '*.c' | wc -l)", said, sizeof said);
    assert_true(files > 10);
    hard_pass("H1", "16-bit int", "65535 * 65535 of uint16_t is 1",
              text("%d files compile for AVR with -Wconversion as errors; the target tests run them", files));
}

/* Draws every built-in scene in both backends: compiled with the library under the sanitizer. */
static const char *const driver =
    "#include \"examples/scenes/scenes.h\"\n"
    "#include <glint/glint.h>\n"
    "static uint32_t memory[1 << 20];\n"
    "static int flush(void *c, const glint_band *b)\n{\n    (void)c;\n    (void)b;\n    return 0;\n}\n"
    "int main(void)\n{\n"
    "    for (int i = 0; i < 6 * demo_scene_count; i++) {\n"
    "        const glint_display d = {.width_px = 64, .height_px = 48, .band_px = 16, .format = (uint8_t)(i % 5),\n"
    "                                 .dither = (uint8_t)(i & 1), .flush = flush};\n"
    "        const glint_quality q = {.shading = (uint8_t)(i / demo_scene_count % 3)};\n"
    "        const glint_scene *s = demo_scenes[i % demo_scene_count].scene;\n"
    "        if (i < 3 * demo_scene_count ? glint_fixed_render(s, &d, &q, memory, sizeof memory, 0)\n"
    "                                     : glint_float_render(s, &d, &q, memory, sizeof memory, 0)) {\n"
    "            return 3;\n        }\n    }\n    return 0;\n}\n";

static void test_H2_shifts(void **state)
{
    (void)state;
    static char said[8000];
    const char *build = setting("GLINT_BUILD", "build"), *compiler = setting("CC", "cc");
    char path[300], program[300], command[1200];
    (void)snprintf(path, sizeof path, "%s/hard-h2.c", build);
    (void)snprintf(program, sizeof program, "%s/hard-h2", build);
    static const char *const naive[] = {"1u << by", "1u >> by", "-by << 1"};
    int stopped = 0;
    for (int i = 0; i < 3; i++) {
        write_file(path,
                   text("int main(void)\n{\n    volatile int by = 32;\n    volatile unsigned r = (unsigned)(%s);\n"
                        "    (void)r;\n    return 0;\n}\n",
                        naive[i]));
        (void)snprintf(command, sizeof command,
                       "%s -std=c99 -w -fsanitize=shift -fno-sanitize-recover=all -o %s %s 2>&1", compiler, program,
                       path);
        if (run(command, said, sizeof said) != 0) {
            hard_line("H2", "shift of a negative or by the width", "skipped",
                      "skipped: the compiler has no -fsanitize=shift; test-asan runs all tests under it", "skip");
            skip();
        }
        stopped += run(text("%s 2>/dev/null", program), said, sizeof said) != 0;
    }
    assert_int_equal(stopped, 3);
    write_file(path, driver);
    (void)snprintf(command, sizeof command,
                   "%s -std=c99 -w -O1 -ffp-contract=off -fsanitize=shift,signed-integer-overflow "
                   "-fno-sanitize-recover=all -Iinclude -Isrc -I. -o %s %s $(find src -name '*.c') examples/meshes/*.c "
                   "examples/scenes/*.c 2>&1",
                   compiler, program, path);
    if (run(command, said, sizeof said) != 0) {
        fail_msg("%s", said);
    }
    const int status = run(text("%s 2>&1", program), said, sizeof said);
    if (status != 0) {
        fail_msg("status %d: %s", status, said);
    }
    (void)remove(path);
    (void)remove(program);
    hard_pass("H2", "shift of a negative or by the width", text("%d of 3 stopped by the sanitizer", stopped),
              text("none in %d frames, both backends, under it; nor in the tests (test-asan)", 6 * demo_scene_count));
}

/* Bytes in sections of an object file whose names match. */
static long section_bytes(const char *object, const char *pattern)
{
    static char said[1000];
    assert_int_equal(run(text("avr-size -A %s | awk '$1 ~ /%s/ { sum += $2 } END { print sum + 0 }'", object, pattern),
                         said, sizeof said),
                     0);
    return strtol(said, NULL, 10);
}

static void test_H3_tables_on_avr(void **state)
{
    (void)state;
    static char said[4000];
    if (!have("avr-gcc") || !have("avr-size")) {
        hard_line("H3", "tables on AVR", "skipped", "skipped: avr-gcc or avr-size is not installed", "skip");
        skip();
    }
    char object[300], path[300];
    (void)snprintf(object, sizeof object, "%s/hard-h3.o", setting("GLINT_BUILD", "build"));
    (void)snprintf(path, sizeof path, "%s/hard-h3.c", setting("GLINT_BUILD", "build"));
    write_file(path, "#include <stdint.h>\nextern const uint16_t table[33];\nconst uint16_t table[33] = {1, 2, 3};\n");
    assert_int_equal(run(text(AVR " -c -o %s %s 2>&1", object, path), said, sizeof said), 0);
    const long naive = section_bytes(object, "^.(rodata|data)"); /* both are copied to RAM by the start-up code */
    assert_int_equal(naive, 66);
    assert_int_equal(run(text(AVR " -c -o %s src/number/tables.c 2>&1", object), said, sizeof said), 0);
    const long flash = section_bytes(object, "^.progmem"), ram = section_bytes(object, "^.(rodata|data|bss)");
    assert_true(flash > 200);
    assert_int_equal(ram, 0);
    long written = 0;
    (void)run("find src -name '*.c'", said, sizeof said);
    static char list[4000];
    memcpy(list, said, sizeof list);
    for (char *file = strtok(list, "\n"); file; file = strtok(NULL, "\n")) {
        static char unused[4000];
        assert_int_equal(run(text(AVR " -c -o %s %s 2>&1", object, file), unused, sizeof unused), 0);
        written += section_bytes(object, "^.(data|bss)");
    }
    assert_int_equal(written, 0);
    (void)remove(object);
    (void)remove(path);
    hard_pass("H3", "tables on AVR", text("a const table of 66 bytes takes %ld of RAM", naive),
              text("%ld bytes of tables in program memory, %ld in RAM; no writable data in any file", flash, ram));
}

/* While one frame is being sent, another is drawn, as from an interrupt. */
typedef struct interruption {
    frame *outer;
    const glint_scene *scene;
    int backend;
    uint64_t expected;
    int count;
} interruption;

static interruption interrupts;

static int interrupted_flush(void *context, const glint_band *band)
{
    frame inner = {.display = {.width_px = 40, .height_px = 30, .band_px = 7}};
    assert_int_equal(frame_draw(&inner, interrupts.scene, interrupts.backend), 0);
    assert_true(frame_hash(&inner) == interrupts.expected);
    frame_free(&inner);
    interrupts.count++;
    return frame_flush(context, band);
}

/* Naive: a routine that keeps its sum from call to call. */
static int naive_next(int start)
{
    static int sum;
    sum = start >= 0 ? start : sum + 1;
    return sum;
}

static void test_H4_two_renders_interleaved(void **state)
{
    (void)state;
    (void)naive_next(0);
    const int alone = naive_next(-1);
    (void)naive_next(0);
    (void)naive_next(100); /* the interrupt */
    const int interleaved = naive_next(-1);
    assert_true(alone != interleaved);
    static uint32_t memory[1 << 17];
    for (int n = 0; n < FRAME_BACKENDS * FRAME_BACKENDS; n++) {
        for (uint16_t i = 0; i + 1 < demo_scene_count; i++) {
            const glint_quality quality = {.shading = (uint8_t)(i % 3)};
            frame whole = {.display = {.width_px = 64, .height_px = 48, .band_px = 5}, .shading = quality.shading};
            frame inner = {.display = {.width_px = 40, .height_px = 30, .band_px = 7}};
            assert_int_equal(frame_draw(&whole, demo_scenes[i].scene, n / 2), 0);
            assert_int_equal(frame_draw(&inner, demo_scenes[i + 1].scene, n % 2), 0);
            const uint64_t expected = frame_hash(&whole);
            interrupts = (interruption){&whole, demo_scenes[i + 1].scene, n % 2, frame_hash(&inner), interrupts.count};
            memset(whole.pixels, 0, whole.bytes);
            whole.next_row = whole.bands_seen = 0;
            whole.display.flush = interrupted_flush;
            assert_int_equal(
                n / 2 == FRAME_FIXED
                    ? glint_fixed_render(demo_scenes[i].scene, &whole.display, &quality, memory, sizeof memory, NULL)
                    : glint_float_render(demo_scenes[i].scene, &whole.display, &quality, memory, sizeof memory, NULL),
                0);
            assert_true(frame_hash(&whole) == expected);
            frame_free(&whole);
            frame_free(&inner);
        }
    }
    hard_pass("H4", "two renders interleaved, or from an interrupt",
              text("a routine with a static sum gives %d instead of %d", interleaved, alone),
              text("both images as alone: %d renders within renders, each pair of backends", interrupts.count));
}

static void test_H5_bad_meshes(void **state)
{
    (void)state;
    const glint_display display = {.width_px = 16, .height_px = 16};
    int refused = 0, naive = 0;
    for (int i = 0; i < 6; i++) { /* each index of each triangle, just beyond and far beyond */
        board b;
        board_set_up(&b);
        b.triangles[i / 3][i % 3] = 4;
        naive += b.triangles[i / 3][i % 3] >= b.mesh.vertex_count;
        expect_refused(&b.scene, display, GLINT_ERROR_MESH_INDEX);
        b.triangles[i / 3][i % 3] = 65535;
        expect_refused(&b.scene, display, GLINT_ERROR_MESH_INDEX);
        refused += 2;
    }
    for (int i = 0; i < 16; i++) {
        static const int errors[16] = {
            GLINT_ERROR_MESH_EMPTY,    GLINT_ERROR_MESH_EMPTY,  GLINT_ERROR_NULL_MESH,     GLINT_ERROR_NULL_MESH,
            GLINT_ERROR_NULL_MESH,     GLINT_ERROR_NULL_MESH,   GLINT_ERROR_NULL_MATERIAL, GLINT_ERROR_NULL_OBJECTS,
            GLINT_ERROR_NULL_LIGHTS,   GLINT_ERROR_NULL_CAMERA, GLINT_ERROR_NULL_ARGUMENT, GLINT_ERROR_MESH_FRACTION,
            GLINT_ERROR_MESH_FRACTION, GLINT_ERROR_MESH_EMPTY,  GLINT_ERROR_LIGHT_KIND,    GLINT_ERROR_SPECULAR_MODEL};
        board b;
        board_set_up(&b);
        const glint_scene *scene = &b.scene;
        switch (i) {
        case 0:
            b.mesh.vertex_count = 0;
            break;
        case 1:
            b.mesh.triangle_count = 0;
            break;
        case 2:
            b.object.mesh = NULL;
            break;
        case 3:
            b.mesh.positions = NULL;
            break;
        case 4:
            b.mesh.normals_q14 = NULL;
            break;
        case 5:
            b.mesh.triangles = NULL;
            break;
        case 6:
            b.object.material = NULL;
            break;
        case 7:
            b.scene.objects = NULL;
            break;
        case 8:
            b.scene.lights = NULL;
            break;
        case 9:
            b.scene.camera = NULL;
            break;
        case 10:
            scene = NULL;
            break;
        case 11:
            b.mesh.fraction_bits = -1;
            break;
        case 12:
            b.mesh.fraction_bits = 25;
            break;
        case 13:
            b.mesh.vertex_count = 2;
            break;
        case 14:
            b.light[0].kind = GLINT_SPOT + 1;
            break;
        default:
            b.material.specular_model = 2;
            break;
        }
        expect_refused(scene, display, errors[i]);
        refused++;
    }
    hard_pass("H5", "index out of range in a mesh, count 0, NULL", text("%d indices read beyond the 4 vertices", naive),
              text("an error of its own for %d bad scenes, nothing written, flush not called", refused));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        hard_test(test_H1_int_of_16_bits),          hard_test(test_H2_shifts),     hard_test(test_H3_tables_on_avr),
        hard_test(test_H4_two_renders_interleaved), hard_test(test_H5_bad_meshes),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
