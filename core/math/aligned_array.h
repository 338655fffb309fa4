// Arrays of doubles aligned to a cache line, so that whole vector registers can be loaded from them.
#pragma once
#include <cstddef>
#include <new>
#include <vector>

namespace drape::math {

inline constexpr std::size_t kLine = 64;  // bytes: one cache line, one AVX-512 register
inline constexpr int kRowUnit = 8;  // doubles in a line; row strides and first nodes are multiples of this

template <class T>
struct LineAllocator {
  using value_type = T;
  LineAllocator() = default;
  template <class U>
  LineAllocator(const LineAllocator<U>&) {}
  T* allocate(std::size_t n) {
    return static_cast<T*>(::operator new(n * sizeof(T), std::align_val_t(kLine)));
  }
  void deallocate(T* p, std::size_t) { ::operator delete(p, std::align_val_t(kLine)); }
  bool operator==(const LineAllocator&) const { return true; }
};

using Array = std::vector<double, LineAllocator<double>>;

}  // namespace drape::math

namespace drape {
using math::Array;
}  // namespace drape
