/* SPDX-License-Identifier: MIT */
/*
 * Float routines without libm: conversion, floor, reciprocal square root, power.
 *
 * The errors stated here are derived again by tests/unit/test_number.c.
 */
#ifndef GLINT_NUMBER_REAL_H
#define GLINT_NUMBER_REAL_H

#include <stdbool.h>
#include <stdint.h>
#include <string.h>

#include <glint/config.h>

static inline float float_from_bits(uint32_t bits)
{
    float value;
    memcpy(&value, &bits, sizeof value);
    return value;
}

static inline uint32_t bits_from_float(float value)
{
    uint32_t bits;
    memcpy(&bits, &value, sizeof bits);
    return bits;
}

/* m 2^-fraction, correctly rounded; fraction within -96..126. */
static inline float float_from_scaled(int32_t m, int fraction)
{
    return (float)m * float_from_bits((uint32_t)(127 - fraction) << 23);
}

/* Largest integer not above value, |value| < 2^31. */
static inline int32_t float_floor(float value)
{
    const int32_t whole = (int32_t)value;
    return (float)whole > value ? whole - 1 : whole;
}

/* 1/sqrt(x) for a normal x > 0. Relative error at most 2^-23. */
float glint_inverse_root(float x);

/* (1 - gap)^exponent for gap in [0, 1], exponent >= 0; 0 for gap = 1 unless the exponent is 0: then 1. Error at most
 * 2e-7. */
float glint_power(float gap, float exponent);

#endif
