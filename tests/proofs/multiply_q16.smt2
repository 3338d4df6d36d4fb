; SPDX-License-Identifier: MIT
;
; multiply_q16 at full width, over the integers: a = 2^16 h + l with -2^15 <= h < 2^15, 0 <= l < 2^16, products opaque.
; Each query asks for a counterexample; all must be unsat.
(declare-const h Int) (declare-const l Int) (declare-const b Int) (declare-const hb Int) (declare-const lb Int)
(echo "floor(a b / 2^16)")
(push)
(assert (not (= (+ hb (div lb 65536)) (div (+ (* 65536 hb) lb) 65536))))
(check-sat) (pop)
(echo "within int32_t: both products and, as |a b / 2^16| <= 2^30, the sum")
(assert (and (<= (- 32768) h 32767) (<= 0 l 65535) (<= (- 32768) b 32767)))
(push)
(assert (not (and (<= (- 1073741824) (* h b) 1073741824) (<= (- 2147483648) (* l b) 2147483647)
    (<= (- 1073741824) (div (* (+ (* 65536 h) l) b) 65536) 1073741824))))
(check-sat) (pop)
