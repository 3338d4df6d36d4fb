# SPDX-License-Identifier: MIT
#
# The roundings from light to the display: src/lighting/light_fixed.h and src/display/pack.c, each against the exact
# value of what it rounds. All results in the unit of the result's last place, the last one in codes of 1/255.

@floor = fixed<0, dn>;
@q15 = fixed<-15, nu>;
@q16 = fixed<-16, nu>;

v = fixed<-15, dn>(v_);

# level(): G greatest level, a threshold of 1/2, or of (2 rank + 1) / 128
G = floor(G_);
level_nearest = floor(v * G + 0.5) - v * G;
threshold = fixed<-7, dn>(threshold_);
level_dithered = floor(v * G + threshold) - v * G;

# luma_q15(): the weights are whole numbers of 1/256
luma = (q15(0.30078125 * v + 0.5859375 * green + 0.11328125 * blue)
    - (0.30078125 * v + 0.5859375 * green + 0.11328125 * blue)) * 32768;

# light_multiply(): reflectance and intensity in Q14
reflectance = fixed<-14, dn>(reflectance_);
intensity = fixed<-14, dn>(intensity_);
product = q15(reflectance * intensity);
multiply = (product - reflectance * intensity) * 32768;

# light_add(): factor in Q15
factor = fixed<-15, dn>(factor_);
add = (q16(product * factor) - product * factor) * 65536;

# light_clamp(): Q16 to Q15
sum = fixed<-16, dn>(sum_);
clamp = (q15(sum) - sum) * 32768;

# a colour of one ambient term, one diffuse and one specular term, each rounded as above, in codes
ambient = q15(reflectance_a * intensity_a);
specular = q15(reflectance_s * intensity_s);
total = ambient + q16(product * factor) + q16(specular * factor_s);
exact = reflectance_a * intensity_a + reflectance * intensity * factor + reflectance_s * intensity_s * factor_s;
colour = 255 * (q15(total) - exact);

{ v in [0, 1] /\ G in [1, 255] /\ threshold in [1b-7, 127b-7] /\ green in [0, 1] /\ blue in [0, 1]
    /\ reflectance in [0, 1] /\ intensity in [0, 1.99994] /\ factor in [0, 1] /\ sum in [0, 1]
    /\ reflectance_a in [0, 1] /\ intensity_a in [0, 1.99994]
    /\ reflectance_s in [0, 1] /\ intensity_s in [0, 1.99994] /\ factor_s in [0, 1] ->
    level_nearest in ? /\ level_dithered in ? /\ luma in ? /\ multiply in ? /\ add in ? /\ clamp in ? /\ colour in ?
    /\ reflectance * intensity * 268435456 + 4096 <= 4294967295   # the product and its rounding fit uint32_t
    /\ product * factor * 1073741824 + 8192 <= 4294967295 }

level_nearest -> (floor(v * G + 0.5) - (v * G + 0.5)) + 0.5;
level_dithered -> (floor(v * G + threshold) - (v * G + threshold)) + threshold;
colour -> 255 * ((q15(total) - total) + (ambient - reflectance_a * intensity_a)
    + (q16(product * factor) - product * factor) + factor * (product - reflectance * intensity)
    + (q16(specular * factor_s) - specular * factor_s) + factor_s * (specular - reflectance_s * intensity_s));
