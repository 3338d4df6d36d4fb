/* SPDX-License-Identifier: MIT */
#include "effects/shadow_mask.h"

/* Sets bits first..last of a row. */
static void fill_row(uint32_t *row, int first, int last)
{
    const int from = first >> 5, to = last >> 5;
    const uint32_t head = 0xffffffffu << (first & 31), tail = 0xffffffffu >> (31 - (last & 31));
    if (from == to) {
        row[from] |= head & tail;
        return;
    }
    row[from] |= head;
    for (int i = from + 1; i < to; i++) {
        row[i] = 0xffffffffu;
    }
    row[to] |= tail;
}

/* One of the lines from row to row: its value at a pixel, what it grows by for a pixel inwards and for a row down, and
 * how many pixels that one is from the box's end: 0..columns, where the row is empty. */
typedef struct side_state {
    uint32_t value, inwards, down;
    int inset;
} side_state;

/* Moves to the outermost pixel of the row that the line holds inside, and the value to the row below. A line moves one
 * way over all rows, so that all steps together are at most two for each column. */
static int side_move(side_state *side, int columns)
{
    uint32_t value = side->value;
    int inset = side->inset;
    if ((int32_t)value < 0) {
        while (inset != columns) {
            inset++;
            value += side->inwards;
            if ((int32_t)value >= 0) {
                break;
            }
        }
    } else {
        while (inset != 0 && (int32_t)(value - side->inwards) >= 0) {
            value -= side->inwards;
            inset--;
        }
    }
    side->value = value + side->down;
    side->inset = inset;
    return inset;
}

void glint_shadow_fill(const glint_shadows *shadows, uint32_t *mask, const glint_box *box, const glint_shadow_line l[4])
{
    const int columns = box->x_last - box->x_first + 1;
    const int16_t y_first = box->y_first > shadows->y_first ? box->y_first : shadows->y_first;
    const int16_t y_last = box->y_last < shadows->y_last ? box->y_last : shadows->y_last;
    side_state side[4];
    for (int i = 0; i < 4; i++) {
        const int32_t begin = l[i].step_x < 0 ? columns - 1 : 0, rows = (int32_t)y_first - box->y_first;
        side[i].value =
            (uint32_t)l[i].value + (uint32_t)l[i].step_x * (uint32_t)begin + (uint32_t)l[i].step_y * (uint32_t)rows;
        GLINT_TRACE("shadow line", (int32_t)side[i].value);
        side[i].inwards = magnitude32(l[i].step_x);
        side[i].down = (uint32_t)l[i].step_y;
        side[i].inset = 0;
    }
    for (int16_t y = y_first; y <= y_last; y++) {
        int left = 0, right = 0;
        for (int i = 0; i < 4; i++) {
            if (l[i].step_x == 0) { /* all of the row, or nothing */
                left = (int32_t)side[i].value < 0 ? columns : left;
                side[i].value += side[i].down;
                continue;
            }
            const int inset = side_move(&side[i], columns);
            int *const end = l[i].step_x > 0 ? &left : &right;
            *end = inset > *end ? inset : *end;
        }
        if (left + right < columns) {
            fill_row(mask + (uint32_t)(y - shadows->y_first) * shadows->words, box->x_first + left,
                     box->x_last - right);
        }
    }
}

void glint_shadow_clear(const glint_shadows *shadows, uint32_t *mask, const glint_box *box)
{
    const int from = box->x_first >> 5, to = box->x_last >> 5;
    for (int16_t y = box->y_first; y <= box->y_last && y <= shadows->y_last; y++) {
        if (y >= shadows->y_first) {
            uint32_t *const row = mask + (uint32_t)(y - shadows->y_first) * shadows->words;
            for (int i = from; i <= to; i++) {
                row[i] = 0;
            }
        }
    }
}
