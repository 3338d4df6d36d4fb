# SPDX-License-Identifier: MIT
#
# inverse_root_q16 of the small tables, first Newton step, on one cell: S = s / 2^30 in [LOW, HIGH], SEED the cell's
# entry. Bounds y sqrt(S) - 1, the relative error of y against 1 / sqrt(S), before y is clamped.
#
# S is written as q * q with q any real number, which includes every input; then the identity of the step is one of
# polynomials: with d = y q - 1, the exact step gives -d^2 (3 + d) / 2.

@q14 = fixed<-14, dn>;
@q16 = fixed<-16, dn>;

S = q * q;
P = q16(SEED * SEED) * q14(S);        # xyy_q30: the product itself is exact
T = q14(3 - P);
Y = q16(SEED * T * 0.5);
EXACT = SEED * (3 - SEED * SEED * S) * 0.5;

{ q in [ROOT_LOW, ROOT_HIGH] /\ S in [LOW, HIGH] ->
    Y * q - 1 in ?
    /\ P in [0.9, 1.1]                # 3 2^30 - xyy_q30 fits uint32_t
    /\ SEED * T * 0.5 in [0, 1.99] }  # y * (...) fits uint32_t, as a Q31

Y * q - 1 -> (EXACT * q - 1) + q * (Y - EXACT);
EXACT * q - 1 -> -0.5 * ((SEED * q - 1) * (SEED * q - 1)) * (3 + (SEED * q - 1));
Y - EXACT -> (Y - SEED * T * 0.5) + 0.5 * SEED * (T - (3 - P)) + 0.5 * SEED * (SEED * SEED * S - P);
SEED * SEED * S - P -> (SEED * SEED - q16(SEED * SEED)) * S + q16(SEED * SEED) * (S - q14(S));
