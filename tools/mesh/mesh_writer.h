/* SPDX-License-Identifier: MIT */
/*
 * From a shape in double precision to a C source with a glint_mesh.
 */
#ifndef TOOLS_MESH_MESH_WRITER_H
#define TOOLS_MESH_MESH_WRITER_H

#include <stdio.h>

#include "shape.h"

/*
 * Welds points that coincide after quantisation and whose normals agree within 1 degree, drops the triangles that this
 * makes empty, chooses the greatest fraction_bits that holds all positions, and prints the source.
 *
 * out: where to print. command: for the first line. name: a C identifier.
 * Returns 0, or 1 with a message on stderr and nothing printed: more than 65,535 vertices or triangles; a triangle
 * without area after quantisation; a normal at 90 degrees or more from a face that uses it; a failed write.
 */
int mesh_write(FILE *out, const shape *from, const char *name, const char *command);

#endif
