# SPDX-License-Identifier: MIT
#
# inverse_root_q16 from the table of 192 cells, on one of them: S = s / 2^30 = q * q from qa * qa = 1 + i/64 up to but
# not including qb * qb = 1 + (i+1)/64, LEFT and RIGHT the entries at these ends. Bounds y sqrt(S) - 1, the relative
# error of y against 1 / sqrt(S), as a sum of three:
#   - the chord of 1/sqrt from end to end lies above the curve, by (q - qa) (qb - q) (q + qa + qb) / (qa qb (qa + qb))
#     of its value: polynomial algebra, which Gappa checks;
#   - the entries are not the curve's values, and a line between them is off by their errors, each in its share;
#   - the fraction within the cell loses bits, and so does what is subtracted: both leave the result too large.
#
# qa and qb are square roots, here numbers of an interval of 10^-12 around them. Each hint divides by these alone, and by
# the cell's width.

@q16 = fixed<-16, dn>;

fraction = (q * q - qa * qa) / (qb * qb - qa * qa);
kept = q16(fraction);                       # s_q30 >> 8 & 0xffff
drop = q16((LEFT - RIGHT) * kept);
Y = LEFT - drop;
LINE = LEFT - (LEFT - RIGHT) * fraction;
CHORD = 1 / qa - (1 / qa - 1 / qb) * fraction;

{ qa in [QA_LOW, QA_HIGH] /\ qb in [QB_LOW, QB_HIGH] /\ q in [QA_LOW, QB_HIGH] /\ kept in [0, 65535b-16] ->
    Y * q - 1 in ?
    /\ (LEFT - RIGHT) * kept <= 0.99999 }   # the product fits uint32_t, as a Q32

Y * q - 1 -> (CHORD * q - 1) + q * (LINE - CHORD) + q * (Y - LINE);
CHORD * q - 1 -> (q - qa) * (qb - q) * (q + qa + qb) / (qa * qb * (qa + qb))
    { qa <> 0, qb <> 0, qa + qb <> 0, qb * qb - qa * qa <> 0 };
LINE - CHORD -> (LEFT - 1 / qa) + fraction * ((RIGHT - 1 / qb) - (LEFT - 1 / qa));
Y - LINE -> (LEFT - RIGHT) * (fraction - kept) + ((LEFT - RIGHT) * kept - drop);

$ q in PIECES;
