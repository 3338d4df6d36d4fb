/* SPDX-License-Identifier: MIT */
/*
 * Parts of a backend that a program may do without, see <glint/parts.h>. Each variant of a backend is the same bodies
 * compiled with GLINT_PARTS as a constant: what a part does stands behind HAS(part), so that the compiler leaves it
 * out, and the linker takes only the variants that a program calls. A scene that asks for a part that its variant has
 * not is refused, never drawn otherwise.
 */
#ifndef GLINT_BACKEND_PARTS_H
#define GLINT_BACKEND_PARTS_H

#include <glint/parts.h>

#ifndef GLINT_PARTS
#define GLINT_PARTS GLINT_PARTS_ALL
#endif

/* What comes between shading and packing. */
#define PARTS_AFTER_SHADING (GLINT_PART_FOG | GLINT_PART_TRANSMISSION | GLINT_PART_WIRE)

/* With those that the parts named bring with them. */
#define PARTS_ALL_TOLD                                                                                                 \
    ((GLINT_PARTS) | ((GLINT_PARTS) & (GLINT_PART_TIERS | PARTS_AFTER_SHADING) ? GLINT_PART_SPANS : 0) |               \
     ((GLINT_PARTS) & (GLINT_PART_REACH | GLINT_PART_EXTENTS) ? GLINT_PART_POINTS : 0))

/* Is one of the parts there? */
#define HAS(parts) ((PARTS_ALL_TOLD & (parts)) != 0)

#endif
