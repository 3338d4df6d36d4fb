/* SPDX-License-Identifier: MIT */
/*
 * The camera: the file's first perspective one, or one that frames all objects from three quarters above. Then the near
 * plane, as far out as is safe: depth is near / Z in 16 bits.
 *
 * assimp gives the horizontal field of view; Glint's is vertical. For glTF the conversion back is that of assimp's
 * own from the file's vertical one, which was a product with the aspect ratio before version 5.3. Where a COLLADA file
 * gives the vertical field alone, without an aspect ratio, assimp loses it.
 */
#include "tools/import/internal.h"

#ifdef GLINT_HAVE_ASSIMP

#include <math.h>

#include <assimp/version.h>

#define DEFAULT_FIELD_OF_VIEW (PI / 4)
#define LEAST_FIELD_TURN16 182
#define GREATEST_FIELD_TURN16 30947
#define TURN16_OF_RADIANS (65536 / (2 * PI))
#define LEAST_NEAR_Q16 64

#define FRAME_MARGIN 1.05 /* of the distance at which the bounding sphere touches the upper and lower edge */
#define SAFE_NEAR 0.95    /* of the distance to the bounding sphere */
#define INSIDE_NEAR 0.01  /* of its radius, when the eye is inside and the file does not say */

static const double three_quarters[3] = {0.6, 0.5, 1.0}; /* from the target to the eye */

static bool gltf_field_is_product(void)
{
    unsigned major = aiGetVersionMajor(), minor = aiGetVersionMinor();
    return major < 5 || (major == 5 && minor < 3);
}

static double vertical_field(importer *import, const struct aiCamera *camera)
{
    double horizontal = (double)camera->mHorizontalFOV, aspect = (double)camera->mAspect;
    if (import->kind == FILE_GLTF && gltf_field_is_product()) {
        return aspect > 0 ? horizontal / aspect : horizontal;
    }
    /* A COLLADA camera whose field assimp has not read has its default of 45 taken for degrees twice. */
    if (horizontal < PI / 180) {
        store_warn(import->out, "camera '%s': no field of view that can be read; 45 degrees taken",
                   name_of(&camera->mName));
        return DEFAULT_FIELD_OF_VIEW;
    }
    return aspect > 0 ? 2 * atan(tan(horizontal / 2) / aspect) : horizontal;
}

static bool view_from_file(importer *import, const struct aiCamera *camera, view *result)
{
    const char *name = name_of(&camera->mName);
    matrix34 world;
    if (!gather_node_matrix(import, camera->mName.data, &world)) {
        store_warn(import->out, "camera '%s' is in no node and is ignored", name);
        return false;
    }
    double position[3] = {0, 0, 0};
    if (import->kind != FILE_GLTF) { /* there assimp repeats the node's translation in the position */
        position[0] = (double)camera->mPosition.x;
        position[1] = (double)camera->mPosition.y;
        position[2] = (double)camera->mPosition.z;
    }
    const double forward[3] = {(double)camera->mLookAt.x, (double)camera->mLookAt.y, (double)camera->mLookAt.z};
    const double up[3] = {(double)camera->mUp.x, (double)camera->mUp.y, (double)camera->mUp.z};
    transform_point(&world, position, result->eye);
    transform_direction(&world, forward, result->forward);
    transform_direction(&world, up, result->up);
    double right[3];
    bool usable = normalise3(result->forward) && normalise3(result->up);
    if (usable) {
        cross3(result->forward, result->up, right);
        usable = length3(right) > 1e-3 && isfinite(length3(result->eye));
    }
    if (!usable) {
        store_warn(import->out, "camera '%s' has no direction of view or up and is ignored", name);
        return false;
    }
    result->near_plane = (double)camera->mClipPlaneNear;
    result->field_of_view = vertical_field(import, camera);
    if (camera->mOrthographicWidth > 0) {
        store_warn(import->out, "camera '%s': parallel projection is drawn in perspective, field of view 45 degrees",
                   name);
        result->field_of_view = DEFAULT_FIELD_OF_VIEW;
    }
    double turn16 = result->field_of_view * TURN16_OF_RADIANS;
    if (!(turn16 >= LEAST_FIELD_TURN16 && turn16 <= GREATEST_FIELD_TURN16)) {
        store_warn(import->out, "camera '%s': field of view %g degrees is limited to 1 to 170", name,
                   result->field_of_view * (180 / PI));
    }
    result->from_file = true;
    return true;
}

static void frame_view(const importer *import, view *result)
{
    result->field_of_view = DEFAULT_FIELD_OF_VIEW;
    double distance = FRAME_MARGIN * import->radius / sin(result->field_of_view / 2);
    for (int k = 0; k < 3; k++) {
        result->forward[k] = -three_quarters[k];
        result->up[k] = k == 1;
    }
    normalise3(result->forward);
    for (int k = 0; k < 3; k++) {
        result->eye[k] = import->centre[k] - distance * result->forward[k];
    }
    result->near_plane = 0;
    result->from_file = false;
}

void find_view(importer *import)
{
    view *chosen = &import->view;
    bool found = false;
    for (unsigned i = 0; i < import->file->mNumCameras && !found; i++) {
        found = view_from_file(import, import->file->mCameras[i], chosen);
    }
    if (import->file->mNumCameras > 1) {
        store_warn(import->out, "the file has %u cameras; one is taken", import->file->mNumCameras);
    }
    if (!found) {
        frame_view(import, chosen);
    }

    double to_centre[3];
    for (int k = 0; k < 3; k++) {
        to_centre[k] = import->centre[k] - chosen->eye[k];
    }
    /* The target is where the view passes the objects: far enough for its step of 2^-16 not to turn the view. */
    chosen->distance = fmax(dot3(to_centre, chosen->forward), import->radius);
    double outside = SAFE_NEAR * (length3(to_centre) - import->radius);
    double least = outside > 0 ? outside : INSIDE_NEAR * import->radius;
    if (chosen->near_plane > 0 && outside <= 0) {
        least = chosen->near_plane;
    }
    chosen->near_plane = fmax(chosen->near_plane, least);
}

void write_camera(importer *import)
{
    const view *from = &import->view;
    glint_camera *camera = &import->out->camera;
    for (int k = 0; k < 3; k++) {
        double target = from->eye[k] + from->distance * from->forward[k];
        camera->eye_q16[k] = (int32_t)to_fixed(from->eye[k] * import->world_scale, FIXED_ONE_Q16, 1 << 30);
        camera->target_q16[k] = (int32_t)to_fixed(target * import->world_scale, FIXED_ONE_Q16, 1 << 30);
    }
    to_direction(from->up, camera->up);
    double turn16 = to_fixed(from->field_of_view, TURN16_OF_RADIANS, GREATEST_FIELD_TURN16);
    camera->field_of_view_turn16 = (uint16_t)fmax(LEAST_FIELD_TURN16, turn16);
    double near_q16 = floor(fmin(from->near_plane * import->world_scale, ORIGIN_LIMIT) * FIXED_ONE_Q16);
    camera->near_q16 = (int32_t)fmax(LEAST_NEAR_Q16, near_q16);
    import->out->scene.camera = camera;
}

#endif
