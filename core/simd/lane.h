// Lanes: a few doubles that move together. Every law is written once over a lane type L, which offers
//
//   kWidth                      doubles in a lane; mask type Mask
//   load(p) loadu(p) store(p,v) aligned and unaligned
//   + - * /                     rounded correctly
//   fma(a,b,c) fms(a,b,c)       a b + c, a b - c, rounded once; portable: twice, within 1e-12 of the others
//   sqrt abs max min            sqrt rounded correctly; max(a,b) = a > b ? a : b
//   ge gt any, select(m,a,b)    m ? a : b
//   bits_and bits_xor           of the numbers' bits
//   shifted(a,b)                the last of a, then all of b but its last: what lies one to the left of b
//   ahead(a,b)                  all of a but its first, then the first of b: what lies one to the right of a
//   truncate(to, a)             to[i] = a_i without its fraction
//   columns(rows, c0 ... c5)    ck_i = rows[i][k]; each row 64 bytes, aligned
//   kept(a)                     a, in a register: compilers that run short of them load the same number twice
//   kPermutes                   whether places(), next() and pick() are there: tables in registers
//
// The same operations in the same order in every lane type: one result, whatever the width. Each lane type
// lives in an anonymous namespace, so that code made for one instruction set can never be linked into
// another's.
#pragma once

#if defined(__GNUC__)
#define DRAPE_INLINE inline __attribute__((always_inline))
#define DRAPE_INLINE_LAMBDA __attribute__((always_inline))
#else
#define DRAPE_INLINE inline
#define DRAPE_INLINE_LAMBDA
#endif
