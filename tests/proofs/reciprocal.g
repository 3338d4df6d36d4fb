# SPDX-License-Identifier: MIT
#
# glint_reciprocal_q31 on one cell of its table: X = x / 2^31 in [LOW, HIGH], SEED the cell's entry.
# Proves |X r - 1|, which is the relative error of r against 1 / X, and that no intermediate leaves its 32 bits.
#
# A Newton step squares the residual 1 - X r. That identity is algebra and is stated below, with what each rounding of
# the C code adds. Both high products round down: they are floor divisions by 2^32.

@q30 = fixed<-30, dn>;
@q31 = fixed<-31, dn>;

R0 = SEED;
E0 = 1 - q30(X * R0);       # residual_q30 of the first step
D0 = q31(R0 * E0);
R1 = R0 + D0;
E1 = 1 - q30(X * R1);
D1 = q31(R1 * E1);
R2 = R1 + D1;

{ X in [LOW, HIGH] ->
    1 - X * R2 in ?
    /\ |E0| <= 0.49 /\ |E1| <= 0.49   # four times a residual fits int32_t
    /\ R1 in [0.49, 1.01] }           # that r stays below 2^31, measure.c checks for every input

1 - X * R1 -> (1 - X * R0) * (1 - X * R0) - X * R0 * (E0 - (1 - X * R0)) - X * (D0 - R0 * E0);
1 - X * R2 -> (1 - X * R1) * (1 - X * R1) - X * R1 * (E1 - (1 - X * R1)) - X * (D1 - R1 * E1);
R1 -> (1 - (1 - X * R1)) / X { X <> 0 };
