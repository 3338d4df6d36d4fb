; SPDX-License-Identifier: MIT
;
; multiply_high_narrow_u32 and _s32 at full width, over the integers: four opaque products of halves, their bounds, and
; the carries of the C code. Each query asks for a counterexample; all must be unsat.
(declare-const ah Int) (declare-const al Int) (declare-const bh Int) (declare-const bl Int)
(declare-const hh Int) (declare-const hl Int) (declare-const lh Int) (declare-const ll Int)
(define-fun half ((x Int)) Bool (and (<= 0 x) (<= x 65535)))
(define-fun product-of-halves ((x Int)) Bool (and (<= 0 x) (<= x 4294836225))) ; (2^16 - 1)^2
(define-fun middle () Int (+ hl (div ll 65536)))
(define-fun cross () Int (+ lh (mod middle 65536)))
(define-fun high () Int (+ hh (div middle 65536) (div cross 65536)))
(define-fun exact () Int (+ (* 4294967296 hh) (* 65536 (+ hl lh)) ll)) ; (2^16 ah + al) (2^16 bh + bl)
(assert (and (half ah) (half al) (half bh) (half bl)))
(assert (and (product-of-halves hh) (product-of-halves hl) (product-of-halves lh) (product-of-halves ll)))
(echo "unsigned: the high word")
(push) (assert (not (= high (div exact 4294967296)))) (check-sat) (pop)
(echo "unsigned: no sum leaves 32 bits")
(push) (assert (not (and (< middle 4294967296) (< cross 4294967296)))) (check-sat) (pop)
; signed: a = ua - 2^32 sa, so a b = ua ub - 2^32 (sa ub + sb ua) + 2^64 sa sb; modulo 2^32 the last term drops out
(echo "signed: the correction, modulo 2^32")
(declare-const sa Bool) (declare-const sb Bool)
(define-fun ua () Int (+ (* 65536 ah) al))
(define-fun ub () Int (+ (* 65536 bh) bl))
(define-fun taken () Int (+ (ite sa ub 0) (ite sb ua 0)))
(push)
(assert (not (= (mod (- (div exact 4294967296) taken) 4294967296)
    (mod (div (+ (- exact (* 4294967296 taken)) (ite (and sa sb) 18446744073709551616 0)) 4294967296) 4294967296))))
(check-sat) (pop)
