# SPDX-License-Identifier: MIT
#
# inverse_root_q16 of the small tables, second Newton step, on one cell: S = q * q in [LOW, HIGH], y a Q16 number whose
# relative error y q - 1 lies in [ERROR_LOW, ERROR_HIGH], as the first step left it after the clamp. Bounds the relative
# error of the result before the last clamp, which takes 1 and what lies above it to 1 - 2^-16: since 1 / sqrt(S) <= 1
# the error then lies between -2^-16 and what is proved here.

@q30 = fixed<-30, dn>;
@q22 = fixed<-22, dn>;
@nearest = fixed<-16, nu>;

S = q * q;
y = fixed<-16, dn>(any);
E = q22(1 - q30(y * y * S));          # residual_q30 >> 8
Y = y + nearest(y * E * 0.5);
EXACT = y + y * (1 - y * y * S) * 0.5;

{ q in [ROOT_LOW, ROOT_HIGH] /\ S in [LOW, HIGH] /\ y * q - 1 in [ERROR_LOW, ERROR_HIGH] ->
    Y * q - 1 in ?
    /\ |y * E| <= 0.00390625 }        # (int32_t)y * (residual_q30 >> 8) fits int32_t, as a Q38: below 2^30

Y * q - 1 -> (EXACT * q - 1) + q * (Y - EXACT);
EXACT * q - 1 -> -0.5 * ((y * q - 1) * (y * q - 1)) * (3 + (y * q - 1));
Y - EXACT -> (nearest(y * E * 0.5) - y * E * 0.5) + 0.5 * y * ((E - (1 - q30(y * y * S))) - (q30(y * y * S) - y * y * S));
y -> (1 + (y * q - 1)) / q { q <> 0 };
1 - y * y * S -> -(y * q - 1) * (2 + (y * q - 1));
y * y * S -> 1 - (1 - y * y * S);
