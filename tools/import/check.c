/* SPDX-License-Identifier: MIT */
/*
 * Checks what assimp read before anything is computed from it. assimp's own validation
 * (aiProcess_ValidateDataStructure) looks at structure; here are the numbers: all finite, all indices in range. A
 * message names the mesh and the vertex, counted from 0 as assimp numbers them (an OBJ vertex that has several normals
 * counts once for each).
 */
#include "tools/import/internal.h"

#ifdef GLINT_HAVE_ASSIMP

#include <math.h>

static bool finite_vector(const struct aiVector3D *vector)
{
    return isfinite(vector->x) && isfinite(vector->y) && isfinite(vector->z);
}

static int check_mesh(importer *import, const struct aiMesh *mesh)
{
    const char *name = name_of(&mesh->mName);
    if ((mesh->mNumVertices && !mesh->mVertices) || (mesh->mNumFaces && !mesh->mFaces)) {
        return fail(import, "mesh '%s': an array is missing", name);
    }
    for (unsigned v = 0; v < mesh->mNumVertices; v++) {
        const struct aiVector3D *position = &mesh->mVertices[v];
        if (!finite_vector(position)) {
            return fail(import,
                        "mesh '%s', vertex %u: the position (%g, %g, %g) is not finite; finite numbers expected", name,
                        v, (double)position->x, (double)position->y, (double)position->z);
        }
        if (mesh->mNormals && !finite_vector(&mesh->mNormals[v])) {
            return fail(import, "mesh '%s', vertex %u: the normal is not finite; finite numbers expected", name, v);
        }
    }
    for (unsigned f = 0; f < mesh->mNumFaces; f++) {
        const struct aiFace *face = &mesh->mFaces[f];
        if (face->mNumIndices && !face->mIndices) {
            return fail(import, "mesh '%s', face %u: its indices are missing", name, f);
        }
        for (unsigned i = 0; i < face->mNumIndices; i++) {
            if (face->mIndices[i] >= mesh->mNumVertices) {
                return fail(import, "mesh '%s', face %u: vertex index %u out of range; less than %u expected", name, f,
                            face->mIndices[i], mesh->mNumVertices);
            }
        }
    }
    if (mesh->mMaterialIndex >= import->file->mNumMaterials) {
        return fail(import, "mesh '%s': material %u out of range; less than %u expected", name, mesh->mMaterialIndex,
                    import->file->mNumMaterials);
    }
    return 0;
}

static bool finite_colour(const struct aiColor3D *colour)
{
    return isfinite(colour->r) && isfinite(colour->g) && isfinite(colour->b);
}

int check_file(importer *import)
{
    const struct aiScene *file = import->file;
    if (!file->mRootNode || !file->mNumMeshes) {
        return fail(import, "the file has no mesh; at least one triangle expected");
    }
    uint64_t lines = 0;
    uint64_t faces = 0;
    bool colours = false;
    for (unsigned m = 0; m < file->mNumMeshes; m++) {
        const struct aiMesh *mesh = file->mMeshes[m];
        if (check_mesh(import, mesh)) {
            return -1;
        }
        for (unsigned f = 0; f < mesh->mNumFaces; f++) {
            *(mesh->mFaces[f].mNumIndices < 3 ? &lines : &faces) += 1;
        }
        colours = colours || mesh->mColors[0];
        if (mesh->mNumBones || mesh->mNumAnimMeshes) {
            store_warn(import->out, "mesh '%s': bones and morph targets are ignored", name_of(&mesh->mName));
        }
    }
    if (!faces) {
        return fail(import, "the file has no face of three or more vertices; at least one triangle expected");
    }
    if (lines) {
        store_warn(import->out, "%llu points and lines are ignored", (unsigned long long)lines);
    }
    if (colours) {
        store_warn(import->out, "colours of vertices are ignored");
    }
    if (file->mNumAnimations) {
        store_warn(import->out, "animations are ignored");
    }
    for (unsigned i = 0; i < file->mNumLights; i++) {
        const struct aiLight *light = file->mLights[i];
        if (!finite_vector(&light->mPosition) || !finite_vector(&light->mDirection) ||
            !finite_colour(&light->mColorDiffuse) || !finite_colour(&light->mColorAmbient) ||
            !isfinite(light->mAttenuationConstant) || !isfinite(light->mAttenuationLinear) ||
            !isfinite(light->mAttenuationQuadratic)) {
            return fail(import, "light '%s': a number is not finite; finite numbers expected", name_of(&light->mName));
        }
    }
    for (unsigned i = 0; i < file->mNumCameras; i++) {
        const struct aiCamera *camera = file->mCameras[i];
        if (!finite_vector(&camera->mPosition) || !finite_vector(&camera->mLookAt) || !finite_vector(&camera->mUp) ||
            !isfinite(camera->mHorizontalFOV) || !isfinite(camera->mAspect) || !isfinite(camera->mClipPlaneNear)) {
            return fail(import, "camera '%s': a number is not finite; finite numbers expected",
                        name_of(&camera->mName));
        }
    }
    return 0;
}

#endif
