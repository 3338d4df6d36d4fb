; SPDX-License-Identifier: MIT
;
; src/raster/edges.h: an edge's ends and the sample lie in a square of side L (in sub-pixels), so |E| <= L^2. E is of
; first degree in each of the six coordinates alone, so it is greatest in corners of their ranges, where a coordinate is
; 0 or L. The query asks for a choice of corners that gives more, in units of L^2; it must be unsat.
(declare-const x0 Bool) (declare-const y0 Bool) (declare-const x1 Bool) (declare-const y1 Bool)
(declare-const x Bool) (declare-const y Bool)
(define-fun n ((b Bool)) Int (ite b 1 0))
(define-fun times ((a Int) (b Int)) Int (ite (= a 0) 0 (ite (= a 1) b (- b)))) ; a is -1, 0 or 1
(define-fun e () Int (- (times (- (n x1) (n x0)) (- (n y) (n y0))) (times (- (n y1) (n y0)) (- (n x) (n x0)))))
(assert (not (<= (- 1) e 1)))
(check-sat)
