// Intel 64 and IA-32 Architectures Software Developer's Manual, volume 1, sections 14.3 and 15.2: an
// instruction set is there if the processor has it (CPUID) and the operating system saves its registers
// (XGETBV).
#include "dynamics/kernel/processor.h"

#if defined(__x86_64__)
#include <cpuid.h>
#endif

namespace drape::dynamics {
namespace {

#if defined(__x86_64__)
struct Processor {
  bool avx2 = false, avx512 = false;
};

bool all_set(unsigned word, unsigned bits) { return (word & bits) == bits; }

unsigned saved_registers() {
  unsigned low = 0, high = 0;
  __asm__("xgetbv" : "=a"(low), "=d"(high) : "c"(0));
  return low;
}

Processor processor_ask() {
  constexpr unsigned kFma = 1u << 12, kOsSaves = 1u << 27, kAvx = 1u << 28;           // leaf 1, ECX
  constexpr unsigned kAvx2 = 1u << 5, kF = 1u << 16, kDq = 1u << 17, kVl = 1u << 31;  // leaf 7, EBX
  constexpr unsigned kYmm = 0x6, kZmm = 0xe6;                                         // XCR0
  Processor found;
  unsigned a = 0, b = 0, c = 0, d = 0;
  if (!__get_cpuid(1, &a, &b, &c, &d) || !all_set(c, kFma | kOsSaves | kAvx)) return found;
  if (!__get_cpuid_count(7, 0, &a, &b, &c, &d)) return found;
  const unsigned saved = saved_registers();
  found.avx2 = all_set(saved, kYmm) && all_set(b, kAvx2);
  found.avx512 = found.avx2 && all_set(saved, kZmm) && all_set(b, kF | kDq | kVl);
  return found;
}

const Processor& processor() {
  static const Processor found = processor_ask();
  return found;
}
#endif

}  // namespace

#if defined(__x86_64__)
bool processor_has_avx2() { return processor().avx2; }
bool processor_has_avx512() { return processor().avx512; }
#else
bool processor_has_avx2() { return false; }
bool processor_has_avx512() { return false; }
#endif

}  // namespace drape::dynamics
