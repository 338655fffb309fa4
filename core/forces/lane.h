// Lanes: a few doubles that move together. Every law is written once over a lane type L, which offers
//
//   kWidth                      doubles in a lane; mask type Mask, index type Index
//   load(p) loadu(p) store(p,v) aligned and unaligned
//   + - * /                     rounded correctly
//   fma(a,b,c)                  a b + c, rounded once; portable: twice, within 1e-12 of the others
//   sqrt abs max min            sqrt rounded correctly; max(a,b) = a > b ? a : b
//   ge gt, select(m,a,b)        m ? a : b
//   copysign(a,b)
//   find(e, start, n)           the last k < n with start[k] <= e, 0 if none
//   gather(p, k)                p[k]
//
// The same operations in the same order in every lane type: one result, whatever the width. Each lane type
// lives in an anonymous namespace, so that code made for one instruction set can never be linked into
// another's.
#pragma once

#if defined(__GNUC__)
#define DRAPE_INLINE inline __attribute__((always_inline))
#else
#define DRAPE_INLINE inline
#endif
