/* SPDX-License-Identifier: MIT */
/*
 * The backend EFFECT_BACKEND with GLINT_PARTS, both from the command line: what <glint/parts.h> tells a user to write.
 */
#define HEADER_OF(backend) <glint/backend##_parts.h>
#define HEADER(backend) HEADER_OF(backend)
#include HEADER(EFFECT_BACKEND)
