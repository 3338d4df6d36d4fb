/* SPDX-License-Identifier: MIT */
/*
 * The ways of shading a frame, as the last members of a cost_case: its name, the tolerance in words, the quality.
 */
#ifndef TOOLS_COST_SHADINGS_H
#define TOOLS_COST_SHADINGS_H

/* The cheapest tiers within a tolerance in codes. */
#define WITHIN(codes)                                                                                                  \
    "auto", #codes,                                                                                                    \
    {                                                                                                                  \
        .tolerance = GLINT_CODES(codes)                                                                                \
    }

/* Shadings that are forced for the whole frame. */
#define EXACT                                                                                                          \
    "exact", "-",                                                                                                      \
    {                                                                                                                  \
        .shading = GLINT_SHADING_EXACT                                                                                 \
    }
#define GOURAUD                                                                                                        \
    "Gouraud", "-",                                                                                                    \
    {                                                                                                                  \
        .shading = GLINT_SHADING_GOURAUD                                                                               \
    }
#define FLAT                                                                                                           \
    "flat", "-",                                                                                                       \
    {                                                                                                                  \
        .shading = GLINT_SHADING_FLAT                                                                                  \
    }
#define Q1                                                                                                             \
    "q1", "-",                                                                                                         \
    {                                                                                                                  \
        .shading = GLINT_SHADING_Q1                                                                                    \
    }
#define Q2                                                                                                             \
    "q2", "-",                                                                                                         \
    {                                                                                                                  \
        .shading = GLINT_SHADING_Q2                                                                                    \
    }

#endif
