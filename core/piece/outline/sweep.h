// Finds whether any two of many segments touch, in n log n whatever their lengths.
#pragma once
#include <optional>
#include <utility>

#include "piece/outline/segments.h"

namespace drape::piece {

// The numbers of two segments that cross, or come closer than `contact` (m); none if no two do.
std::optional<std::pair<int, int>> sweep_touch(const std::vector<Segment>& segments, double contact);

}  // namespace drape::piece
