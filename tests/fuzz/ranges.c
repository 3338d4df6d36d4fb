/* SPDX-License-Identifier: MIT */
/*
 * Draws the corpus in the checking build: every built-in scene from many sides, the fuzzer's committed inputs, random
 * extreme scenes. Ends with status 1 where a traced quantity left its documented range, or where the sanitizer spoke.
 *
 * What it is not: a proof. An interval is what was seen; spare bits are how far that is from the documented limit.
 * Without the GLINT_TRACE hook in the sources, only signed overflow, shifts, float-to-integer conversions and array
 * bounds are checked (by the sanitizer), not the narrowing of int64_t to int32_t by a cast, which is defined.
 */
#include "tests/fuzz/scene_check.h"

#include <dirent.h>

#include "examples/scenes/scenes.h"

#include "tests/fuzz/trace.h"

traced_range *traced_ranges;

#define SCENES 20000
#define SIDES 16
#define MOST_OBJECTS 64

#define TWO(n) ((int64_t)1 << (n))

/* Documented ranges: docs/formats.md, or the comment beside the quantity. Both ends are allowed. */
static const struct {
    const char *name;
    int64_t low, high;
    const char *where;
} documented[] = {
    {"camera basis q30", -TWO(30), TWO(30), "formats.md"},
    {"model to view q46", -TWO(57), TWO(57), "view.c"},
    {"origin in view q46", -TWO(62) + 1, TWO(62) - 1, "view.c"},
    {"transform entry", -TWO(30), TWO(30), "view.h"},
    {"gram q32", -3 * TWO(52), 3 * TWO(52), "view.c"},
    {"cofactor q32", -2 * TWO(52), 2 * TWO(52), "view.c"},
    {"determinant", -TWO(59) + 1, TWO(59) - 1, "view.c"},
    {"from world q30", -TWO(30) - TWO(17), TWO(30) + TWO(17), "view.c, angles kept within 2^-13"},
    {"normal row sum", 0, TWO(30) - 1, "view.h"},
    {"ray at a pixel", -TWO(30) + 1, TWO(30) - 1, "view.h"},
    {"view x y", -TWO(30) + 1, TWO(30) - 1, "vertex_fixed.h"},
    {"view z", -TWO(30) + 1, TWO(30) - 1, "vertex_fixed.h"},
    {"projection product", -TWO(61) + 1, TWO(61) - 1, "vertex_fixed.h"},
    {"screen from centre q12", -1440 * 4096, 1440 * 4096, "formats.md"},
    {"inverse depth q30", TWO(20), TWO(30) - TWO(20), "formats.md"},
    {"clip ratio q30", 0, TWO(30), "vertex_fixed.h"},
    {"placement", -TWO(30) + 1, TWO(30) - 1, "view.h"},
    {"edge step", -TWO(20) + 1, TWO(20) - 1, "edges.c"},
    {"edge part", -TWO(28) + 1, TWO(28) - 1, "edges.c"},
    {"gradient difference q12", -TWO(24) + 1, TWO(24) - 1, "gradients.c"},
    {"gradient area q24", -TWO(48) + 1, TWO(48) - 1, "gradients.c"},
    {"gradient", -TWO(30), TWO(30), "gradients.c, 2^excess with 30 - excess bits"},
    {"plane difference", -TWO(30), TWO(30), "plane.c"},
    {"plane sum", -TWO(61), TWO(61), "plane.c"},
    {"plane step", -TWO(35) + 1, TWO(35) - 1, "plane.c"},
    {"weighted normal", -TWO(29) - TWO(25), TWO(29) + TWO(25), "plane.h, a sixteenth beyond"},
    {"interpolated depth q30", 1, TWO(30) - 1, "view.h"},
    {"surface inverse", -TWO(30), TWO(30) + TWO(17) - 1, "light_fixed.h"},
    {"light times inverse", -TWO(28), TWO(28), "light_fixed.h"},
    {"light product q15", 0, 65536, "formats.md"},
    {"light sum q16", 0, TWO(30) - 1, "formats.md"},
    {"shaded colour q15", 0, 32768, "formats.md"},
    {"specular gap q31", 0, TWO(31), "formats.md"},
    {"unit vector q15", -32768, 32768, "formats.md"},
    {"unit sum of squares", TWO(28), TWO(32) - 1, "fixed.c"},
    {"power t q26", 0, TWO(31) - 1, "fixed.c"},
    {"power a t q14", 0, TWO(31) - 1, "fixed.c"},
};

/* Binary digits between the documented limit and what was seen, on the side where less is left. */
static double spare_bits(int64_t low, int64_t high, int64_t least, int64_t greatest)
{
    const double above = greatest > 0 ? log2((double)high / (double)greatest) : 64;
    const double below = least < 0 && low < 0 ? log2((double)low / (double)least) : least < 0 ? -64 : 64;
    return above < below ? above : below;
}

/* Prints the table; returns how many quantities were outside, or never seen though the build traces. */
static unsigned print_table(void)
{
    unsigned wrong = 0;
    if (traced_ranges == NULL) {
        puts(
            "ranges: the sources have no GLINT_TRACE hook: intervals are not tracked, only the sanitizer's checks ran");
        return 0;
    }
    printf("%-24s %22s %22s  %-22s %5s  %s\n", "quantity", "least seen", "greatest seen", "documented", "spare",
           "where");
    for (size_t i = 0; i < sizeof documented / sizeof *documented; i++) {
        int64_t least = INT64_MAX, greatest = INT64_MIN;
        const traced_range *r = traced_ranges;
        for (bool last = false; !last; r = r->next) { /* one entry a translation unit */
            if (strcmp(r->name, documented[i].name) == 0) {
                least = r->least < least ? r->least : least;
                greatest = r->greatest > greatest ? r->greatest : greatest;
            }
            last = r->next == r;
        }
        if (least > greatest) {
            printf("%-24s never seen\n", documented[i].name);
            wrong++;
            continue;
        }
        char limits[64];
        const bool within = least >= documented[i].low && greatest <= documented[i].high;
        (void)snprintf(limits, sizeof limits, "%s2^%.1f", documented[i].low < 0 ? "+-" : "",
                       log2(fmax((double)documented[i].high, -(double)documented[i].low)));
        printf("%-24s %22lld %22lld  %-22s %5.1f  %s%s\n", documented[i].name, (long long)least, (long long)greatest,
               limits, spare_bits(documented[i].low, documented[i].high, least, greatest), documented[i].where,
               within ? "" : "  OUTSIDE");
        wrong += !within;
    }
    return wrong;
}

static void draw_quietly(const glint_scene *scene, uint16_t width, uint16_t height, uint8_t shading)
{
    scene_case c;
    const drawing how = {.fail_at = NO_BAND, .buffer_count = 1};
    screen s = {.fail_at = NO_BAND};
    memset(&c, 0, sizeof c);
    c.display.width_px = width;
    c.display.height_px = height;
    c.display.flush = screen_flush;
    c.display.context = &s;
    c.quality.shading = shading;
    for (int backend = 0; backend < BACKENDS; backend++) {
        const size_t bytes_given = backends[backend].memory_bytes(scene, &c.display);
        void *memory = malloc(bytes_given);
        memset(&s, 0, sizeof s);
        s.display = &c.display;
        s.fail_at = how.fail_at;
        s.row_bytes = glint_row_bytes(c.display.format, width);
        s.pixels = malloc((size_t)s.row_bytes * height);
        FUZZ_CHECK(memory != NULL && s.pixels != NULL, "out of memory");
        const int result = backends[backend].render(scene, &c.display, &c.quality, memory, bytes_given, NULL);
        FUZZ_CHECK(result == 0, "%s", glint_error_text(result));
        free(s.pixels);
        free(memory);
    }
}

static unsigned draw_built_in(void)
{
    unsigned frames = 0;
    for (uint16_t i = 0; i < demo_scene_count; i++) {
        for (uint16_t side = 0; side < SIDES; side++) {
            glint_object objects[MOST_OBJECTS];
            glint_scene scene;
            FUZZ_CHECK(demo_scenes[i].scene->object_count <= MOST_OBJECTS, "%s", demo_scenes[i].name);
            FUZZ_CHECK(demo_scene_turn(demo_scenes[i].scene, (uint16_t)(side * 4099), objects, &scene) == 0, "turn");
            draw_quietly(&scene, 96, 72, (uint8_t)(side % 3));
            frames += BACKENDS;
        }
    }
    return frames;
}

static unsigned draw_corpus(const char *corpus)
{
    static uint8_t data[65536];
    unsigned inputs = 0;
    DIR *files = opendir(corpus);
    FUZZ_CHECK(files != NULL, "cannot open %s", corpus);
    for (const struct dirent *entry = readdir(files); entry != NULL; entry = readdir(files)) {
        char path[512];
        (void)snprintf(path, sizeof path, "%s/%s", corpus, entry->d_name);
        FILE *file = entry->d_name[0] == '.' ? NULL : fopen(path, "rb");
        if (file != NULL) {
            check_scene_bytes(data, fread(data, 1, sizeof data, file));
            (void)fclose(file);
            inputs++;
        }
    }
    (void)closedir(files);
    return inputs;
}

int main(void)
{
    uint64_t random = 7;
    const unsigned frames = draw_built_in();
    const unsigned inputs = draw_corpus("tests/fuzz/corpus-scene");
    for (unsigned i = 0; i < SCENES; i++) {
        uint8_t data[8];
        for (size_t k = 0; k < sizeof data; k++) {
            data[k] = (uint8_t)random_u24(&random);
        }
        check_scene_bytes(data, sizeof data);
    }
    const unsigned wrong = print_table();
    printf("ranges: %u frames of built-in scenes, %u inputs of the fuzzer, %u random scenes, both backends: no signed "
           "overflow, no bad shift, no float out of range, no index out of bounds; %u quantities outside their range\n",
           frames, inputs, (unsigned)SCENES, wrong);
    return wrong ? 1 : 0;
}
