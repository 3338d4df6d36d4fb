/* SPDX-License-Identifier: MIT */
/*
 * Materials: those of OBJ and COLLADA are this very model and are taken as they are; glTF's metallic-roughness model is
 * approximated.
 *
 * OBJ:      Ka, Kd, Ks, Ns. `illum 0` and `1` (assimp's value also where there is none) have no specular term.
 * COLLADA:  ambient, diffuse, specular, shininess; blinn is GLINT_BLINN, lambert and constant have no specular term.
 * glTF:     with base colour c, metallic m and roughness r (pbrMetallicRoughness; of the textures that of c is read):
 *
 *     r_a = c,  r_d = c (1 - m),  F = 0.04 (1 - m) + c m
 *     alpha = 2 / r^4 - 2, at most GLINT_MAX_EXPONENT,  r_s = min(1, F (alpha + 8) / 8),  GLINT_BLINN
 *
 * alpha: the exponent of n.h of the lobe with glTF's width r^2 (B. Walter and others, "Microfacet models for refraction
 * through rough surfaces", EGSR 2007). F (alpha + 8) / 8: the normalised Blinn-Phong lobe beside a diffuse term of c
 * (T. Akenine-Moeller and others, "Real-Time Rendering", 3rd ed., 7.6); its peak is cut at 1, where a display ends too.
 * 0.04 is glTF's reflectance of dielectrics. Nothing stands for the growth of F at grazing angles or for reflections,
 * so polished metals are darker than in a viewer with an environment.
 *
 * Opacity o (MTL's d or 1 - Tr, COLLADA's transparency, glTF's base colour alpha where its mode is BLEND) mixes all of
 * the surface's light with what is behind, o L + (1 - o) behind. glint_material.transmission t = 1 - o does so with all
 * but the highlight, which is therefore multiplied by o here. glTF's KHR_materials_transmission leaves the highlight
 * alone, as t does.
 */
#include "tools/import/internal.h"

#ifdef GLINT_HAVE_ASSIMP

#include <math.h>
#include <string.h>

#include <assimp/GltfMaterial.h>
#include <assimp/material.h>

typedef struct float_material {
    double ambient[3], diffuse[3], specular[3], emission[3], exponent, transmission;
    bool blinn;
} float_material;

/* What a material has in three channels. */
enum { PARTS = 4 };
static const char *const part_names[PARTS] = {"ambient reflectance", "diffuse reflectance", "specular reflectance",
                                              "emission"};

static bool get_number(const struct aiMaterial *material, const char *key, unsigned type, unsigned index, double *value)
{
    float number;
    unsigned room = 1;
    if (aiGetMaterialFloatArray(material, key, type, index, &number, &room) != aiReturn_SUCCESS || room < 1) {
        return false;
    }
    *value = (double)number;
    return true;
}

static bool get_colour(const struct aiMaterial *material, const char *key, unsigned type, unsigned index,
                       double value[3])
{
    float numbers[4];
    unsigned room = 4;
    if (aiGetMaterialFloatArray(material, key, type, index, numbers, &room) != aiReturn_SUCCESS || room < 3) {
        return false;
    }
    for (int k = 0; k < 3; k++) {
        value[k] = (double)numbers[k];
    }
    return true;
}

/* assimp's own accessor reads 4 bytes also where a property holds a bool of one. */
static int get_integer(const struct aiMaterial *material, const char *key, unsigned type, unsigned index, int missing)
{
    const struct aiMaterialProperty *property;
    if (aiGetMaterialProperty(material, key, type, index, &property) != aiReturn_SUCCESS) {
        return missing;
    }
    if (property->mDataLength == 1) {
        return property->mData[0];
    }
    int value = missing;
    if ((property->mType == aiPTI_Integer || property->mType == aiPTI_Buffer) &&
        property->mDataLength >= sizeof value) {
        memcpy(&value, property->mData, sizeof value);
    }
    return value;
}

static void name_material(const struct aiMaterial *material, char name[128])
{
    struct aiString given;
    memset(&given, 0, sizeof given);
    bool has = aiGetMaterialString(material, AI_MATKEY_NAME, &given) == aiReturn_SUCCESS && given.length;
    snprintf(name, 128, "%.127s", has ? given.data : "(unnamed)");
}

/* What has no place in the model. */
static void warn_of_rest(importer *import, const struct aiMaterial *material, const char *name)
{
    unsigned textures = 0;
    for (int type = aiTextureType_DIFFUSE; type <= AI_TEXTURE_TYPE_MAX; type++) {
        const bool colours = type == aiTextureType_DIFFUSE || type == aiTextureType_BASE_COLOR;
        textures += colours ? 0 : aiGetMaterialTextureCount(material, (enum aiTextureType)type);
    }
    if (textures) {
        store_warn(import->out, "material '%s': textures other than of the diffuse colour are ignored", name);
    }
}

/* Of glTF's modes OPAQUE does not look at alpha, and MASK shows all of a surface or nothing. */
static bool is_opaque_mode(importer *import, const struct aiMaterial *material, const char *name, double opacity)
{
    struct aiString mode;
    memset(&mode, 0, sizeof mode);
    if (import->kind != FILE_GLTF ||
        aiGetMaterialString(material, AI_MATKEY_GLTF_ALPHAMODE, &mode) != aiReturn_SUCCESS) {
        return false;
    }
    if (strcmp(mode.data, "MASK") == 0) {
        double cutoff = 0.5;
        get_number(material, AI_MATKEY_GLTF_ALPHACUTOFF, &cutoff);
        store_warn(import->out, "material '%s': its alpha mask is ignored; all of it is drawn%s", name,
                   opacity < cutoff ? ", though its alpha is below the cutoff" : "");
    }
    return strcmp(mode.data, "BLEND") != 0;
}

static double limited_share(importer *import, const char *name, const char *part, double value)
{
    if (value < 0 || value > 1) {
        store_warn(import->out, "material '%s': the %s %g is limited to 0 to 1", name, part, value);
    }
    return fmin(1, fmax(0, value));
}

static int read_transmission(importer *import, const struct aiMaterial *material, const char *name,
                             float_material *values)
{
    double opacity = 1, transmission = 0;
    get_number(material, AI_MATKEY_OPACITY, &opacity);
    get_number(material, AI_MATKEY_TRANSMISSION_FACTOR, &transmission);
    if (!isfinite(opacity) || !isfinite(transmission)) {
        return fail(import, "material '%s': the %s is not finite; 0 to 1 expected", name,
                    isfinite(opacity) ? "transmission" : "opacity");
    }
    if (is_opaque_mode(import, material, name, opacity)) {
        opacity = 1;
    }
    opacity = limited_share(import, name, "opacity", opacity);
    transmission = limited_share(import, name, "transmission", transmission);
    if (!(opacity > 0)) {
        store_warn(import->out, "material '%s': its opacity is 0, so that nothing of it is seen", name);
    }
    for (int k = 0; k < 3; k++) {
        values->specular[k] *= opacity;
    }
    values->transmission = 1 - opacity * (1 - transmission);
    return 0;
}

static void from_roughness(const struct aiMaterial *material, double roughness, float_material *result)
{
    double colour[3] = {1, 1, 1}, metallic = 1;
    if (!get_colour(material, AI_MATKEY_BASE_COLOR, colour)) {
        get_colour(material, AI_MATKEY_COLOR_DIFFUSE, colour);
    }
    get_number(material, AI_MATKEY_METALLIC_FACTOR, &metallic);
    double width = roughness * roughness;
    double exponent = width > 0 ? 2 / (width * width) - 2 : GLINT_MAX_EXPONENT;
    result->exponent = fmin(GLINT_MAX_EXPONENT, fmax(0, exponent));
    result->blinn = true;
    for (int k = 0; k < 3; k++) {
        double normal_reflectance = 0.04 * (1 - metallic) + colour[k] * metallic;
        result->ambient[k] = colour[k];
        result->diffuse[k] = colour[k] * (1 - metallic);
        result->specular[k] = fmin(1, normal_reflectance * (result->exponent + 8) / 8);
    }
}

static void from_phong(importer *import, const struct aiMaterial *material, const char *name, float_material *result)
{
    get_colour(material, AI_MATKEY_COLOR_AMBIENT, result->ambient);
    get_colour(material, AI_MATKEY_COLOR_DIFFUSE, result->diffuse);
    get_colour(material, AI_MATKEY_COLOR_SPECULAR, result->specular);
    get_number(material, AI_MATKEY_SHININESS, &result->exponent);

    int shading = get_integer(material, AI_MATKEY_SHADING_MODEL, aiShadingMode_Phong);
    result->blinn = shading == aiShadingMode_Blinn;
    if (shading == aiShadingMode_NoShading) {
        store_warn(import->out, "material '%s': a constant colour is drawn as a diffuse surface", name);
    }
    if (shading != aiShadingMode_Phong && shading != aiShadingMode_Blinn) {
        bool lost = result->specular[0] > 0 || result->specular[1] > 0 || result->specular[2] > 0;
        if (lost && import->kind == FILE_OBJ) {
            store_warn(import->out, "material '%s': Ks is not used without illum 2", name);
        }
        memset(result->specular, 0, sizeof result->specular);
        result->exponent = 0;
    }
}

static int to_colour(importer *import, const char *name, const char *part, const double value[3], glint_colour *result)
{
    int16_t codes[3];
    bool clamped = false;
    for (int k = 0; k < 3; k++) {
        if (!isfinite(value[k])) {
            return fail(import, "material '%s': the %s is not finite; 0 to 1 expected", name, part);
        }
        clamped = clamped || value[k] < 0 || value[k] > 1;
        codes[k] = (int16_t)fmax(0, to_fixed(value[k], FIXED_ONE_Q14, FIXED_ONE_Q14));
    }
    if (clamped) {
        store_warn(import->out, "material '%s': the %s (%g, %g, %g) is limited to 0 to 1", name, part, value[0],
                   value[1], value[2]);
    }
    *result = (glint_colour){codes[0], codes[1], codes[2]};
    return 0;
}

static int make_material(importer *import, const struct aiMaterial *material, glint_material *result)
{
    char name[128];
    name_material(material, name);
    warn_of_rest(import, material, name);

    float_material values = {.exponent = 0};
    double roughness;
    if (import->kind == FILE_GLTF && get_number(material, AI_MATKEY_ROUGHNESS_FACTOR, &roughness)) {
        from_roughness(material, roughness, &values);
    } else {
        from_phong(import, material, name, &values);
    }
    get_colour(material, AI_MATKEY_COLOR_EMISSIVE, values.emission);
    if (read_transmission(import, material, name, &values)) {
        return -1;
    }
    if (make_texture(import, material, name, &result->texture)) {
        return -1;
    }
    if (result->texture && import->kind == FILE_COLLADA) { /* a texture stands in the place of the colour */
        values.diffuse[0] = values.diffuse[1] = values.diffuse[2] = 1;
    }
    const double *const parts[PARTS] = {values.ambient, values.diffuse, values.specular, values.emission};
    glint_colour *const colours[PARTS] = {&result->ambient, &result->diffuse, &result->specular, &result->emission};
    for (int i = 0; i < PARTS; i++) {
        if (to_colour(import, name, part_names[i], parts[i], colours[i])) {
            return -1;
        }
    }
    if (!isfinite(values.exponent)) {
        return fail(import, "material '%s': the specular exponent is not finite; 0 to %d expected", name,
                    GLINT_MAX_EXPONENT);
    }
    double exponent = fmin(GLINT_MAX_EXPONENT, fmax(0, values.exponent));
    if (exponent < values.exponent || exponent > values.exponent) {
        store_warn(import->out, "material '%s': the specular exponent %g is limited to 0 to %d", name, values.exponent,
                   GLINT_MAX_EXPONENT);
    }
    result->exponent_q4 = (uint16_t)to_fixed(exponent, 16, UINT16_MAX);
    result->specular_model = values.blinn ? GLINT_BLINN : GLINT_PHONG;
    result->transmission_q14 = (uint16_t)to_fixed(values.transmission, FIXED_ONE_Q14, FIXED_ONE_Q14);
    result->sides = get_integer(material, AI_MATKEY_TWOSIDED, 0) ? GLINT_TWO_SIDED : GLINT_FRONT_SIDE;
    return 0;
}

int make_materials(importer *import, const glint_material *const **by_number)
{
    const struct aiScene *file = import->file;
    const glint_material **table = store_take(import->out, file->mNumMaterials, sizeof *table);
    if (!table) {
        return fail_memory(import);
    }
    for (unsigned m = 0; m < file->mNumMeshes; m++) {
        unsigned number = file->mMeshes[m]->mMaterialIndex;
        if (!import->meshes[m].part_count || table[number]) {
            continue;
        }
        glint_material *material = store_take(import->out, 1, sizeof *material);
        if (!material) {
            return fail_memory(import);
        }
        if (make_material(import, file->mMaterials[number], material)) {
            return -1;
        }
        table[number] = material;
        import->out->report.materials++;
    }
    *by_number = (const glint_material *const *)table;
    return 0;
}

#endif
