/* SPDX-License-Identifier: MIT */
#include "view.h"

#include <stdlib.h>
#include <string.h>

int view_open(view *v, const demo_scene *demo, uint8_t tolerance, const glint_display *display, failure *f)
{
    *v = (view){.demo = demo, .tolerance = tolerance};
    v->memory_bytes = glint_fixed_memory_bytes(demo->scene, display);
    v->objects = calloc(demo->scene->object_count + (size_t)1, sizeof *v->objects);
    v->memory = malloc(v->memory_bytes + sizeof(uint32_t));
    if (v->objects == NULL || v->memory == NULL) {
        view_close(v);
        return fail_with(f, "out of memory");
    }
    return 0;
}

void view_close(view *v)
{
    free(v->objects);
    free(v->memory);
    memset(v, 0, sizeof *v);
}

void view_switch_tolerance(view *v)
{
    static const uint8_t tolerances[] = {GLINT_CODES(1), GLINT_CODES(4), GLINT_CODES(15), 0};
    size_t next = 0;
    while (v->tolerance != 0 && tolerances[next] != 0 && tolerances[next] <= v->tolerance) {
        next++;
    }
    v->tolerance = tolerances[next];
}

int view_draw(view *v, const glint_display *display, glint_report *report, failure *f)
{
    const glint_quality quality = {.shading = GLINT_SHADING_EXACT, .tolerance = v->tolerance};
    glint_scene turned;
    int result = demo_scene_turn(v->demo->scene, v->turn16, v->objects, &turned);
    if (result == GLINT_OK) {
        result = glint_fixed_render(&turned, display, &quality, v->memory, v->memory_bytes, report);
    }
    return result < 0 ? fail_with(f, "%s: %s", v->demo->name, glint_error_text(result)) : result;
}
