// Lanes: a few doubles in one vector register. Every force law is written once over a lane type L with
//
//   kWidth                      doubles in a lane; mask type Mask
//   load(p) loadu(p) store(p,v) aligned and unaligned
//   + - * /                     rounded correctly
//   fma(a,b,c) fms(a,b,c)       a b + c, a b - c, rounded once. The portable lane rounds twice: within
//                               1e-12 of the others
//   sqrt abs max min            sqrt rounded correctly; max(a,b) = a > b ? a : b
//   ge gt any, select(m,a,b)    m ? a : b
//   bits_and bits_xor           bitwise, on the representation of the numbers
//   shifted(a,b)                the last of a, then all of b but its last: the numbers one to the left
//   ahead(a,b)                  all of a but its first, then the first of b: the numbers one to the right
//   gather(p,i)                 p[i[0]], p[i[1]], ...
//   gather4(p,i,a,b,c,d)        columns of the rows of four p[4 i[0]], ..., each 32 bytes, aligned
//   scatter4(p,i,a,b,c,d)       writes such rows; where two i are equal, their rows must be too
//   truncate(to, a)             to[i] = a_i without its fraction
//   columns(rows, c0 ... c5)    ck_i = rows[i][k]; each row 64 bytes, aligned
//   kept(a)                     a, forced into a register, so that it is not loaded twice
//   kPermutes                   true where places(), next() and pick() exist: look-up tables in registers
//
// Every lane type does the same operations in the same order, so the result does not depend on the width.
// Each lane type is in an anonymous namespace, so that the linker can never use code of one instruction set
// in place of another's.
#pragma once

#if defined(__GNUC__)
#define DRAPE_INLINE inline __attribute__((always_inline))
#define DRAPE_INLINE_LAMBDA __attribute__((always_inline))
#else
#define DRAPE_INLINE inline
#define DRAPE_INLINE_LAMBDA
#endif
