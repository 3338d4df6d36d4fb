# SPDX-License-Identifier: MIT
#
# glint_power_q15 where floor(a t) = WHOLE and the fraction of a t lies in one quarter of its range: there the table of
# 2^-fraction, interpolated, is off by X_ERROR_LOW to X_ERROR_HIGH, and the interpolated slope is off by SLOPE_LOW to
# SLOPE_HIGH of itself. measure.c finds both over every entry and fraction that interpolate() can see.
#
# a is the exponent, z = a (k + L) the exact -log2 of the result, G = 2^-z, at the computed z. Then 2^-at - G =
# -G (at - z) C with C = (1 - 2^-(at - z)) / (at - z), near ln 2, within [C_LOW, C_HIGH] as long as |at - z| <= DELTA:
# proved too.
# u 2^-u <= 1 / (e ln 2) < 0.5308 for every u, and it falls from u = 1.4427 on: ZG_HIGH.

@q29 = fixed<-29, dn>;
@q26 = fixed<-26, nu>;
@q14 = fixed<-14, dn>;
@q15 = fixed<-15, dn>;

product = L * (1 + slope_error);                 # y times the interpolated slope
t = k + q26(q29(product));
at = q14(a * t);
z = a * (k + L);
X = q15(any_number);                             # interpolate(): 2^-fraction + x_error
delta = at - z;
power = WEIGHT * x_error + (q15(X * WEIGHT) - X * WEIGHT) - C * (G * delta);

{ a in [0.0625, 4096] /\ k in [0, 30] /\ L in [0, 1] /\ slope_error in [SLOPE_LOW, SLOPE_HIGH]
    /\ G in [G_LOW, G_HIGH] /\ z in [0, Z_HIGH] /\ a * L in [0, Z_HIGH] /\ a * L * G in [0, ZG_HIGH]
    /\ x_error in [X_ERROR_LOW, X_ERROR_HIGH] /\ C in [C_LOW, C_HIGH] ->
    power in ? /\ |delta| <= DELTA }

delta -> (at - a * t) + a * (q26(q29(product)) - q29(product)) + a * (q29(product) - product) + a * L * slope_error;
G * delta -> G * (at - a * t) + G * a * (q26(q29(product)) - q29(product)) + G * a * (q29(product) - product)
    + a * L * G * slope_error;
