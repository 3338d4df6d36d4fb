/* SPDX-License-Identifier: MIT */
#include "explain.h"

#include <stdbool.h>

#include <glint/plan.h>

#include "options.h"

static void explain_term(FILE *file, const char *name, uint8_t reason)
{
    fprintf(file, "  %-10s %s%s\n", name, reason == GLINT_NEEDED ? "" : "no: ", glint_reason_text(reason));
}

static const char *kind_word(const glint_light *light)
{
    static const char *const words[] = {"directional", "point", "spot", "panel", "ball"};
    return words[light->kind];
}

/* Returns whether the light is there for the object. */
static bool explain_light(FILE *file, const glint_scene *scene, uint16_t object, const glint_object_plan *of_object,
                          uint16_t number, uint8_t tolerance)
{
    glint_light_plan plan;
    glint_plan_light(scene, object, of_object, number, &plan);
    const bool diffuse = plan.diffuse == GLINT_NEEDED, specular = plan.specular == GLINT_NEEDED;
    fprintf(file, "  light %-4u %s: ", (unsigned)number, kind_word(&scene->lights[number]));
    if (!diffuse && !specular) {
        /* where the reasons differ, the diffuse term's is the more telling one */
        fprintf(file, "left out: %s\n", glint_reason_text(plan.diffuse));
        return false;
    }
    fprintf(file, "%s%s%s", diffuse ? "diffuse" : "", diffuse && specular ? " and " : "", specular ? "specular" : "");
    if (!diffuse || !specular) {
        fprintf(file, " (no %s: %s)", diffuse ? "specular" : "diffuse",
                glint_reason_text(diffuse ? plan.specular : plan.diffuse));
    }
    if (scene->lights[number].kind == GLINT_PANEL || scene->lights[number].kind == GLINT_BALL) {
        glint_source_plan source;
        glint_plan_source(scene, object, of_object, number, &plan, glint_plan_room_q8(scene, tolerance), &source);
        fprintf(file, ", as %u point light%s within %.2f codes%s", (unsigned)source.points,
                source.points == 1 ? "" : "s", source.error_q8 / 256.0,
                source.enough ? "" : " (more samples asked for)");
    }
    fprintf(file, "%s%s", plan.attenuation ? ", attenuated" : "", plan.cone ? ", in a cone" : "");
    if (plan.shadow == GLINT_NEEDED) {
        fprintf(file, ", with shadows\n");
    } else {
        fprintf(file, "%s%s\n", scene->lights[number].casts_shadows ? ", without shadows: " : "",
                scene->lights[number].casts_shadows ? glint_reason_text(plan.shadow) : "");
    }
    return true;
}

static void explain_object(FILE *file, const glint_scene *scene, uint16_t number, uint8_t tolerance)
{
    const glint_mesh *mesh = scene->objects[number].mesh;
    glint_object_plan plan;
    unsigned lights = 0;
    glint_plan_object(scene, number, &plan);
    fprintf(file, "object %u: %u triangles, %u vertices\n", (unsigned)number, (unsigned)mesh->triangle_count,
            (unsigned)mesh->vertex_count);
    explain_term(file, "ambient", plan.ambient);
    explain_term(file, "sky", plan.sky);
    explain_term(file, "ground", plan.ground);
    explain_term(file, "emission", plan.emission);
    explain_term(file, "mirror", plan.mirror);
    explain_term(file, "fog", plan.fog);
    explain_term(file, "through", plan.transmission);
    explain_term(file, "grazing", plan.grazing);
    explain_term(file, "wire", plan.wire);
    explain_term(file, "texture", plan.texture);
    for (uint16_t i = 0; i < scene->light_count; i++) {
        lights += explain_light(file, scene, number, &plan, i, tolerance);
    }
    fprintf(file, "  %u of %u lights\n", lights, (unsigned)scene->light_count);
}

static void explain_counts(FILE *file, const glint_report *report)
{
    fprintf(file, "frame: %lu of %lu triangles drawn, %lu pixels shaded\n", (unsigned long)report->triangles_drawn,
            (unsigned long)report->triangles, (unsigned long)report->pixels_shaded);
    for (int tier = 0; tier < GLINT_TIERS; tier++) {
        if (report->tier_triangles[tier] > 0) {
            fprintf(file, "  %-8s %8lu triangles %8lu pixels\n", options_tier_word((uint8_t)tier),
                    (unsigned long)report->tier_triangles[tier], (unsigned long)report->tier_pixels[tier]);
        }
    }
    fprintf(file, "  a highlight evaluated, or above 0, at %lu pixels\n", (unsigned long)report->pixels_specular);
    fprintf(file, "  shadows on %lu triangles, thrown by single triangles %lu times, at %lu pixels\n",
            (unsigned long)report->shadow_triangles, (unsigned long)report->shadow_tests,
            (unsigned long)report->pixels_shadowed);
    fprintf(file, "  by triangle: %lu lights folded into sums, %lu that do not reach it\n",
            (unsigned long)report->lights_folded, (unsigned long)report->lights_culled);
}

void explain(FILE *file, const glint_scene *scene, uint8_t tolerance, const glint_report *report)
{
    for (uint16_t i = 0; i < scene->object_count; i++) {
        explain_object(file, scene, i, tolerance);
    }
    explain_counts(file, report);
}
