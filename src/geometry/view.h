/* SPDX-License-Identifier: MIT */
/*
 * From the scene's fixed formats to the numbers that a frame needs: the camera's basis and focal length, each object's
 * model-to-view matrix, and the frame in which its surface is lit.
 *
 * All of it is integer arithmetic shared by both backends; the float backend converts the results once an object.
 * 64-bit products, no division.
 *
 * The lighting frame of an object has its origin at the eye and world units. Where the object's place is a rotation,
 * possibly mirrored, times a uniform scale, its axes are the model's, so that the mesh's normals are used as they are
 * stored. Otherwise its axes are the view's, and normals are transformed by the inverse transpose.
 */
#ifndef GLINT_GEOMETRY_VIEW_H
#define GLINT_GEOMETRY_VIEW_H

#include <glint/scene.h>

#include "number/fixed.h"

/*
 * Screen coordinates: x right, y down, origin at the top left corner of the top left pixel. A projected vertex has 12
 * fractional bits. Coverage is decided on the vertex snapped to the 1/256 px grid; what is interpolated over the
 * triangle is set up from the vertex itself, so that snapping does not shift the shading of thin triangles.
 */
#define GLINT_SUBPIXEL_BITS 8
#define GLINT_SUBPIXEL ((int32_t)1 << GLINT_SUBPIXEL_BITS)
#define GLINT_FINE_BITS 12
#define GLINT_FINE ((int32_t)1 << GLINT_FINE_BITS)

/* The guard band: projected vertices farther than this from the display's centre are clipped away. */
#define GLINT_GUARD_PX 1440

/*
 * Inverse depth. 1/Z is kept as depth_q30 = GLINT_DEPTH_BIAS + GLINT_DEPTH_SPAN near / Z, of which the depth buffer
 * holds the upper 16 of 30 bits: 64..65472. The margins of 64 steps at both ends take what interpolation may overshoot
 * (raster/gradients.h), so that no clamp is needed, and leave 0 for "nothing there".
 */
#define GLINT_DEPTH_SHIFT 14
#define GLINT_DEPTH_BIAS ((int32_t)64 << GLINT_DEPTH_SHIFT)
#define GLINT_DEPTH_SPAN ((int32_t)65408 << GLINT_DEPTH_SHIFT)

typedef struct glint_view {
    int32_t basis_q30[3][3]; /* rows: right, down, forward in world coordinates */
    int32_t eye_q16[3];
    glint_scaled focal_px;         /* px for a view coordinate as large as its distance */
    glint_scaled inverse_focal_px; /* 1 / focal_px */
    glint_scaled near_units;       /* distance of the near plane, world units */
    uint16_t width_px, height_px;
} glint_view;

/* Camera must be valid (see glint_camera_check). */
void glint_view_set_up(glint_view *view, const glint_camera *camera, uint16_t width_px, uint16_t height_px);

/* The angle between the rays through two neighbouring pixels is at most 1 / focal_px; radians, rounded up, Q18. */
uint32_t glint_view_pixel_q18(const glint_view *view);

/* GLINT_OK or the error of the camera's directions; the ranges of its fields have been checked. */
int glint_camera_check(const glint_camera *camera);

/*
 * Model to view for one object: with p the int16 position, a coordinate is
 *     (row[0] p_x + row[1] p_y + row[2] p_z) / 2^16 + row[3],
 * a number with `xy_fraction` (for X and Y, in px times world units: multiplied by the focal length) or `z_fraction`
 * (for Z, in world units) fractional bits. Its magnitude is below 2^30.
 */
typedef struct glint_transform {
    int32_t x[4], y[4], z[4];
    int16_t xy_fraction, z_fraction;
    int32_t near_z;          /* the near plane in units of Z, at least 1 */
    glint_scaled depth_near; /* near GLINT_DEPTH_SPAN */
} glint_transform;

/*
 * The lighting frame of one object.
 */
typedef struct glint_frame {
    /* The ray through the centre of pixel (x, y), in the lighting frame, with a forward component of 1 world unit:
     * ray[0] + x ray[1] + y ray[2], `ray_fraction` fractional bits, below 2^30 over the display. */
    int32_t ray[3][3];
    int16_t ray_fraction;
    bool mirrored;                /* the object's place has a negative determinant */
    bool model_axes;              /* normals are used as they are */
    int32_t normal_rows[3][3];    /* otherwise: normal = rows . stored normal, any scale; sums of |row| below 2^30 */
    int32_t from_world_q30[3][3]; /* lighting-frame components of a world vector */
} glint_frame;

void glint_transform_set_up(glint_transform *transform, const glint_view *view, const glint_object *object);
/*
 * Model position to lighting frame, for shading at corners: rows as in glint_transform, in units of the near distance,
 * with `fraction` fractional bits common to the three rows; magnitude below 2^30.
 */
typedef struct glint_placement {
    int32_t rows[3][4];
    int16_t fraction;
} glint_placement;

void glint_placement_set_up(glint_placement *placement, const glint_frame *frame, const glint_view *view,
                            const glint_object *object);

void glint_frame_set_up(glint_frame *frame, const glint_view *view, const glint_object *object);

/* Unit direction (Q30) in the lighting frame from the surface to a directional light. */
void glint_light_direction(const glint_frame *frame, const glint_light *light, int32_t unit_q30[3]);

/*
 * A point light's position in the lighting frame, in units of the near distance, as position[k] 2^-fraction with the
 * greatest component of 30 bits; fraction is at most 29.
 */
void glint_light_position(const glint_frame *frame, const glint_view *view, const glint_light *light,
                          int32_t position[3], int16_t *fraction);

/* GLINT_OK, GLINT_ERROR_PLACE_RANGE or GLINT_ERROR_PLACE_SINGULAR. */
int glint_place_check(const glint_place *place);

#endif
