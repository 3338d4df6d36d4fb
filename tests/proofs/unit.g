# SPDX-License-Identifier: MIT
#
# glint_unit_q15: the error of a component in ulp of Q15, but for the final rounding, where the vector's length is r
# in [R_LOW, R_HIGH] in units of 2^32 after the shift (so its largest component is at least LARGEST, near 1/2), and the
# relative error of 1/|w| is at most ROOT ulp of Q15.
#
# With n = v / |v|, a = |n_k| and T = the sum of the other two magnitudes:
#   - the root's error moves the component by at most ROOT a;
#   - rounding of the components to 16 bits, at most 2^-17 each, moves it by at most the greatest derivative along the
#     way (mean value theorem): 2^-17 / r ((1 - a^2) + a T).
# T is at most sqrt(2 (1 - a^2)). Where neither a nor the equal share of the other two reaches the least that the largest
# component can be, m = LARGEST / r, the largest is another one, and T is at most m + sqrt(1 - a^2 - m^2).
# The weights OWN and OTHERS are 1, or 2 where the clamp to 65535 doubles the rounding of the largest component.
# The caller hands over where a may lie in either case.

even = ROOT * a + 0.25 / r * (OWN * (1 - a * a) + OTHERS * a * sqrt(2 * (1 - a * a)));
# 2^-12 keeps the root real at the end of the range of b
uneven = ROOT * b + 0.25 / r * (OWN * (1 - b * b) + OTHERS * b * (M + sqrt(1 - b * b - M * M + 1b-12)));

{ r in [R_LOW, R_HIGH] /\ a in [A_LOW, A_HIGH] /\ b in [B_LOW, B_HIGH] -> even in ? /\ uneven in ? }

$ a in 60;
$ b in 200;
