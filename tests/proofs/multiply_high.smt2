; SPDX-License-Identifier: MIT
;
; multiply_high_narrow_u32 and _s32 at full width, over the integers: four opaque products of halves, their bounds, and
; the carries of the C code. Of a signed factor the upper half is signed; `div` and `mod` by 65536 are >> and & of two's
; complement. Each query asks for a counterexample; all must be unsat.
(declare-const ah Int) (declare-const al Int) (declare-const bh Int) (declare-const bl Int)
(declare-const hh Int) (declare-const hl Int) (declare-const lh Int) (declare-const ll Int)
(define-fun half ((x Int)) Bool (and (<= 0 x) (<= x 65535)))
(define-fun product-of-halves ((x Int)) Bool (and (<= 0 x) (<= x 4294836225))) ; (2^16 - 1)^2
(define-fun middle () Int (+ hl (div ll 65536)))
(define-fun cross () Int (+ lh (mod middle 65536)))
(define-fun high () Int (+ hh (div middle 65536) (div cross 65536)))
(define-fun exact () Int (+ (* 4294967296 hh) (* 65536 (+ hl lh)) ll)) ; (2^16 ah + al) (2^16 bh + bl)
(define-fun within ((low Int) (x Int) (high Int)) Bool (and (<= low x) (<= x high)))
(define-fun int32 ((x Int)) Bool (within (- 2147483648) x 2147483647))
(assert (and (half al) (half bl) (product-of-halves ll)))
(push)
(assert (and (half ah) (half bh) (product-of-halves hh) (product-of-halves hl) (product-of-halves lh)))
(echo "unsigned: the high word")
(push) (assert (not (= high (div exact 4294967296)))) (check-sat) (pop)
(echo "unsigned: no sum leaves 32 bits")
(push) (assert (not (and (< middle 4294967296) (< cross 4294967296)))) (check-sat) (pop)
(pop)
; a half of -2^15..2^15 - 1 times one of 0..2^16 - 1, and times another such
(define-fun mixed ((x Int)) Bool (within (- 2147450880) x 2147385345))
(assert (and (within (- 32768) ah 32767) (within (- 32768) bh 32767)))
(assert (and (within (- 1073709056) hh 1073741824) (mixed hl) (mixed lh)))
(echo "signed: the high word")
(push) (assert (not (= high (div exact 4294967296)))) (check-sat) (pop)
(echo "signed: no product, sum or partial sum leaves int32_t")
(push)
(assert (not (and (int32 hl) (int32 lh) (int32 middle) (int32 cross) (int32 (+ hh (div middle 65536))))))
(check-sat) (pop)
; `high` is floor(a b / 2^32) with a and b within int32_t, so it is within it too
