/* SPDX-License-Identifier: MIT */
/*
 * The fixed backend: the pipeline's bodies with fixed operations.
 */
#include <glint/fixed.h>

#include <stddef.h>
#include <string.h>

#include <glint/error.h>
#include <glint/memory.h>
#include <glint/plan.h>

#include "display/flush.h"
#include "effects/shadow.h"
#include "geometry/vertex_fixed.h"
#include "lighting/gloss_fixed.h"
#include "lighting/reach_fixed.h"
#include "memory.h"
#include "raster/attribute_fixed.h"
#include "raster/bands.h"
#include "raster/depth.h"
#include "raster/units_fixed.h"
#include "validate.h"

#include "lighting/terms.inc"

#include "geometry/object.inc"

#include "geometry/clip.inc"

#include "lighting/tier.inc"

#include "lighting/shade.inc"

#include "lighting/span.inc"

#include "render.inc"

int glint_fixed_render(const glint_scene *scene, const glint_display *display, const glint_quality *quality,
                       void *memory, size_t memory_bytes, glint_report *report)
{
    return render(scene, display, quality, memory, memory_bytes, report);
}

size_t glint_fixed_memory_bytes(const glint_scene *scene, const glint_display *display)
{
    return memory_size(scene, display, false);
}

size_t glint_fixed_memory_least_bytes(const glint_scene *scene, const glint_display *display)
{
    return memory_size(scene, display, true);
}
