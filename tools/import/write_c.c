/* SPDX-License-Identifier: MIT */
/*
 * Writes a scene as C source for firmware: static const data that the linker puts into flash, and one glint_scene that
 * points to it. All numbers are the integers of the formats, so the compiled scene has the same bits. A mesh or
 * material that several objects share is written once.
 */
#include <ctype.h>
#include <stdbool.h>
#include <stdlib.h>

#include "tools/import/import.h"

#define LINE_WIDTH 110

/* Comments end at the first star and slash, and names of files may have any byte. */
static void write_comment(FILE *file, const char *text)
{
    char previous = ' ';
    fputs("/* ", file);
    for (; *text; text++) {
        char c = isprint((unsigned char)*text) ? *text : '?';
        if ((c == '/' && previous == '*') || (c == '*' && previous == '/')) {
            fputc(' ', file);
        }
        if (c == '?' && previous == '?') { /* no trigraphs */
            fputc(' ', file);
        }
        fputc(c, file);
        previous = c;
    }
    fputs(" */\n", file);
}

/* Writes rows of `width` numbers, 1 to 3, several on a line. */
static void write_rows(FILE *file, const char *type, const char *prefix, const char *name, size_t number, size_t count,
                       int width, long (*value)(const void *rows, size_t row, int k), const void *rows)
{
    char columns[16] = "";
    if (width > 1) {
        snprintf(columns, sizeof columns, "[%d]", width);
    }
    fprintf(file, "static const %s %s_%s_%zu[%zu]%s GLINT_FLASH = {", type, prefix, name, number, count, columns);
    int column = LINE_WIDTH;
    for (size_t row = 0; row < count; row++) {
        char text[96];
        int length = 0;
        for (int k = 0; k < width; k++) {
            length += snprintf(text + length, sizeof text - (size_t)length, "%s%ld",
                               k > 0       ? ", "
                               : width > 1 ? "{"
                                           : "",
                               value(rows, row, k));
        }
        length += snprintf(text + length, sizeof text - (size_t)length, "%s%s", width > 1 ? "}" : "",
                           row + 1 < count ? "," : "");
        if (column + length + 1 > LINE_WIDTH) {
            fputs("\n    ", file);
            column = 4;
        } else {
            fputc(' ', file);
            column++;
        }
        fputs(text, file);
        column += length;
    }
    fputs("\n};\n", file);
}

static long value_int16(const void *rows, size_t row, int k)
{
    return ((const int16_t(*)[3])rows)[row][k];
}

static long value_uint16(const void *rows, size_t row, int k)
{
    return ((const uint16_t(*)[3])rows)[row][k];
}

static long value_texcoord(const void *rows, size_t row, int k)
{
    return ((const int16_t(*)[2])rows)[row][k];
}

static long value_word(const void *rows, size_t row, int k)
{
    (void)k;
    return ((const uint16_t *)rows)[row];
}

static long value_byte(const void *rows, size_t row, int k)
{
    (void)k;
    return ((const uint8_t *)rows)[row];
}

static void write_texture(FILE *file, const char *prefix, size_t number, const glint_texture *texture)
{
    const size_t texels = (size_t)texture->width_px * texture->height_px;
    const bool palette = texture->format == GLINT_TEXTURE_PALETTE8;
    write_rows(file, palette ? "uint8_t" : "uint16_t", prefix, "texels", number, texels, 1,
               palette ? value_byte : value_word, texture->texels);
    if (palette) {
        write_rows(file, "uint16_t", prefix, "palette", number, texture->palette_count, 1, value_word,
                   texture->palette);
    }
    fprintf(file, "static const glint_texture %s_texture_%zu = {\n    .texels = %s_texels_%zu,\n", prefix, number,
            prefix, number);
    if (palette) {
        fprintf(file, "    .palette = %s_palette_%zu,\n    .palette_count = %u,\n", prefix, number,
                (unsigned)texture->palette_count);
    }
    fprintf(file,
            "    .width_px = %u,\n    .height_px = %u,\n    .format = %s,\n    .filter = %s,\n    .wrap_u = %s,\n    "
            ".wrap_v = %s,\n};\n\n",
            (unsigned)texture->width_px, (unsigned)texture->height_px,
            palette ? "GLINT_TEXTURE_PALETTE8" : "GLINT_TEXTURE_RGB565",
            texture->filter == GLINT_NEAREST ? "GLINT_NEAREST" : "GLINT_BILINEAR",
            texture->wrap_u == GLINT_CLAMP ? "GLINT_CLAMP" : "GLINT_REPEAT",
            texture->wrap_v == GLINT_CLAMP ? "GLINT_CLAMP" : "GLINT_REPEAT");
}

static void write_mesh(FILE *file, const char *prefix, size_t number, const glint_mesh *mesh)
{
    write_rows(file, "int16_t", prefix, "positions", number, mesh->vertex_count, 3, value_int16, mesh->positions);
    write_rows(file, "int16_t", prefix, "normals_q14", number, mesh->vertex_count, 3, value_int16, mesh->normals_q14);
    write_rows(file, "uint16_t", prefix, "triangles", number, mesh->triangle_count, 3, value_uint16, mesh->triangles);
    if (mesh->texcoords) {
        write_rows(file, "int16_t", prefix, "texcoords", number, mesh->vertex_count, 2, value_texcoord,
                   mesh->texcoords);
    }
    fprintf(
        file,
        "static const glint_mesh %s_mesh_%zu = {\n    .positions = %s_positions_%zu,\n    .normals_q14 = "
        "%s_normals_q14_%zu,\n    .triangles = %s_triangles_%zu,\n    .vertex_count = %u,\n    .triangle_count = %u,\n"
        "    .fraction_bits = %d,\n",
        prefix, number, prefix, number, prefix, number, prefix, number, (unsigned)mesh->vertex_count,
        (unsigned)mesh->triangle_count, (int)mesh->fraction_bits);
    if (mesh->texcoords) {
        fprintf(file, "    .texcoord_bits = %d,\n    .texcoords = %s_texcoords_%zu,\n", (int)mesh->texcoord_bits,
                prefix, number);
    }
    fputs("};\n\n", file);
}

static void write_colour(FILE *file, const char *indent, const char *field, const glint_colour *colour)
{
    fprintf(file, "%s.%s = {%d, %d, %d},\n", indent, field, colour->r_q14, colour->g_q14, colour->b_q14);
}

static void write_int32s(FILE *file, const char *indent, const char *field, const int32_t value[3])
{
    fprintf(file, "%s.%s = {%ld, %ld, %ld},\n", indent, field, (long)value[0], (long)value[1], (long)value[2]);
}

static void write_material(FILE *file, const char *prefix, size_t number, const glint_material *material)
{
    if (material->texture) {
        write_texture(file, prefix, number, material->texture);
    }
    fprintf(file, "static const glint_material %s_material_%zu = {\n", prefix, number);
    write_colour(file, "    ", "ambient", &material->ambient);
    write_colour(file, "    ", "diffuse", &material->diffuse);
    write_colour(file, "    ", "specular", &material->specular);
    write_colour(file, "    ", "emission", &material->emission);
    fprintf(file, "    .exponent_q4 = %u,\n    .specular_model = %s,\n", (unsigned)material->exponent_q4,
            material->specular_model == GLINT_BLINN ? "GLINT_BLINN" : "GLINT_PHONG");
    if (material->sides != GLINT_FRONT_SIDE) {
        fprintf(file, "    .sides = %s,\n", material->sides == GLINT_TWO_SIDED ? "GLINT_TWO_SIDED" : "GLINT_EACH_SIDE");
    }
    if (material->transmission_q14 != 0) {
        fprintf(file, "    .transmission_q14 = %u,\n", (unsigned)material->transmission_q14);
    }
    if (material->texture) {
        fprintf(file, "    .texture = &%s_texture_%zu,\n", prefix, number);
    }
    fputs("};\n\n", file);
}

static void write_object(FILE *file, const char *prefix, const glint_object *object, size_t mesh, size_t material)
{
    const int32_t(*linear)[3] = object->place.linear_q16;
    fprintf(file, "    {\n        .mesh = &%s_mesh_%zu,\n        .material = &%s_material_%zu,\n", prefix, mesh, prefix,
            material);
    fprintf(file,
            "        .place = {.linear_q16 = {{%ld, %ld, %ld}, {%ld, %ld, %ld}, {%ld, %ld, %ld}},\n"
            "                  .origin_q16 = {%ld, %ld, %ld}},\n    },\n",
            (long)linear[0][0], (long)linear[0][1], (long)linear[0][2], (long)linear[1][0], (long)linear[1][1],
            (long)linear[1][2], (long)linear[2][0], (long)linear[2][1], (long)linear[2][2],
            (long)object->place.origin_q16[0], (long)object->place.origin_q16[1], (long)object->place.origin_q16[2]);
}

/* What differs among `count` pointers, in order, and the number of each: number[i] is that of the i-th object's. */
typedef struct numbering {
    size_t *meshes, *materials;
} numbering;

/* Numbers objects by first use; `first[i]` of an object that brings a new one is its own index. */
static bool number_objects(const glint_scene *scene, numbering *numbers)
{
    size_t room = scene->object_count ? scene->object_count : 1;
    numbers->meshes = calloc(room, sizeof *numbers->meshes);
    numbers->materials = calloc(room, sizeof *numbers->materials);
    if (!numbers->meshes || !numbers->materials) {
        return false;
    }
    for (size_t i = 0; i < scene->object_count; i++) {
        const glint_object *objects = scene->objects;
        size_t same = 0;
        while (objects[same].mesh != objects[i].mesh) {
            same++;
        }
        numbers->meshes[i] = same;
        same = 0;
        while (objects[same].material != objects[i].material) {
            same++;
        }
        numbers->materials[i] = same;
    }
    return true;
}

static void write_objects(FILE *file, const glint_scene *scene, const char *prefix, const numbering *numbers)
{
    for (size_t i = 0; i < scene->object_count; i++) {
        if (numbers->materials[i] == i) {
            write_material(file, prefix, i, scene->objects[i].material);
        }
    }
    for (size_t i = 0; i < scene->object_count; i++) {
        if (numbers->meshes[i] == i) {
            write_mesh(file, prefix, i, scene->objects[i].mesh);
        }
    }
    fprintf(file, "static const glint_object %s_objects[%u] = {\n", prefix, (unsigned)scene->object_count);
    for (size_t i = 0; i < scene->object_count; i++) {
        write_object(file, prefix, &scene->objects[i], numbers->meshes[i], numbers->materials[i]);
    }
    fputs("};\n\n", file);
}

static void write_attenuation(FILE *file, const glint_attenuation *a)
{
    if (a->range_q16 == 0 && (a->k_q14[0] | a->k_q14[1] | a->k_q14[2]) == 0) {
        return;
    }
    fprintf(file, "        .attenuation = {.k_q14 = {%u, %u, %u}, .unit_q16 = %lu, .range_q16 = %lu},\n",
            (unsigned)a->k_q14[0], (unsigned)a->k_q14[1], (unsigned)a->k_q14[2], (unsigned long)a->unit_q16,
            (unsigned long)a->range_q16);
}

static void write_lights(FILE *file, const glint_scene *scene, const char *prefix)
{
    fprintf(file, "static const glint_light %s_lights[%u] = {\n", prefix, (unsigned)scene->light_count);
    for (size_t i = 0; i < scene->light_count; i++) {
        const glint_light *light = &scene->lights[i];
        fprintf(file, "    {\n        .kind = %s,\n",
                light->kind == GLINT_SPOT    ? "GLINT_SPOT"
                : light->kind == GLINT_POINT ? "GLINT_POINT"
                                             : "GLINT_DIRECTIONAL");
        if (light->kind != GLINT_DIRECTIONAL) {
            write_int32s(file, "        ", "position_q16", light->position_q16);
            write_attenuation(file, &light->attenuation);
        }
        if (light->kind != GLINT_POINT) {
            const int32_t direction[3] = {light->direction[0], light->direction[1], light->direction[2]};
            write_int32s(file, "        ", "direction", direction);
        }
        if (light->kind == GLINT_SPOT) {
            fprintf(file, "        .inner_turn16 = %u,\n        .outer_turn16 = %u,\n", (unsigned)light->inner_turn16,
                    (unsigned)light->outer_turn16);
        }
        write_colour(file, "        ", "colour", &light->colour);
        fputs("    },\n", file);
    }
    fputs("};\n\n", file);
}

static void write_camera(FILE *file, const glint_camera *camera, const char *prefix)
{
    fprintf(file, "static const glint_camera %s_camera = {\n", prefix);
    write_int32s(file, "    ", "eye_q16", camera->eye_q16);
    write_int32s(file, "    ", "target_q16", camera->target_q16);
    fprintf(file, "    .up = {%d, %d, %d},\n    .field_of_view_turn16 = %u,\n    .near_q16 = %ld,\n};\n\n",
            camera->up[0], camera->up[1], camera->up[2], (unsigned)camera->field_of_view_turn16,
            (long)camera->near_q16);
}

int import_write_c(FILE *file, const glint_scene *scene, const char *prefix, const char *command, const char *header)
{
    numbering numbers;
    bool numbered = number_objects(scene, &numbers);
    if (numbered) {
        write_comment(file, command);
        fputs("/* Generated: a scene for <glint/scene.h>. */\n#include <glint/scene.h>\n\n", file);
        if (header) {
            fprintf(file, "#include \"%s\"\n\n", header);
        } else {
            fprintf(file, "extern const glint_scene %s_scene;\n\n", prefix);
        }
        if (scene->object_count) {
            write_objects(file, scene, prefix, &numbers);
        }
        if (scene->light_count) {
            write_lights(file, scene, prefix);
        }
        write_camera(file, scene->camera, prefix);
        fprintf(file, "const glint_scene %s_scene = {\n    .camera = &%s_camera,\n", prefix, prefix);
        if (scene->object_count) {
            fprintf(file, "    .objects = %s_objects,\n    .object_count = %u,\n", prefix,
                    (unsigned)scene->object_count);
        }
        if (scene->light_count) {
            fprintf(file, "    .lights = %s_lights,\n    .light_count = %u,\n", prefix, (unsigned)scene->light_count);
        }
        write_colour(file, "    ", "ambient", &scene->ambient);
        write_colour(file, "    ", "background", &scene->background);
        fputs("};\n", file);
    }
    free(numbers.meshes);
    free(numbers.materials);
    return numbered && fflush(file) == 0 && !ferror(file) ? 0 : -1;
}

int import_write_header(FILE *file, const char *prefix, const char *command)
{
    write_comment(file, command);
    fprintf(file,
            "/* Generated: declares a scene for <glint/scene.h>. */\n#ifndef %s_SCENE_H\n#define %s_SCENE_H\n\n"
            "#include <glint/scene.h>\n\n#ifdef __cplusplus\nextern \"C\" {\n#endif\n\nextern const glint_scene "
            "%s_scene;\n\n"
            "#ifdef __cplusplus\n}\n#endif\n\n#endif\n",
            prefix, prefix, prefix);
    return fflush(file) == 0 && !ferror(file) ? 0 : -1;
}
