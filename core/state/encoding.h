// Values as bytes, by the tables of their types: little-endian numbers without padding, a list as its length
// (8 bytes) and its elements. core/README.md, section 10.
#pragma once
#include <array>
#include <bit>
#include <cstdint>
#include <cstring>
#include <memory>
#include <string>
#include <vector>

#include "state/bulk.h"
#include "state/field.h"

namespace drape::state {

static_assert(std::endian::native == std::endian::little, "numbers are copied as they are in memory");

template <class T>
inline constexpr bool kIsNumber = std::is_arithmetic_v<T> || std::is_enum_v<T>;

template <class T>
struct ListOf : std::false_type {};
template <class E, class A>
struct ListOf<std::vector<E, A>> : std::true_type {
  using Element = E;
};
template <class T>
struct SharedOf : std::false_type {};
template <class E>
struct SharedOf<std::shared_ptr<const E>> : std::true_type {
  using Element = E;
};
template <class T>
struct ElementOf;
template <class E, std::size_t N>
struct ElementOf<E[N]> {
  using Type = E;
};
template <class E, std::size_t N>
struct ElementOf<std::array<E, N>> {
  using Type = E;
};
template <class T>
concept FixedArray = requires { typename ElementOf<T>::Type; };

// Whether the bytes of a T are those in memory: nothing but numbers, and no padding between them.
template <class T>
constexpr bool is_plain();
template <class... T>
constexpr bool fields_fill(const std::tuple<Field<T>...>*, std::size_t size) {
  return (is_plain<T>() && ...) && (sizeof(T) + ...) == size;
}
template <class T>
constexpr bool is_plain() {
  if constexpr (kIsNumber<T>) return true;
  else if constexpr (FixedArray<T>) return is_plain<typename ElementOf<T>::Type>();
  else if constexpr (HasTable<T>) return fields_fill(static_cast<TableOf<T>*>(nullptr), sizeof(T));
  else return false;
}

// Where bytes go: counted, or written one after the other.
struct Counted {
  std::size_t size = 0;
  void raw(const void*, std::size_t bytes) { size += bytes; }
};
struct Written {
  unsigned char* at;
  void raw(const void* from, std::size_t bytes) {
    if (bytes > 0) std::memcpy(at, from, bytes);
    at += bytes;
  }
};

template <class Bytes>
struct Encoder {
  Bytes bytes;
  template <class T>
  void value(const T& v) {
    if constexpr (is_plain<T>()) {
      bytes.raw(&v, sizeof(T));
    } else if constexpr (ListOf<T>::value) {
      const std::uint64_t count = v.size();
      bytes.raw(&count, sizeof count);
      if constexpr (is_plain<typename ListOf<T>::Element>()) bytes.raw(v.data(), v.size() * sizeof(v[0]));
      else
        for (const auto& element : v) value(element);
    } else if constexpr (SharedOf<T>::value) {
      const unsigned char present = v ? 1 : 0;
      bytes.raw(&present, 1);
      if (v) value(*v);
    } else if constexpr (FixedArray<T>) {
      for (const auto& element : v) value(element);
    } else {
      std::apply([&](const auto&... field) { (value(field.value), ...); },
                 Table<std::remove_const_t<T>>::of(v));
    }
  }
};

// Reads what an Encoder has written, and checks each length and each number. `problem` is empty, or the first
// fault; nothing is read after it. Lists that do not hold plain values keep their elements, which are read in
// place.
struct Reader {
  const unsigned char *at, *end;
  const Shape& shape;
  std::string problem;
  static constexpr int kDeepest = 12;
  const char* path[kDeepest]{};  // names of the fields that lead to the present one
  int depth = 0;

  template <class T>
  void field(const Field<T>& f) {
    if (!problem.empty()) return;
    path[depth++] = f.name;
    value(f.value, f.length, f.allowed);
    --depth;
  }

  template <class T>
  void value(T& v, Length length, const Allowed& allowed) {
    if (!problem.empty()) return;
    if constexpr (is_plain<T>()) {
      if (take(&v, sizeof(T))) check(&v, 1, allowed);
    } else if constexpr (ListOf<T>::value) {
      list(v, length, allowed);
    } else if constexpr (SharedOf<T>::value) {
      unsigned char present = 0;
      if (!take(&present, 1)) return;
      if (present > 1) return fault("is neither present nor absent");
      v.reset();
      if (!present) return;
      auto read = std::make_shared<typename SharedOf<T>::Element>();
      value(*read, length, allowed);
      v = std::move(read);
    } else if constexpr (FixedArray<T>) {
      for (auto& element : v) value(element, length, allowed);
    } else {
      std::apply([&](const auto&... f) { (field(f), ...); }, Table<T>::of(v));
    }
  }

 private:
  void fault(const std::string& what) {
    if (!problem.empty()) return;
    for (int k = 0; k < depth; ++k) problem += (k > 0 ? "." : "") + std::string(path[k]);
    problem += " " + what;
  }

  bool take(void* to, std::size_t size) {
    if (std::size_t(end - at) < size) return fault("is cut off"), false;
    if (size > 0) std::memcpy(to, at, size);
    at += size;
    return true;
  }

  template <class E, class A>
  void list(std::vector<E, A>& v, Length length, const Allowed& allowed) {
    std::uint64_t count = 0;
    if (!take(&count, sizeof count)) return;
    const bool none = length == Length::kNodesOrNone && count == 0, any = length == Length::kAny;
    if (!any && !none && count != shape[length])
      return fault("has " + std::to_string(count) + " elements; expected: " + std::to_string(shape[length]));
    if (count > std::size_t(end - at)) return fault("is cut off");
    if constexpr (is_plain<E>()) {
      if (count > std::size_t(end - at) / sizeof(E)) return fault("is cut off");
      v.resize(count);
      if (take(v.data(), count * sizeof(E))) check(v.data(), count, allowed);
    } else {
      v.resize(count);
      for (E& element : v) value(element, Length::kAny, allowed);
    }
  }

  // Checks `count` plain values one after the other in memory.
  template <class T>
  void check(const T* v, std::size_t count, const Allowed& allowed) {
    if constexpr (std::is_same_v<T, double>) {
      if (!numbers_within(v, count, allowed.min, allowed.max)) fault("has a value out of its range");
    } else if constexpr (std::is_same_v<T, bool>) {
      if (!flags_within(v, count)) fault("is neither true nor false");
    } else if constexpr (kIsNumber<T>) {
      const bool index = allowed.below != Length::kAny;
      const double below = index ? double(shape[allowed.below]) : allowed.max;
      for (std::size_t k = 0; k < count && problem.empty(); ++k)
        if (const double number = double(v[k]);
            !(number >= allowed.min && (index ? number < below : number <= below)))
          fault("has a value out of its range");
    } else if constexpr (FixedArray<T>) {
      using E = typename ElementOf<T>::Type;
      check(reinterpret_cast<const E*>(v), count * (sizeof(T) / sizeof(E)), allowed);
    } else {
      for (std::size_t k = 0; k < count && problem.empty(); ++k)
        std::apply([&](const auto&... f) { (check(&f.value, 1, f.allowed), ...); }, Table<T>::of(v[k]));
    }
  }
};

// A number that changes with the names, types and order of the fields that T consists of.
struct Layout {
  std::uint64_t hash = 0;
  void add(const void* bytes, std::size_t size) { hash = bytes_hash(bytes, size, hash); }
  template <class T>
  void type() {
    if constexpr (kIsNumber<T>) {
      const unsigned char kind[] = {'n', std::is_floating_point_v<T>, sizeof(T)};
      add(kind, sizeof kind);
    } else if constexpr (ListOf<T>::value) {
      add("[", 1);
      type<typename ListOf<T>::Element>();
    } else if constexpr (SharedOf<T>::value) {
      add("?", 1);
      type<typename SharedOf<T>::Element>();
    } else if constexpr (FixedArray<T>) {
      const std::uint64_t count = sizeof(T) / sizeof(typename ElementOf<T>::Type);
      add(&count, sizeof count);
      type<typename ElementOf<T>::Type>();
    } else {
      T example{};
      std::apply([&](const auto&... f) { (field(f), ...); }, Table<T>::of(example));
      add(";", 1);
    }
  }
  template <class T>
  void field(const Field<T>& f) {
    add(f.name, std::strlen(f.name));
    type<std::remove_const_t<T>>();
  }
};

}  // namespace drape::state
