/* SPDX-License-Identifier: MIT */
#include "effects/wire.h"

#include "number/fixed.h"

void glint_wire_set_up(glint_wire *wire, const glint_material *material)
{
    const glint_colour *const colour = &material->wire;
    wire->width_q4 = material->wire_width_q4;
    wire->colour.r_q15 = (uint16_t)((uint16_t)colour->r_q14 << 1);
    wire->colour.g_q15 = (uint16_t)((uint16_t)colour->g_q14 << 1);
    wire->colour.b_q15 = (uint16_t)((uint16_t)colour->b_q14 << 1);
}

bool glint_wire_line_set_up(glint_wire_line *line, const glint_point *from, const glint_point *to, uint16_t width_q4)
{
    const int32_t dx = to->x - from->x, dy = to->y - from->y; /* below 2^20 */
    if ((dx | dy) == 0) {
        return false;
    }
    const int32_t centre = GLINT_SUBPIXEL / 2;
    const int64_t edge = (int64_t)dx * (centre - from->y) - (int64_t)dy * (centre - from->x); /* below 2^41 */
    GLINT_TRACE("wire edge", edge);
    line->value = (uint32_t)(edge >> GLINT_SUBPIXEL_BITS);
    line->step_x = 0u - (uint32_t)dy;
    line->step_y = (uint32_t)dx;
    /* half the width is 8 width_q4 sub-pixels; |d| < 2^21, with 8 bits more */
    const uint64_t square = (uint64_t)((int64_t)dx * dx + (int64_t)dy * dy);
    line->limit = (uint32_t)(((uint64_t)glint_square_root_u64(square << 16) * width_q4 + (1 << 12)) >> 13);
    GLINT_TRACE("wire limit", line->limit);
    return line->limit != 0;
}

uint16_t glint_wire_row(const glint_wire_line *line, int16_t x, int16_t y, uint16_t count)
{
    const uint32_t range = 2 * line->limit - 1;
    const int32_t column = x, row = y;
    uint32_t shifted = line->value + line->step_x * (uint32_t)column + line->step_y * (uint32_t)row;
    uint16_t on = 0;
    shifted += line->limit - 1;
    for (uint16_t i = 0; i < count; i++) {
        if (shifted < range) {
            on = (uint16_t)(on | (uint16_t)(1u << i));
        }
        shifted += line->step_x;
    }
    return on;
}
