/* SPDX-License-Identifier: MIT */
/*
 * Draws in the checking build: every built-in scene from many sides, the fuzzer's committed inputs, scenes made for one
 * quantity each, scenes at random and at the ends of every input's range. Then prints the interval of each quantity
 * that the library traces beside its documented range. Ends with status 1 where one left that range, where one of the
 * table was never seen, and where the sources trace one that is not in the table. The sanitizer ends it at once.
 *
 *     check-ranges [seed [scenes]]
 *
 * What it is not: a proof. An interval is what was seen; proofs of single bounds are in tests/proofs/.
 */
#include "tests/fuzz/scene_stages.h"

#include <dirent.h>

#include "examples/scenes/scenes.h"

#include "tests/fuzz/ranges_hard.h"
#include "tests/fuzz/ranges_table.h"
#include "tests/fuzz/trace.h"

#define SEED 7
#define SCENES 5000 /* of either kind of random scenes */
#define SIDES 16
#define MOST_OBJECTS 64

/* From the linker: the places of the sources that trace. */
extern traced_range *__start_glint_traced[], *__stop_glint_traced[];

/* An end of a range as a power of two, where it is near one, otherwise in full. */
static void print_end(char text[32], int64_t value)
{
    const char *sign = value < 0 ? "-" : "";
    const uint64_t size = value < 0 ? 0u - (uint64_t)value : (uint64_t)value;
    for (int factor = 1; factor <= 3; factor += 2) {
        for (int n = 14; n < 63; n++) {
            const int64_t more = (int64_t)(size - ((uint64_t)factor << n));
            if (more >= -8 && more <= 8) {
                char part[8] = "";
                if (more != 0) {
                    (void)snprintf(part, sizeof part, "%+lld", value < 0 ? -(long long)more : (long long)more);
                }
                (void)snprintf(text, 32, "%s%s2^%d%s", sign, factor == 3 ? "3 " : "", n, part);
                return;
            }
        }
    }
    (void)snprintf(text, 32, "%lld", (long long)value);
}

/* How many more bits the type has than what was seen takes. */
static double spare_bits(const documented_range *d, int64_t least, int64_t greatest)
{
    const int type_bits = d->bits < 0 ? -d->bits - 1 : d->bits;
    const double size = fmax(fmax((double)greatest, -(double)least), 1);
    return d->bits == BITS ? (double)(d->greatest - greatest) : type_bits - log2(size);
}

static bool fits_type(const documented_range *d)
{
    const double end = exp2(d->bits < 0 ? -d->bits - 1 : d->bits);
    return d->bits == BITS || ((double)d->greatest < end && (double)d->least >= (d->bits < 0 ? -end : 0));
}

/* Prints the table; returns how many quantities are not as they should be. */
static unsigned print_table(void)
{
    unsigned wrong = 0;
    printf("%-24s %20s %20s  %-24s %4s %5s  %s\n", "quantity", "least seen", "greatest seen", "documented", "type",
           "spare", "where");
    for (size_t i = 0; i < DOCUMENTED; i++) {
        const documented_range *d = &documented[i];
        int64_t least = INT64_MAX, greatest = INT64_MIN;
        char low[32], high[32], range[72], type[8];
        for (traced_range **r = __start_glint_traced; r != __stop_glint_traced; r++) {
            if (strcmp((*r)->quantity, d->quantity) == 0) {
                least = (*r)->least < least ? (*r)->least : least;
                greatest = (*r)->greatest > greatest ? (*r)->greatest : greatest;
            }
        }
        if (least > greatest) {
            printf("%-24s NEVER SEEN\n", d->quantity);
            wrong++;
            continue;
        }
        const bool good = fits_type(d) && least >= d->least && greatest <= d->greatest;
        print_end(low, d->least);
        print_end(high, d->greatest);
        (void)snprintf(range, sizeof range, "%s .. %s", low, high);
        (void)snprintf(type, sizeof type, d->bits == BITS ? "bits" : "%c%d", d->bits < 0 ? 's' : 'u', abs(d->bits));
        printf("%-24s %20lld %20lld  %-24s %4s %5.1f  %s%s\n", d->quantity, (long long)least, (long long)greatest,
               range, type, spare_bits(d, least, greatest), d->where, good ? "" : "  OUTSIDE");
        wrong += !good;
    }
    return wrong;
}

/* Names in the sources that the table does not have. */
static unsigned print_unknown(void)
{
    unsigned wrong = 0;
    for (traced_range **r = __start_glint_traced; r != __stop_glint_traced; r++) {
        size_t i = 0;
        while (i < DOCUMENTED && strcmp((*r)->quantity, documented[i].quantity) != 0) {
            i++;
        }
        if (i == DOCUMENTED) {
            printf("%-24s NOT IN THE TABLE  %s:%d\n", (*r)->quantity, (*r)->file, (*r)->line);
            wrong++;
        }
    }
    return wrong;
}

/* Draws with both backends. Returns false where the scene is refused, by both. */
static bool draw(const glint_scene *scene, const glint_display *like, const glint_quality *quality)
{
    bool drawn = false;
    for (int backend = 0; backend < BACKENDS; backend++) {
        glint_display display = *like;
        screen s = {.display = &display, .fail_at = NO_BAND};
        display.flush = screen_flush;
        display.context = &s;
        const size_t bytes_given = backends[backend].memory_bytes(scene, &display);
        const uint16_t pages = (uint16_t)((display.height_px + 7) & ~7);
        void *memory = malloc(bytes_given);
        s.row_bytes = glint_row_bytes(display.format, display.width_px);
        s.pixels = malloc((size_t)s.row_bytes * pages);
        FUZZ_CHECK(memory != NULL && s.pixels != NULL, "out of memory");
        const bool done = backends[backend].render(scene, &display, quality, memory, bytes_given, NULL) == GLINT_OK;
        FUZZ_CHECK(backend == 0 || done == drawn, "the backends do not agree on what is valid");
        drawn = done;
        free(s.pixels);
        free(memory);
    }
    return drawn;
}

static unsigned draw_built_in(void)
{
    const glint_display display = {.width_px = 96, .height_px = 72, .format = GLINT_RGB888};
    unsigned scenes = 0;
    for (uint16_t i = 0; i < demo_scene_count; i++) {
        for (uint16_t side = 0; side < SIDES; side++) {
            glint_object objects[MOST_OBJECTS];
            glint_scene scene;
            FUZZ_CHECK(demo_scenes[i].scene->object_count <= MOST_OBJECTS, "%s", demo_scenes[i].name);
            FUZZ_CHECK(demo_scene_turn(demo_scenes[i].scene, (uint16_t)(side * 4099), objects, &scene) == 0, "turn");
            FUZZ_CHECK(draw(&scene, &display, &extreme_ways[(side + i) % EXTREME_WAYS]), "%s refused",
                       demo_scenes[i].name);
            scenes++;
        }
    }
    return scenes;
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

static void random_bytes(uint64_t *random, uint8_t data[8])
{
    for (int k = 0; k < 8; k++) {
        data[k] = (uint8_t)random_u24(random);
    }
}

/* Returns how many were not refused. */
static unsigned draw_extreme(uint64_t *random, unsigned scenes)
{
    static extreme_scene e;
    unsigned drawn = 0;
    for (unsigned i = 0; i < scenes; i++) {
        uint8_t data[8];
        random_bytes(random, data);
        bytes b = bytes_from(data, sizeof data);
        const double about_q16 = take_extreme_scene(&b, &e);
        if (i & 1) {
            take_extreme_effects(&b, &e, about_q16);
        }
        drawn += draw(&e.scene, &e.display, &extreme_ways[e.way]);
    }
    return drawn;
}

/* Scenes made for one quantity each: all of them are valid. Returns their number. */
static unsigned draw_hard(uint64_t *random, unsigned scenes)
{
    static extreme_scene e;
    unsigned drawn = 0;
    for (unsigned i = 0; i < HARD_KINDS * scenes; i++) {
        uint8_t data[8];
        random_bytes(random, data);
        bytes b = bytes_from(data, sizeof data);
        if (hard_scene(&b, &e, i % HARD_KINDS, (int)(i / HARD_KINDS))) {
            FUZZ_CHECK(draw(&e.scene, &e.display, &extreme_ways[e.way]), "hard scene %u", i);
            drawn++;
        }
    }
    return drawn;
}

int main(int count, char **arguments)
{
    const uint64_t seed = count > 1 ? strtoull(arguments[1], NULL, 10) : SEED;
    const unsigned scenes = count > 2 ? (unsigned)strtoul(arguments[2], NULL, 10) : SCENES;
    uint64_t random = seed;
    printf("ranges: seed %llu, %u random scenes of each kind\n", (unsigned long long)seed, scenes);
    (void)fflush(stdout); /* before a sanitizer may end it */
    const unsigned built_in = draw_built_in();
    const unsigned inputs = draw_corpus("tests/fuzz/corpus-scene");
    unsigned extreme = draw_hard(&random, scenes);
    extreme += draw_extreme(&random, scenes);
    for (unsigned i = 0; i < scenes; i++) {
        uint8_t data[8];
        random_bytes(&random, data);
        check_scene_bytes(data, sizeof data);
    }
    const unsigned wrong = print_table() + print_unknown();
    printf("ranges: %u frames of built-in scenes, %u inputs of the fuzzer, %u random scenes, %u at the ends of what is "
           "valid; both backends: no overflow; of %u quantities %u not as documented\n",
           built_in, inputs, scenes, extreme, (unsigned)DOCUMENTED, wrong);
    return wrong ? 1 : 0;
}
