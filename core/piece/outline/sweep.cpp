// A line sweeps over the segments and keeps those that it cuts in their order along it (Shamos and Hoey
// 1976).
//
//          |    c        Up to the first two that touch, the order is that of disjoint segments. Two that
//      \   |   /         touch there are neighbours in it before: between them only segments can lie that
//       a  |  /          touch one of them, too. So every pair is compared that becomes neighbours.
//     ---b-+-----
//          |             Segments closer than `contact` count as touching. One that ends is therefore kept
//                        until the line is `contact` past its end. A narrow slit along the line would begin
//                        after it has ended; so a second line sweeps at right angles.
#include "piece/outline/sweep.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <tuple>

namespace drape::piece {
namespace {

struct Stretch {
  Vec2 from, to;  // in the order of the sweep
};

struct Event {
  Vec2 at;
  bool ends;
  int segment;
};

// How `later`, which begins behind or with `other`, lies to it along the line: above 0, before it: below 0.
double order_at_begin(const Stretch& other, const Stretch& later) {
  if (later.from > other.to) return later.from[1] - other.to[1];
  const double side = segment_side(other.from, other.to, later.from);
  return side != 0 ? side : segment_side(other.from, other.to, later.to);
}

struct Below {
  const std::vector<Stretch>* stretch;
  bool operator()(int a, int b) const {
    const Stretch &first = (*stretch)[std::size_t(a)], &second = (*stretch)[std::size_t(b)];
    const bool swapped = std::pair(second.from, b) < std::pair(first.from, a);
    const double order = swapped ? -order_at_begin(second, first) : order_at_begin(first, second);
    return order != 0 ? order > 0 : a < b;
  }
};

std::vector<Event> events_of(const std::vector<Stretch>& stretch, double contact) {
  std::vector<Event> events;
  for (std::size_t k = 0; k < stretch.size(); ++k) {
    events.push_back({stretch[k].from, false, int(k)});
    events.push_back({{stretch[k].to[0] + contact, stretch[k].to[1]}, true, int(k)});
  }
  std::sort(events.begin(), events.end(), [](const Event& a, const Event& b) {
    return std::tie(a.at, a.ends, a.segment) < std::tie(b.at, b.ends, b.segment);
  });
  return events;
}

std::optional<std::pair<int, int>> sweep_along(const std::vector<Segment>& segments, std::size_t axis,
                                               double contact) {
  std::vector<Stretch> stretch;
  for (const Segment& s : segments) {
    const Vec2 p{s.p[axis], s.p[1 - axis]}, q{s.q[axis], s.q[1 - axis]};
    stretch.push_back({std::min(p, q), std::max(p, q)});
  }
  using Line = std::set<int, Below>;
  Line line(Below{&stretch});
  std::vector<Line::iterator> on_line(segments.size());
  OutlineCrossing found;
  const auto touch = [&](Line::iterator a, Line::iterator b) {
    return segments_touch(segments[std::size_t(*a)], segments[std::size_t(*b)], contact, found);
  };
  for (const Event& e : events_of(stretch, contact)) {
    Line::iterator& own = on_line[std::size_t(e.segment)];
    if (!e.ends) own = line.insert(e.segment).first;
    const auto above = std::next(own);
    const bool has_below = own != line.begin(), has_above = above != line.end();
    const auto below = has_below ? std::prev(own) : own;
    if (e.ends) {
      line.erase(own);
      if (has_below && has_above && touch(below, above)) return std::pair{*below, *above};
    } else {
      if (has_below && touch(below, own)) return std::pair{*below, *own};
      if (has_above && touch(own, above)) return std::pair{*own, *above};
    }
  }
  return std::nullopt;
}

}  // namespace

std::optional<std::pair<int, int>> sweep_touch(const std::vector<Segment>& segments, double contact) {
  const auto found = sweep_along(segments, 0, contact);
  return found ? found : sweep_along(segments, 1, contact);
}

}  // namespace drape::piece
