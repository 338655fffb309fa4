// What the runtime of the release build lacks in a library of Linux that is unloaded. Other compilers link a
// crtbeginS.o, which destroys the static objects of a library when it is closed. The one of `ziglang` does
// not, and a host crashed at its end, when it called their destructors where the library had been.
extern "C" {
extern void* __dso_handle;  // NOLINT(bugprone-reserved-identifier): the names are those of the C++ ABI
void __cxa_finalize(void* library);
}

__attribute__((destructor)) static void static_objects_destroy() { __cxa_finalize(&__dso_handle); }

// libc++ divides numbers of 128 bits, for the times of files. Zig's library of such functions is one object,
// which would bring its own sin, exp and memcpy along; the linker would prefer these to those of the C
// library. Then the FMU would differ from the development build in the last bits.
extern "C" __attribute__((visibility("hidden"))) __int128 __divti3(__int128 a, __int128 b) {
  using Wide = unsigned __int128;
  const Wide divisor = b < 0 ? -Wide(b) : Wide(b);
  Wide rest = a < 0 ? -Wide(a) : Wide(a), quotient = 0;
  Wide remainder = 0;
  for (int bit = 0; bit < 128; ++bit) {
    remainder = remainder << 1 | rest >> 127;
    rest <<= 1;
    quotient <<= 1;
    if (remainder < divisor) continue;
    remainder -= divisor;
    quotient |= 1;
  }
  return (a < 0) == (b < 0) ? __int128(quotient) : __int128(-quotient);
}
