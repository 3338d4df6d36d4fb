; SPDX-License-Identifier: MIT
;
; shift_round64 at full width for right shifts, |value| < 2^62: result = floor((value + half) / unit), half = unit / 2.
; The error is at most half a unit and halves go up, when the sum does not wrap; beyond a shift by 62 the exact value is
; below 1/2 in magnitude and 0 is the nearest. Each query asks for a counterexample; all must be unsat.
(declare-const value (_ BitVec 64)) (declare-const s (_ BitVec 64))
(define-fun limit () (_ BitVec 64) (bvshl #x0000000000000001 #x000000000000003e))
(define-fun half () (_ BitVec 64) (bvshl #x0000000000000001 (bvsub s #x0000000000000001)))
(define-fun sum () (_ BitVec 64) (bvadd value half))
(define-fun result () (_ BitVec 64) (bvashr sum s))
(define-fun back () (_ BitVec 64) (bvshl result s))
(assert (and (bvsgt value (bvneg limit)) (bvslt value limit)))
(echo "beyond 62 bits: |value| < 2^62 = half a unit of 2^63, so 0 is nearest")
(push) (assert (not (and (bvsgt (bvadd value limit) #x0000000000000000) (bvsgt (bvsub limit value) #x0000000000000000))))
(check-sat) (pop)
(assert (and (bvuge s #x0000000000000001) (bvule s #x000000000000003e)))
(echo "the sum does not wrap")
(push) (assert (not (= (bvslt sum value) false))) (check-sat) (pop)
(echo "nearest, halves up: -half <= value - back < half")
(push) (assert (not (and (bvsle (bvneg half) (bvsub value back)) (bvslt (bvsub value back) half)))) (check-sat) (pop)
