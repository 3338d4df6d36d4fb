/* SPDX-License-Identifier: MIT */
/*
 * The plan is the one that the renderer makes of each object and does, asked for once more; the counts are of what it
 * evaluated. What the whole scene has none of is told once, and objects whose plan reads the same are told together.
 */
#include "explain.h"

#include <inttypes.h>
#include <stdbool.h>
#include <stdlib.h>
#include <string.h>

#include <glint/plan.h>

#include "options.h"

/* The parts of an object's plan that no light has to do with, as they are told. */
enum { AMBIENT, SKY, GROUND, EMISSION, TEXTURE, MIRROR, FOG, TRANSMISSION, GRAZING, WIRE, TERM_COUNT };
static const char *const term_words[TERM_COUNT] = {
    [AMBIENT] = "ambient",        [SKY] = "sky",       [GROUND] = "ground", [EMISSION] = "emission",
    [TEXTURE] = "texture",        [MIRROR] = "mirror", [FOG] = "fog",       [TRANSMISSION] = "transmission",
    [GRAZING] = "grazing colour", [WIRE] = "wire",
};

static void reasons_of(const glint_object_plan *plan, uint8_t reason[TERM_COUNT])
{
    reason[AMBIENT] = plan->ambient;
    reason[SKY] = plan->sky;
    reason[GROUND] = plan->ground;
    reason[EMISSION] = plan->emission;
    reason[TEXTURE] = plan->texture;
    reason[MIRROR] = plan->mirror;
    reason[FOG] = plan->fog;
    reason[TRANSMISSION] = plan->transmission;
    reason[GRAZING] = plan->grazing;
    reason[WIRE] = plan->wire;
}

static bool is_black(const glint_colour *colour)
{
    return (colour->r_q14 | colour->g_q14 | colour->b_q14) == 0;
}

/* Words with commas between. */
typedef struct list {
    FILE *file;
    const char *begin, *end; /* written before the first word and after the last */
    unsigned count;
} list;

static void list_add(list *l, const char *word)
{
    fprintf(l->file, "%s%s", l->count++ == 0 ? l->begin : ", ", word);
}

static void list_end(const list *l)
{
    if (l->count > 0) {
        fputs(l->end, l->file);
    }
}

/* ---------------------------------------------------------------------------------------------------------- the scene
 */

/* What the scene has none of: that no object needs, and not because of where it stands. */
static void find_absent(const glint_scene *scene, bool absent[TERM_COUNT])
{
    for (int term = 0; term < TERM_COUNT; term++) {
        absent[term] = true;
    }
    absent[AMBIENT] = is_black(&scene->ambient);
    absent[SKY] = is_black(&scene->sky);
    absent[GROUND] = is_black(&scene->ground);
    for (uint16_t i = 0; i < scene->object_count; i++) {
        uint8_t reason[TERM_COUNT];
        glint_object_plan plan;
        glint_plan_object(scene, i, &plan);
        reasons_of(&plan, reason);
        for (int term = EMISSION; term < TERM_COUNT; term++) {
            absent[term] =
                absent[term] && (reason[term] == GLINT_REFLECTANCE_ZERO || reason[term] == GLINT_NOT_IN_SCENE);
        }
    }
}

static bool any_casts(const glint_scene *scene)
{
    bool any = false;
    for (uint16_t i = 0; i < scene->light_count; i++) {
        any = any || scene->lights[i].casts_shadows;
    }
    return any;
}

static bool lights_corners(const glint_quality *quality)
{
    return quality->shading == GLINT_SHADING_GOURAUD || quality->shading == GLINT_SHADING_FLAT;
}

static void explain_scene(FILE *file, const glint_scene *scene, const glint_quality *quality,
                          const bool absent[TERM_COUNT])
{
    list none = {file, "the scene has no ", "\n", 0};
    fprintf(file, "the scene: %u object%s, %u light%s\n", (unsigned)scene->object_count,
            scene->object_count == 1 ? "" : "s", (unsigned)scene->light_count, scene->light_count == 1 ? "" : "s");
    for (int term = 0; term < TERM_COUNT; term++) {
        if (absent[term]) {
            list_add(&none, term_words[term]);
        }
    }
    if (!any_casts(scene)) {
        list_add(&none, "shadows");
    }
    list_end(&none);
    if (any_casts(scene) && lights_corners(quality)) {
        fprintf(file, "shadows are left out: flat and gouraud shading light corners and centroids, not pixels\n");
    }
}

/* ------------------------------------------------------------------------------------------------------------ the plan
 */

static const char *kind_word(const glint_light *light)
{
    static const char *const words[] = {"directional", "point", "spot", "panel", "ball"};
    return words[light->kind];
}

/* What of a light is there for an object, or why nothing is. */
static void write_light(FILE *file, const glint_scene *scene, const glint_quality *quality, uint16_t object,
                        const glint_object_plan *of_object, uint16_t number)
{
    const glint_light *const light = &scene->lights[number];
    const glint_material *const material = scene->objects[object].material;
    glint_light_plan plan;
    glint_plan_light(scene, object, of_object, number, &plan);
    const bool diffuse = plan.diffuse == GLINT_NEEDED, specular = plan.specular == GLINT_NEEDED;
    fprintf(file, "%s: ", kind_word(light));
    if (!diffuse && !specular) { /* that the material has not got the one or the other has been told */
        const bool same = plan.diffuse == plan.specular || is_black(&material->specular);
        fprintf(file, "left out: %s", glint_reason_text(is_black(&material->diffuse) ? plan.specular : plan.diffuse));
        if (!same && !is_black(&material->diffuse)) {
            fprintf(file, "; its highlight: %s", glint_reason_text(plan.specular));
        }
        return;
    }
    fprintf(file, "%s%s%s", diffuse ? "diffuse" : "", diffuse && specular ? " and " : "", specular ? "specular" : "");
    if (!diffuse && !is_black(&material->diffuse)) {
        fprintf(file, " (not diffuse: %s)", glint_reason_text(plan.diffuse));
    }
    if (!specular && !is_black(&material->specular)) {
        fprintf(file, " (not specular: %s)", glint_reason_text(plan.specular));
    }
    if (light->kind == GLINT_PANEL || light->kind == GLINT_BALL) {
        glint_source_plan source;
        glint_plan_source(scene, object, of_object, number, &plan, glint_plan_room_q8(scene, quality->tolerance),
                          &source);
        fprintf(file, ", as %u point light%s, which leave%s out %.2f codes at most%s", (unsigned)source.points,
                source.points == 1 ? "" : "s", source.points == 1 ? "s" : "", source.error_q8 / 256.0,
                source.enough ? "" : ", more than the tolerance has room for: `samples` allows no more");
    }
    fprintf(file, "%s%s", plan.attenuation ? ", attenuated" : "", plan.cone ? ", in a cone" : "");
    if (light->casts_shadows && !lights_corners(quality)) {
        fprintf(file, plan.shadow == GLINT_NEEDED ? ", with shadows" : ", without shadows: %s",
                glint_reason_text(plan.shadow));
    }
}

/* The same as a string to free, or NULL. */
static char *light_text(const glint_scene *scene, const glint_quality *quality, uint16_t object,
                        const glint_object_plan *of_object, uint16_t number)
{
    char *text = NULL;
    size_t bytes = 0;
    FILE *file = open_memstream(&text, &bytes);
    if (file != NULL) {
        write_light(file, scene, quality, object, of_object, number);
        (void)fclose(file);
    }
    return text;
}

/* Lights of which the same is to be told, one after the other, in one line. */
static int write_lights(FILE *file, const glint_scene *scene, const glint_quality *quality, uint16_t object,
                        const glint_object_plan *of_object)
{
    uint16_t first = 0;
    while (first < scene->light_count) {
        char *text = light_text(scene, quality, object, of_object, first), *other = NULL;
        uint16_t last = first;
        while (text != NULL && last + 1 < scene->light_count &&
               (other = light_text(scene, quality, object, of_object, (uint16_t)(last + 1))) != NULL &&
               strcmp(text, other) == 0) {
            free(other);
            other = NULL;
            last++;
        }
        if (text == NULL || (other == NULL && last + 1 < scene->light_count)) {
            free(text);
            return -1;
        }
        if (first == last) {
            fprintf(file, "  light %u, %s\n", (unsigned)first, text);
        } else {
            fprintf(file, "  lights %u to %u, %s\n", (unsigned)first, (unsigned)last, text);
        }
        free(other);
        free(text);
        first = (uint16_t)(last + 1);
    }
    return 0;
}

static int write_plan(FILE *file, const glint_scene *scene, const glint_quality *quality, uint16_t object,
                      const bool absent[TERM_COUNT])
{
    const glint_material *const material = scene->objects[object].material;
    glint_object_plan plan;
    uint8_t reason[TERM_COUNT];
    list needs = {file, "  needs ", "\n", 0}, lacks = {file, "  its material has no ", "\n", 0};
    glint_plan_object(scene, object, &plan);
    reasons_of(&plan, reason);
    for (int term = 0; term < TERM_COUNT; term++) {
        if (reason[term] == GLINT_NEEDED) {
            list_add(&needs, term_words[term]);
        }
    }
    list_end(&needs);
    if (is_black(&material->ambient) && !(absent[AMBIENT] && absent[SKY] && absent[GROUND])) {
        list_add(&lacks, "ambient reflection");
    }
    if (is_black(&material->diffuse)) {
        list_add(&lacks, "diffuse reflection");
    }
    if (is_black(&material->specular)) {
        list_add(&lacks, "specular reflection");
    }
    for (int term = EMISSION; term < TERM_COUNT; term++) {
        if (!absent[term] && reason[term] == GLINT_REFLECTANCE_ZERO) {
            list_add(&lacks, term_words[term]);
        }
    }
    list_end(&lacks);
    for (int term = 0; term < TERM_COUNT; term++) {
        if (!absent[term] && reason[term] != GLINT_NEEDED && reason[term] != GLINT_REFLECTANCE_ZERO) {
            fprintf(file, "  no %s: %s\n", term_words[term], glint_reason_text(reason[term]));
        }
    }
    if (is_black(&material->diffuse) && is_black(&material->specular)) {
        fprintf(file, "  no light adds anything\n");
        return 0;
    }
    return write_lights(file, scene, quality, object, &plan);
}

/* ------------------------------------------------------------------------------------------------------------- counts
 */

/* More objects than this with one plan do not tell of each light apart. */
#define MOST_APART 12

/* How many objects from `first` on have a plan that reads as its does. */
static unsigned alike(char *const *plans, uint16_t first, uint16_t count)
{
    unsigned same = 0;
    for (uint16_t i = first; i < count; i++) {
        same += strcmp(plans[i], plans[first]) == 0;
    }
    return same;
}

/* Adds a number, if it is not 0, with words before and after it; these end in a plural's s, unless the number is 1. */
static void write_count(list *l, const char *before, uint64_t count, const char *after)
{
    char text[96];
    const int length = (int)strlen(after);
    const bool plural = length > 0 && after[length - 1] == 's';
    if (count > 0) {
        (void)snprintf(text, sizeof text, "%s%" PRIu64 "%.*s", before, count, length - (plural && count == 1), after);
        list_add(l, text);
    }
}

static void count_light(FILE *file, uint16_t number, const observed_light *light)
{
    char begin[24];
    (void)snprintf(begin, sizeof begin, "    light %u: ", (unsigned)number);
    list l = {file, begin, "\n", 0};
    write_count(&l, "n.s ", light->count[OBSERVED_DIFFUSE], " times");
    write_count(&l, "highlight ", light->count[OBSERVED_SPECULAR], " times");
    write_count(&l, "in a sum of lights on ", light->count[OBSERVED_FOLDED], " triangles");
    write_count(&l, "not reaching ", light->count[OBSERVED_CULLED], " triangles");
    write_count(&l, "shadows thrown by single triangles ", light->count[OBSERVED_SHADOWS], " times");
    list_end(&l);
}

static void count_pixels(FILE *file, const observed_object *of)
{
    uint64_t pixels = 0;
    for (int tier = 0; tier < GLINT_TIERS; tier++) {
        pixels += of->tier_pixels[tier];
    }
    fprintf(file, "%" PRIu64 " pixels", pixels);
    list tiers = {file, ": ", "", 0};
    for (int tier = 0; tier < GLINT_TIERS; tier++) {
        if (of->tier_pixels[tier] > 0) {
            char text[48];
            (void)snprintf(text, sizeof text, "%lu %s", (unsigned long)of->tier_pixels[tier],
                           options_tier_word((uint8_t)tier));
            list_add(&tiers, text);
        }
    }
    list more = {file, "; ", "", 0};
    write_count(&more, "highlights on ", of->highlight_pixels, "");
    write_count(&more, "", of->shadowed_pixels, " in some shadow");
    write_count(&more, "sky and ground on ", of->sky_pixels, "");
    write_count(&more, "", of->texture_texels, " texels read");
    write_count(&more, "", of->environment_lookups * 4, " texels of the environment read");
    write_count(&more, "fog looked up on ", of->fog_pixels, "");
    write_count(&more, "the fog's colour alone on ", of->hidden_pixels, "");
    write_count(&more, "mixed with what is behind on ", of->layer_pixels, "");
    write_count(&more, "lines looked for on ", of->wire_pixels, "");
    fputc('\n', file);
}

/* Of the objects from `first` on whose plan reads as its does. Where they are many, their lights are told together. */
static void count_objects(FILE *file, const glint_scene *scene, char *const *plans, uint16_t first,
                          const observation *seen)
{
    const unsigned same = alike(plans, first, scene->object_count);
    for (uint16_t i = first; i < scene->object_count; i++) {
        if (strcmp(plans[i], plans[first]) == 0) {
            fprintf(file, "  object %u, %u triangles: ", (unsigned)i, (unsigned)scene->objects[i].mesh->triangle_count);
            count_pixels(file, &seen->objects[i]);
            for (uint16_t k = 0; same <= MOST_APART && k < scene->light_count; k++) {
                count_light(file, k, &seen->lights[(size_t)i * scene->light_count + k]);
            }
        }
    }
    if (same > MOST_APART && scene->light_count > 0) {
        fprintf(file, "  all these together:\n");
        for (uint16_t k = 0; k < scene->light_count; k++) {
            observed_light sum = {{0}};
            for (uint16_t i = first; i < scene->object_count; i++) {
                for (int term = 0; term < OBSERVED_COUNTS && strcmp(plans[i], plans[first]) == 0; term++) {
                    sum.count[term] += seen->lights[(size_t)i * scene->light_count + k].count[term];
                }
            }
            count_light(file, k, &sum);
        }
    }
}

static void count_frame(FILE *file, const glint_report *report, const observation *seen, uint16_t objects)
{
    observed_object all = {.highlight_pixels = report->pixels_specular, .shadowed_pixels = report->pixels_shadowed};
    for (uint16_t i = 0; i < objects; i++) {
        const observed_object *const of = &seen->objects[i];
        all.texture_texels += of->texture_texels;
        all.environment_lookups += of->environment_lookups;
        all.sky_pixels += of->sky_pixels;
        all.fog_pixels += of->fog_pixels;
        all.hidden_pixels += of->hidden_pixels;
        all.layer_pixels += of->layer_pixels;
        all.wire_pixels += of->wire_pixels;
    }
    for (int tier = 0; tier < GLINT_TIERS; tier++) {
        all.tier_pixels[tier] = report->tier_pixels[tier];
    }
    fprintf(file, "the frame: %lu of %lu triangles drawn, ", (unsigned long)report->triangles_drawn,
            (unsigned long)report->triangles);
    count_pixels(file, &all);
    if (report->shadow_tests > 0) {
        fprintf(file, "  shadows on %lu triangles, thrown by single triangles %lu times\n",
                (unsigned long)report->shadow_triangles, (unsigned long)report->shadow_tests);
    }
}

/* ------------------------------------------------------------------------------------------------------------ objects
 */

/* The numbers of the objects from `first` on whose plan reads as its does. */
static void write_heading(FILE *file, char *const *plans, uint16_t first, uint16_t count)
{
    list l = {file, "", "", 0};
    fputs(alike(plans, first, count) == 1 ? "\nobject " : "\nobjects ", file);
    for (uint16_t i = first; i < count; i++) {
        if (strcmp(plans[i], plans[first]) == 0) {
            char text[16];
            (void)snprintf(text, sizeof text, "%u", (unsigned)i);
            list_add(&l, text);
        }
    }
    fputc('\n', file);
}

static void write_objects(FILE *file, const glint_scene *scene, char *const *plans, const observation *seen)
{
    for (uint16_t first = 0; first < scene->object_count; first++) {
        uint16_t before = 0;
        while (before < first && strcmp(plans[before], plans[first]) != 0) {
            before++;
        }
        if (before < first) {
            continue; /* has been told with that one */
        }
        write_heading(file, plans, first, scene->object_count);
        fputs(plans[first], file);
        count_objects(file, scene, plans, first, seen);
    }
}

static const char legend[] =
    "n.s (the cosine of a light) and highlights (that of r and c, or n and h) count as often as they are evaluated: "
    "by\n"
    "pixel; once in a triangle of one colour; by corner in gouraud, by triangle in flat shading. What is found of a\n"
    "triangle's lights before it is drawn does not count. Highlights are on a pixel if one shows there or, as far as "
    "the\n"
    "renderer looks, may show.\n";

int explain(FILE *file, const glint_scene *scene, const glint_quality *quality, const glint_report *report,
            const observation *seen)
{
    bool absent[TERM_COUNT];
    find_absent(scene, absent);
    char **plans = calloc((size_t)scene->object_count + 1, sizeof *plans);
    int result = plans == NULL ? -1 : 0;
    for (uint16_t i = 0; i < scene->object_count && result == 0; i++) {
        size_t bytes = 0;
        FILE *text = open_memstream(&plans[i], &bytes);
        result = text == NULL ? -1 : write_plan(text, scene, quality, i, absent);
        if (text != NULL && fclose(text) != 0) {
            result = -1;
        }
    }
    if (result == 0) {
        explain_scene(file, scene, quality, absent);
        write_objects(file, scene, plans, seen);
        fputc('\n', file);
        count_frame(file, report, seen, scene->object_count);
        fputs(legend, file);
    }
    for (uint16_t i = 0; plans != NULL && i < scene->object_count; i++) {
        free(plans[i]);
    }
    free(plans);
    return result;
}
