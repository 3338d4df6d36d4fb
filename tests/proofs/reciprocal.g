# SPDX-License-Identifier: MIT
#
# glint_reciprocal_q31 on one cell of its table: X = x / 2^31 in [LOW, HIGH], SEED the cell's entry.
# Proves |X r - 1|, which is the relative error of r against 1 / X, and that no intermediate leaves its 32 bits.
#
# A Newton step squares the residual 1 - X r. That identity is algebra and is stated below, with what each rounding of
# the C code adds. XH is the upper half of x; the first step takes XH + 2^-16 for X.

@q15 = fixed<-15, dn>;
@q16 = fixed<-16, dn>;
@q22 = fixed<-22, dn>;
@q29 = fixed<-29, dn>;
@q30 = fixed<-30, dn>;
@q31 = fixed<-31, dn>;

XH = q15(X);
R0 = SEED;
E0 = 1 + 1b-15 - XH * R0 - q30(R0 * 1b-16);
D0 = q16(R0 * q22(E0) + 1b-17);
R1 = R0 + D0;
E1 = 1 + 5b-31 - XH * R1 - q31((X - XH) * R1);
D1 = q31(R1 * q29(E1));
R2 = R1 + D1;

{ X in [LOW, HIGH] ->
    1 - X * R2 in ?
    /\ |E0| <= 0.0078125      # 2^23 in Q30: the product with the seed fits
    /\ |E1| <= 6.103515625e-5 # 2^17 in Q31, 2^15 in Q29: the product with r fits
    /\ R1 in [0.49, 1] }

1 - X * R1 -> (1 - X * R0) * (1 - X * R0) - X * R0 * (E0 - (1 - X * R0)) - X * (D0 - R0 * E0);
E0 - (1 - X * R0) -> 1b-15 + (X - XH - 1b-16) * R0 + (R0 * 1b-16 - q30(R0 * 1b-16));
D0 - R0 * E0 -> (q16(R0 * q22(E0) + 1b-17) - (R0 * q22(E0) + 1b-17)) + 1b-17 + R0 * (q22(E0) - E0);
1 - X * R2 -> (1 - X * R1) * (1 - X * R1) - X * R1 * (E1 - (1 - X * R1)) - X * (D1 - R1 * E1);
E1 - (1 - X * R1) -> 5b-31 + ((X - XH) * R1 - q31((X - XH) * R1));
D1 - R1 * E1 -> (q31(R1 * q29(E1)) - R1 * q29(E1)) + R1 * (q29(E1) - E1);
E1 -> (1 - X * R1) + 5b-31 + ((X - XH) * R1 - q31((X - XH) * R1));
R1 -> (1 - (1 - X * R1)) / X { X <> 0 };
