/* SPDX-License-Identifier: MIT */
/*
 * The float backend: single precision, for processors with a floating-point unit.
 */
#ifndef GLINT_FLOAT_H
#define GLINT_FLOAT_H

#include <stddef.h>
#include <stdint.h>

#include <glint/display.h>
#include <glint/quality.h>
#include <glint/scene.h>

#ifdef __cplusplus
extern "C" {
#endif

/*
 * Draws one frame of `scene` on `display`. Needs no state from one call to the next, and may run in several threads
 * or interrupts at once with separate memory.
 *
 * memory: `memory_bytes` bytes, aligned like a uint32_t, free for other uses after the return. With at least
 * glint_float_memory_bytes() each vertex is transformed once a frame; with less, down to
 * glint_float_memory_least_bytes(), vertices are transformed again for each band: slower, the same image.
 * report: may be NULL.
 *
 * Returns 0; a glint_error when the arguments are not valid, in which case nothing has been written and `flush` has not
 * been called; or what `flush` returned.
 */
int glint_float_render(const glint_scene *scene, const glint_display *display, const glint_quality *quality,
                       void *memory, size_t memory_bytes, glint_report *report);

/* Bytes with which glint_float_render() transforms each vertex once and sorts each triangle once, and that it needs at
 * least; 0 if a mesh, a count or a field of the display is not valid, or the sum does not fit size_t.
 * GLINT_MEMORY_WORDS in <glint/memory.h> bounds the first at compile time; GLINT_RAMP_WORDS and GLINT_KEPT_WORDS there
 * say what more is good for. */
size_t glint_float_memory_bytes(const glint_scene *scene, const glint_display *display);
size_t glint_float_memory_least_bytes(const glint_scene *scene, const glint_display *display);

/*
 * Variants for programs that have little flash: the same functions, the same pictures, of fewer parts. A scene that
 * asks for more is refused with GLINT_ERROR_PART. The linker takes the variants that a program calls, and no others.
 *
 * A variant looks at what belongs to a part that it has not only as far as it takes to see whether the scene asks for
 * it: a texture of size 0 then gets GLINT_ERROR_PART, and an exponent out of range nothing, where no specular term
 * could show it. All else is checked, with the same codes. These variants have no report: `report` must be NULL, else
 * GLINT_ERROR_PART. They look at each triangle in each band, so they keep no lists of them, and take less memory.
 *
 *   glint_float_phong_    exact shading at each pixel: no tolerance, no q1 and q2, no Gouraud and flat shading
 *   glint_float_diffuse_  of these, only ambient and diffuse terms, only directional lights
 */
int glint_float_phong_render(const glint_scene *scene, const glint_display *display, const glint_quality *quality,
                             void *memory, size_t memory_bytes, glint_report *report);
size_t glint_float_phong_memory_bytes(const glint_scene *scene, const glint_display *display);
size_t glint_float_phong_memory_least_bytes(const glint_scene *scene, const glint_display *display);

int glint_float_diffuse_render(const glint_scene *scene, const glint_display *display, const glint_quality *quality,
                               void *memory, size_t memory_bytes, glint_report *report);
size_t glint_float_diffuse_memory_bytes(const glint_scene *scene, const glint_display *display);
size_t glint_float_diffuse_memory_least_bytes(const glint_scene *scene, const glint_display *display);

/* Those of a choice of parts of the program's own, see <glint/parts.h>; the program's own file defines them. */
int glint_float_parts_render(const glint_scene *scene, const glint_display *display, const glint_quality *quality,
                             void *memory, size_t memory_bytes, glint_report *report);
size_t glint_float_parts_memory_bytes(const glint_scene *scene, const glint_display *display);
size_t glint_float_parts_memory_least_bytes(const glint_scene *scene, const glint_display *display);

#ifdef __cplusplus
}
#endif

#endif
