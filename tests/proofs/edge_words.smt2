; SPDX-License-Identifier: MIT
;
; The edge functions of src/raster/edges.c line by line on bit-vectors, at reduced widths: 2 sub-pixel bits instead of
; 8, coordinates of COORDINATE = 3 or 4 bits, pixels (PIXEL bits) of the same square, whose side is L = 7/4 or 15/4 px.
; The inequality of edges.h, sub-pixels L^2 < 2^(word - 1), then asks for words of WORD = 5 or 7 bits: 12.25 < 16,
; 56.25 < 64. Expected is unsat there; with a bit less, where the sign is lost, sat. The exact E takes 12 bits.
; ABOVE = 12 - COORDINATE, BEYOND = 12 - PIXEL, TOP = WORD - 1
(define-sort word () (_ BitVec WORD))
(define-sort wide () (_ BitVec 12))
(define-fun narrow ((x wide)) word ((_ extract TOP 0) x))
(declare-const x0 (_ BitVec COORDINATE)) (declare-const y0 (_ BitVec COORDINATE)) ; from
(declare-const x1 (_ BitVec COORDINATE)) (declare-const y1 (_ BitVec COORDINATE)) ; to
(declare-const px (_ BitVec PIXEL)) (declare-const py (_ BitVec PIXEL)) ; pixel
(define-fun of-coordinate ((x (_ BitVec COORDINATE))) wide ((_ zero_extend ABOVE) x))
(define-fun of-pixel ((x (_ BitVec PIXEL))) wide ((_ zero_extend BEYOND) x))
(define-fun dx () wide (bvsub (of-coordinate x1) (of-coordinate x0)))
(define-fun dy () wide (bvsub (of-coordinate y1) (of-coordinate y0)))
(define-fun centre ((p (_ BitVec PIXEL))) wide (bvadd (bvshl (of-pixel p) #x002) #x002))
(define-fun e () wide (bvsub (bvmul dx (bvsub (centre py) (of-coordinate y0))) (bvmul dy (bvsub (centre px) (of-coordinate x0)))))
(define-fun left-or-top () Bool (or (bvslt dy #x000) (and (= dy #x000) (bvsgt dx #x000))))
(define-fun x () wide (bvsub (centre px) (of-coordinate x0))) ; from the edge's beginning to the pixel's centre
(define-fun y () wide (bvsub (centre py) (of-coordinate y0)))
(define-fun fraction ((v wide)) wide (bvand v #x003))
(define-fun whole ((v wide)) word (narrow (bvashr v #x002)))
(define-fun bias () wide (bvashr (bvsub (bvashr (bvsub dx #x001) #x00b) dy) #x00b))
(define-fun part () wide
    (bvashr (bvadd (bvsub (bvmul dx (fraction y)) (bvmul dy (fraction x))) bias) #x002))
(define-fun value () word
    (bvadd (bvsub (bvmul (narrow dx) (whole y)) (bvmul (narrow dy) (whole x))) (narrow part)))
(define-fun zero () word (narrow #x000))
(assert (not (= (bvsge value zero) (ite left-or-top (bvsge e #x000) (bvsgt e #x000)))))
(check-sat)
