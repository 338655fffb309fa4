// What a table of fields is made of. The table of a struct names each of its fields once. Size, writing and
// reading are loops over it, and a struct with a field that its table lacks does not compile.
#pragma once
#include <cstddef>
#include <limits>
#include <tuple>
#include <type_traits>
#include <utility>

namespace drape::state {

// How long a list is; also the bound of an index into it. The numbers are in Shape.
enum class Length : unsigned char {
  kAny,
  kNodes,
  kNodesOrNone,
  kGroups,  // of kRowUnit nodes
  kPins,
  kBodies,
  kPairs,         // of seams
  kPairNumbers,   // three for each pair
  kSelfEdges,     // of the mesh of self-contact
  kEdgeElements,  // links and cells that may touch sharp features
  kLattices,
  kParameters,  // of the C interface, as are the next two
  kDrivenPins,
  kMovingBodies
};
inline constexpr std::size_t kLengths = 14;

// The lengths in one scene.
struct Shape {
  std::size_t of[kLengths]{};
  std::size_t operator[](Length length) const { return of[std::size_t(length)]; }
  std::size_t& operator[](Length length) { return of[std::size_t(length)]; }
};

// The numbers that a field may hold; never NaN. An index is below the length `below`.
struct Allowed {
  double min = -std::numeric_limits<double>::max(), max = std::numeric_limits<double>::max();
  Length below = Length::kAny;
};
inline constexpr Allowed kFinite{};
inline constexpr Allowed kMayBeInfinite{-std::numeric_limits<double>::infinity(),
                                        std::numeric_limits<double>::infinity()};
inline constexpr Allowed kNotNegative{0};
inline constexpr Allowed kShare{0, 1};
constexpr Allowed from_to(double min, double max) { return {min, max}; }
constexpr Allowed index_of(Length length) { return {0, std::numeric_limits<double>::max(), length}; }

// One row. `length` counts where the field is a list; `allowed` is of its numbers, and each part that is a
// struct has a table of its own.
template <class T>
struct Field {
  const char* name;
  T& value;
  Length length = Length::kAny;
  Allowed allowed = kFinite;
};
template <class T>
Field(const char*, T&) -> Field<T>;
template <class T>
Field(const char*, T&, Length) -> Field<T>;
template <class T>
Field(const char*, T&, Length, Allowed) -> Field<T>;

// Table<S>::of(s), s of type S or const S, is a std::tuple of Fields. Of a type without a table it is absent.
template <class S>
struct Table {};

template <class S>
concept HasTable = requires(S& s) { Table<std::remove_const_t<S>>::of(s); };

// The number of members of an aggregate. An array within it counts once for each element.
struct Anything {
  template <class T>
  operator T() const;
};
template <class S, class... Members>
constexpr std::size_t member_count() {
  if constexpr (requires { S{Members{}..., Anything{}}; }) return member_count<S, Members..., Anything>();
  else return sizeof...(Members);
}

template <class T>
constexpr std::size_t element_count() {
  if constexpr (std::is_array_v<T>) return std::extent_v<T> * element_count<std::remove_extent_t<T>>();
  else return 1;
}
template <class... T>
constexpr std::size_t listed_count(const std::tuple<Field<T>...>*) {
  return (element_count<T>() + ... + 0);
}
template <class S>
using TableOf = decltype(Table<S>::of(std::declval<S&>()));

// Whether the table of S has every member of S.
template <class S>
inline constexpr bool kListsAll = listed_count(static_cast<TableOf<S>*>(nullptr)) == member_count<S>();

}  // namespace drape::state
