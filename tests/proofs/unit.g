# SPDX-License-Identifier: MIT
#
# glint_unit_q15: the error of a component in ulp of Q15, but for the final rounding, where the vector's length is r in
# [R_LOW, R_HIGH] in units of 2^32 after the shift, so that its largest component is at least m = 1/2 / r of it, and the
# relative error of 1/|w| is at most ROOT ulp of Q15.
#
# With n = v / |v|, a = |n_k| and T = the sum of the other two magnitudes:
#   - the root's error moves the component by at most ROOT a;
#   - the bits that are dropped, each component standing for itself plus 1/2 of 2^-16 from there on, are off by at most
#     2^-17 a component: that moves it by at most the greatest derivative along the way (mean value theorem), 2^-17 / r
#     ((1 - a^2) + a T).
# T is at most sqrt(2 (1 - a^2)): that is `even`. Where neither a nor the equal share of the other two reaches m, the
# largest is another one, and T is at most m + sqrt(1 - a^2 - m^2): that is `uneven`. The caller hands over which, M just
# below m, and where a may lie then.

even = ROOT * a + 0.25 / r * (1 - a * a + a * sqrt(2 * (1 - a * a)));
# 2^-12 keeps the root real at the end of the range of a
uneven = ROOT * a + 0.25 / r * (1 - a * a + a * (M + sqrt(1 - a * a - M * M + 1b-12)));

{ r in [R_LOW, R_HIGH] /\ a in [A_LOW, A_HIGH] -> CASE in ? }

$ a in PIECES;
