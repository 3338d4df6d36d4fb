/* SPDX-License-Identifier: MIT */
/*
 * Textures: the picture that a material's diffuse reflectance (glTF: base colour) is multiplied by, from a PNG or PPM
 * file beside the model or a PNG within it. Pictures of up to 256 colours of RGB565 get a palette, others are RGB565.
 *
 * Limits: the first texture and the first set of coordinates; no transform of them; larger pictures than
 * GLINT_MAX_TEXTURE_PX are reduced. What cannot be read is left out with a warning.
 */
#include "tools/import/internal.h"

#ifdef GLINT_HAVE_ASSIMP

#include <stdlib.h>
#include <string.h>

#include <assimp/GltfMaterial.h>
#include <assimp/material.h>

#include "tools/picture/picture.h"

bool has_texture(const struct aiMaterial *material)
{
    return aiGetMaterialTextureCount(material, aiTextureType_DIFFUSE) > 0;
}

/* Every `step`-th part of the picture in both directions, averaged. */
static int reduce(picture *from, int step, char *error, size_t error_bytes)
{
    picture to = {0};
    if (picture_create(&to, (from->width + step - 1) / step, (from->height + step - 1) / step, error, error_bytes)) {
        return -1;
    }
    for (int y = 0; y < to.height; y++) {
        for (int x = 0; x < to.width; x++) {
            for (int k = 0; k < 3; k++) {
                unsigned sum = 0, count = 0;
                for (int j = y * step; j < (y + 1) * step && j < from->height; j++) {
                    for (int i = x * step; i < (x + 1) * step && i < from->width; i++, count++) {
                        sum += from->rgb[((size_t)j * (size_t)from->width + (size_t)i) * 3 + (size_t)k];
                    }
                }
                to.rgb[((size_t)y * (size_t)to.width + (size_t)x) * 3 + (size_t)k] =
                    (uint8_t)((sum + count / 2) / (count > 0 ? count : 1));
            }
        }
    }
    picture_free(from);
    *from = to;
    return 0;
}

static uint16_t to_rgb565(const uint8_t rgb[3])
{
    return (uint16_t)((rgb[0] * 31 + 127) / 255 << 11 | (rgb[1] * 63 + 127) / 255 << 5 | (rgb[2] * 31 + 127) / 255);
}

/* Texels, and a palette if there are few colours; false without memory. */
static bool take_texels(importer *import, const picture *from, glint_texture *texture)
{
    const size_t count = (size_t)from->width * (size_t)from->height;
    uint16_t *const texels = store_take(import->out, count, sizeof *texels);
    uint16_t *const palette = store_take(import->out, GLINT_MAX_PALETTE, sizeof *palette);
    uint8_t *const numbers = store_take(import->out, count, 1);
    int16_t *const number_of = malloc(65536 * sizeof *number_of);
    bool few = true;
    if (!texels || !palette || !numbers || !number_of) {
        free(number_of);
        return false;
    }
    memset(number_of, 0xff, 65536 * sizeof *number_of);
    for (size_t i = 0; i < count; i++) {
        const uint16_t colour = texels[i] = to_rgb565(&from->rgb[i * 3]);
        if (few && number_of[colour] < 0) {
            few = texture->palette_count < GLINT_MAX_PALETTE;
            if (few) {
                palette[texture->palette_count] = colour;
                number_of[colour] = (int16_t)texture->palette_count++;
            }
        }
        numbers[i] = few ? (uint8_t)number_of[colour] : 0;
    }
    free(number_of);
    texture->texels = texels;
    if (few) {
        texture->texels = numbers;
        texture->palette = palette;
        texture->format = GLINT_TEXTURE_PALETTE8;
    } else {
        texture->palette_count = 0;
    }
    import->out->report.flash_bytes += few ? count + 2u * texture->palette_count : 2 * count;
    return true;
}

/* A texture within the file is called *N by its number, or by its name. */
static const struct aiTexture *own_texture(const struct aiScene *file, const char *path)
{
    for (unsigned i = 0; i < file->mNumTextures; i++) {
        char number[16];
        snprintf(number, sizeof number, "*%u", i);
        if (strcmp(path, number) == 0 || strcmp(path, file->mTextures[i]->mFilename.data) == 0) {
            return file->mTextures[i];
        }
    }
    return NULL;
}

/* The picture of a path in the model: one of the file's own, or a file beside it. */
static int read_picture(importer *import, const char *path, picture *out, char *error, size_t error_bytes)
{
    const struct aiTexture *own = own_texture(import->file, path);
    if (own) {
        if (own->mHeight != 0) { /* texels, not a file */
            if (picture_create(out, (int)own->mWidth, (int)own->mHeight, error, error_bytes)) {
                return -1;
            }
            for (size_t i = 0; i < (size_t)own->mWidth * own->mHeight; i++) {
                out->rgb[i * 3] = own->pcData[i].r;
                out->rgb[i * 3 + 1] = own->pcData[i].g;
                out->rgb[i * 3 + 2] = own->pcData[i].b;
            }
            return 0;
        }
        return picture_read_png(own->pcData, own->mWidth, out, error, error_bytes);
    }
    const char *const last = strrchr(import->path, '/');
    const size_t folder = last && path[0] != '/' ? (size_t)(last + 1 - import->path) : 0;
    char whole[2048];
    if (folder + strlen(path) >= sizeof whole) {
        snprintf(error, error_bytes, "the path is too long");
        return -1;
    }
    memcpy(whole, import->path, folder);
    memcpy(whole + folder, path, strlen(path) + 1);
    for (char *c = whole + folder; *c; c++) {
        *c = (char)(*c == '\\' ? '/' : *c);
    }
    return picture_read(whole, out, error, error_bytes);
}

static uint8_t wrap_of(importer *import, const char *name, enum aiTextureMapMode mode)
{
    if (mode == aiTextureMapMode_Mirror) {
        store_warn(import->out, "material '%s': a mirrored texture is repeated", name);
    }
    return mode == aiTextureMapMode_Clamp || mode == aiTextureMapMode_Decal ? GLINT_CLAMP : GLINT_REPEAT;
}

/* glTF may ask for the nearest texel; else textures are filtered. */
static uint8_t filter_of(const struct aiMaterial *material)
{
    enum { GLTF_NEAREST = 9728 };
    int filter = 0;
    unsigned room = 1;
    return aiGetMaterialIntegerArray(material, AI_MATKEY_GLTF_MAPPINGFILTER_MAG(aiTextureType_DIFFUSE, 0), &filter,
                                     &room) == aiReturn_SUCCESS &&
                   filter == GLTF_NEAREST
               ? GLINT_NEAREST
               : GLINT_BILINEAR;
}

int make_texture(importer *import, const struct aiMaterial *material, const char *name, const glint_texture **result)
{
    struct aiString path;
    enum aiTextureMapMode mode[3] = {aiTextureMapMode_Wrap, aiTextureMapMode_Wrap, aiTextureMapMode_Wrap};
    unsigned set = 0;
    picture read = {0};
    char error[300];
    *result = NULL;
    memset(&path, 0, sizeof path);
    if (!has_texture(material) || aiGetMaterialTexture(material, aiTextureType_DIFFUSE, 0, &path, NULL, &set, NULL,
                                                       NULL, mode, NULL) != aiReturn_SUCCESS) {
        return 0;
    }
    if (set != 0) {
        store_warn(import->out, "material '%s': the first set of texture coordinates is used, not number %u", name,
                   set);
    }
    if (read_picture(import, path.data, &read, error, sizeof error)) {
        store_warn(import->out, "material '%s': drawn without its texture: %s", name, error);
        return 0;
    }
    const int most = read.width > read.height ? read.width : read.height;
    if (most > GLINT_MAX_TEXTURE_PX) {
        const int step = (most + GLINT_MAX_TEXTURE_PX - 1) / GLINT_MAX_TEXTURE_PX;
        store_warn(import->out, "material '%s': the texture of %d x %d is reduced to a %dth", name, read.width,
                   read.height, step);
        if (reduce(&read, step, error, sizeof error)) {
            picture_free(&read);
            return fail_memory(import);
        }
    }
    glint_texture *const texture = store_take(import->out, 1, sizeof *texture);
    if (!texture || !take_texels(import, &read, texture)) {
        picture_free(&read);
        return fail_memory(import);
    }
    texture->width_px = (uint16_t)read.width;
    texture->height_px = (uint16_t)read.height;
    texture->filter = filter_of(material);
    texture->wrap_u = wrap_of(import, name, mode[0]);
    texture->wrap_v = wrap_of(import, name, mode[1]);
    picture_free(&read);
    *result = texture;
    return 0;
}

#endif
