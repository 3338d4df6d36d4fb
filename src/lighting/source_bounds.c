/* SPDX-License-Identifier: MIT */
/*
 * The errors of the rules of lighting/source.h, as tests/unit/test_source_bounds.c finds them and holds them to.
 */
#include "lighting/source.h"
#include "number/integer.h"

#define ONE_Q16 ((uint32_t)1 << 16)
#define PART(share) ((uint16_t)((share)*65536.0))

/* Over the size: the error of a kink that crosses the source is proportional to how much the cosine changes over it.
 * For sources up to half as large as far away, for any, and for any that is attenuated: the quotient and the window
 * have kinks of their own, up to four times as sharp. */
enum { UP_TO_HALF, UP_TO_ONE, FADES, CLASSES };
static const GLINT_FLASH uint16_t diffuse_q16[2][CLASSES][GLINT_SOURCE_RULES] = {
    {
        {PART(0.300), PART(0.0640), PART(0.0240), PART(0.00860), PART(0.00520)},
        {PART(0.310), PART(0.0800), PART(0.0480), PART(0.02800), PART(0.01250)},
        {PART(0.999), PART(0.2300), PART(0.0950), PART(0.05000), PART(0.03000)},
    },
    {
        {PART(0.310), PART(0.1800), PART(0.0600), PART(0.01700), PART(0.00950)},
        {PART(0.420), PART(0.2500), PART(0.1000), PART(0.04000), PART(0.02400)},
        {PART(0.999), PART(0.4800), PART(0.1700), PART(0.06400), PART(0.03400)},
    },
};

/* By (size^2 exponent), steps of a factor of 2 from 1/16 on; the last one up to what there is. */
#define SPREADS 12
static const GLINT_FLASH uint16_t specular_q16[2][GLINT_SOURCE_RULES][SPREADS] = {
    {
        {PART(0.01288), PART(0.02551), PART(0.05009), PART(0.09767), PART(0.18554), PART(0.32730), PART(0.54264),
         PART(0.75688), PART(0.99900), PART(0.99900), PART(0.99900), PART(0.99900)},
        {PART(0.00050), PART(0.00097), PART(0.00202), PART(0.00673), PART(0.01705), PART(0.03264), PART(0.05091),
         PART(0.09999), PART(0.20726), PART(0.34230), PART(0.43535), PART(0.57917)},
        {PART(0.00010), PART(0.00024), PART(0.00079), PART(0.00250), PART(0.00492), PART(0.03560), PART(0.04116),
         PART(0.04116), PART(0.04777), PART(0.07233), PART(0.15611), PART(0.30659)},
        {PART(0.00010), PART(0.00010), PART(0.00032), PART(0.00082), PART(0.00111), PART(0.01746), PART(0.01746),
         PART(0.02011), PART(0.02635), PART(0.04127), PART(0.04127), PART(0.11681)},
        {PART(0.00010), PART(0.00010), PART(0.00017), PART(0.00061), PART(0.00130), PART(0.00829), PART(0.00829),
         PART(0.00829), PART(0.01071), PART(0.01539), PART(0.02098), PART(0.06789)},
    },
    {
        {PART(0.02587), PART(0.05143), PART(0.10151), PART(0.19751), PART(0.37137), PART(0.62370), PART(0.85151),
         PART(0.99900), PART(0.99900), PART(0.99900), PART(0.99900), PART(0.99900)},
        {PART(0.01450), PART(0.02326), PART(0.03651), PART(0.05195), PART(0.14654), PART(0.14654), PART(0.24021),
         PART(0.32027), PART(0.38344), PART(0.44506), PART(0.44506), PART(0.46645)},
        {PART(0.00262), PART(0.00430), PART(0.00639), PART(0.01535), PART(0.03470), PART(0.07749), PART(0.07749),
         PART(0.08113), PART(0.10719), PART(0.12914), PART(0.14739), PART(0.16816)},
        {PART(0.00037), PART(0.00060), PART(0.00146), PART(0.00298), PART(0.00650), PART(0.03238), PART(0.03654),
         PART(0.04137), PART(0.04456), PART(0.04529), PART(0.06371), PART(0.07461)},
        {PART(0.00026), PART(0.00041), PART(0.00079), PART(0.00110), PART(0.00339), PART(0.02045), PART(0.02045),
         PART(0.02281), PART(0.02305), PART(0.02311), PART(0.03489), PART(0.04086)},
    },
};

/* Over the greatest specular factor at the gate: the area that a straight line cuts off, and the points. */
static const GLINT_FLASH uint16_t gate_q16[GLINT_SOURCE_RULES] = {PART(0.6), PART(0.36), PART(0.24), PART(0.135),
                                                                  PART(0.1)};

static int kind_of(const glint_light *light)
{
    return light->kind == GLINT_BALL;
}

uint32_t glint_source_diffuse_q16(const glint_light *light, uint8_t rule, uint32_t size_q16, bool fades)
{
    const int class = fades ? FADES : size_q16 <= ONE_Q16 / 2 ? UP_TO_HALF : UP_TO_ONE;
    return size_q16 >= ONE_Q16
               ? ONE_Q16
               : ((uint32_t)flash_u16(&diffuse_q16[kind_of(light)][class][rule]) * (size_q16 >> 4) >> 12) + 1;
}

uint32_t glint_source_specular_q16(const glint_light *light, uint8_t rule, uint32_t size_q16, uint16_t exponent_q4,
                                   bool fades)
{
    if (size_q16 >= ONE_Q16 || exponent_q4 < 16) {
        return ONE_Q16;
    }
    const uint32_t size_q12 = (size_q16 >> 4) + 1;
    const uint32_t spread_q16 = ((size_q12 * size_q12 + 255) >> 8) * ((uint32_t)exponent_q4 + 15) >> 4; /* < 2^28 */
    int class = 0;
    while (class < SPREADS - 1 && spread_q16 > (ONE_Q16 / 16) << class) {
        class ++;
    }
    const uint32_t smooth_q16 = flash_u16(&specular_q16[kind_of(light)][rule][class]);
    /* a cosine to a power below 2 has a kink, as the cosine itself; attenuation has others */
    return smooth_q16 + (fades || exponent_q4 < 32 ? glint_source_diffuse_q16(light, rule, size_q16, fades) : 0);
}

uint32_t glint_source_gate_q16(uint8_t rule)
{
    return flash_u16(&gate_q16[rule]);
}
