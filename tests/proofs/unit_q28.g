# SPDX-License-Identifier: MIT
#
# glint_unit_q28: the error of a component in ulp of Q28, but for the final rounding, where S = sum / 2^30 = q * q lies in
# [ROOT_LOW^2, ROOT_HIGH^2] and inverse_root_q16 gave a Q16 number y with a relative error y q - 1 in [ERROR_LOW,
# ERROR_HIGH].
#
# Each of the three squares in the sum loses less than 1 (two floor divisions in a row are one, by 2^34), so the sum is
# `lost` in [0, 3] too small, of 2^28 S or more. The Newton step in residual form goes from d = y q - 1 to -d^2 (3 + d) / 2.
# The components are exact, and theirs are two floor divisions and a rounding in a row, which are one rounding. A
# component's share of the error of the length is at most all of it.

@q28 = fixed<-28, dn>;
@q30 = fixed<-30, dn>;
@q31 = fixed<-31, dn>;

S = q * q;
y = fixed<-16, dn>(any);
SQUARE = q30(y * y);                  # the inner multiply_high_u32
E = 1 - q28(SQUARE * S);              # residual_q28
D = q31(y * E * 0.5);
Y = y + D;
EXACT = y + y * (1 - y * y * S) * 0.5;
unit_q28 = 268435456 * ((Y * q - 1) + 0.5 * 1b-28 * lost / S);

{ q in [ROOT_LOW, ROOT_HIGH] /\ S in [LOW, HIGH] /\ y * q - 1 in [ERROR_LOW, ERROR_HIGH] /\ lost in [0, 3] ->
    unit_q28 in ?
    /\ |E| <= 0.0625                  # residual_q28 * 8 fits int32_t, as a Q31
    /\ Y in [0.49, 1.01] }            # y_q31 fits uint32_t

unit_q28 -> 268435456 * (Y * q - 1) + 0.5 * lost / S;
Y * q - 1 -> (EXACT * q - 1) + q * (Y - EXACT);
EXACT * q - 1 -> -0.5 * ((y * q - 1) * (y * q - 1)) * (3 + (y * q - 1));
Y - EXACT -> (D - y * E * 0.5) + 0.5 * y * ((SQUARE * S - q28(SQUARE * S)) + (y * y - SQUARE) * S);
y -> (1 + (y * q - 1)) / q { q <> 0 };
1 - y * y * S -> -(y * q - 1) * (2 + (y * q - 1));
SQUARE * S -> y * y * S - (y * y - SQUARE) * S;
y * y * S -> 1 - (1 - y * y * S);
