// Every segment is split at the grid lines. Pieces of segments along a grid line are dropped, since the walk
// below follows the sides of a place anyway. The other pieces form chains: runs of consecutive pieces in one
// place, which begin and end on its perimeter. The cloth is to the left of a chain, so the boundary of a part
// within a place is (Weiler and Atherton 1977, for a convex window)
//
//     +----<----+     a chain from where it enters to where it leaves, then counter-clockwise along the
//     |       out     perimeter to where the next chain enters, that chain, ... until the first is reached
//     v      /  |     again. The walk records which stretches of the sides belong to the part.
//     |     in  |
//     +-->---+--+
//
// A place without chains is wholly inside or outside. The number of crossings of the centre line of its row
// decides.
#include "piece/grid/cut.h"

#include <algorithm>
#include <cmath>

namespace drape::piece {
namespace {

struct Chain {
  int place;
  bool closed;               // the chain is a whole loop inside the place
  std::vector<Vec2> points;  // relative to the low corner of the place
};

struct Tracing {
  Cut cut;
  std::vector<char> toggled;  // [rows columns] 1: inside and outside change at this place of the row
  std::vector<Chain> chains;
};

double mixed(double a, double b, double t) {
  return std::clamp(a + t * (b - a), std::min(a, b), std::max(a, b));
}

bool along_line(Vec2 p, Vec2 q) {
  for (std::size_t a = 0; a < 2; ++a)
    if (p[a] == q[a] && p[a] == std::floor(p[a])) return true;
  return false;
}

// The place of a piece of a segment between grid lines; -1 if it runs along a grid line. Where the piece
// crosses the centre line of its row, inside and outside are exchanged for all places to its right.
int piece_place(Tracing& t, Vec2 p, Vec2 q) {
  const bool dropped = along_line(p, q);
  if (dropped && p[1] == q[1]) return -1;
  const int row = int(std::floor((p[1] + q[1]) / 2)) - t.cut.j0;
  const int column = int(std::floor((p[0] + q[0]) / 2)) - t.cut.i0;
  const int place = row * t.cut.columns + column;
  const double centre = row + t.cut.j0 + 0.5;
  if ((p[1] <= centre) != (q[1] <= centre)) t.toggled[std::size_t(place + !dropped)] ^= 1;
  return dropped ? -1 : place;
}

void loop_trace(Tracing& t, const std::vector<Vec2>& loop) {
  std::vector<Vec2> points{loop[0]};
  for (std::size_t k = 0; k < loop.size(); ++k) cut_segment(loop[k], loop[(k + 1) % loop.size()], points);
  if (points.size() > 1) points.pop_back();  // it repeats the first
  const std::size_t n = points.size();
  std::vector<int> place(n);
  for (std::size_t k = 0; k < n; ++k) place[k] = piece_place(t, points[k], points[(k + 1) % n]);

  std::size_t begin = 0;  // a piece whose predecessor is in another place
  while (begin < n && place[begin] == place[(begin + n - 1) % n]) ++begin;
  const bool closed = begin == n;
  if (closed && place[0] < 0) return;
  if (closed) begin = 0;
  for (std::size_t k = 0; k < n; ++k) {
    const std::size_t at = (begin + k) % n;
    if (place[at] < 0) continue;
    const int column = place[at] % t.cut.columns, row = place[at] / t.cut.columns;
    const double i = t.cut.i0 + column, j = t.cut.j0 + row;
    const auto local = [&](Vec2 p) {
      return Vec2{std::clamp(p[0] - i, 0.0, 1.0), std::clamp(p[1] - j, 0.0, 1.0)};
    };
    if (k == 0 || place[at] != place[(at + n - 1) % n])
      t.chains.push_back({place[at], closed, {local(points[at])}});
    if (!closed || k + 1 < n) t.chains.back().points.push_back(local(points[(at + 1) % n]));
  }
}

// Position of a point on the perimeter of a place: side + distance along it, counter-clockwise from (0,0).
double perimeter_position(Vec2 p) {
  if (p[1] <= 0 && p[0] < 1) return p[0];
  if (p[0] >= 1 && p[1] < 1) return 1 + p[1];
  if (p[1] >= 1 && p[0] > 0) return 3 - p[0];
  return 4 - p[1];
}

Vec2 perimeter_corner(int k) { return {k % 4 == 1 || k % 4 == 2 ? 1.0 : 0.0, k % 4 >= 2 ? 1.0 : 0.0}; }

// Walks along the perimeter from one position to the next. Adds the corners and the stretches of sides to the
// part.
void perimeter_walk(CutPart& part, double from, double to) {
  if (to < from) to += 4;
  while (from < to) {
    const int side = int(std::floor(from));
    const double end = std::min(to, side + 1.0), a = from - side, b = end - side;
    const int s = side % 4;
    part.sides.push_back(s < 2 ? CutSide{s, a, b} : CutSide{s, 1 - b, 1 - a});
    if (end < to) part.loops[0].push_back(perimeter_corner(side + 1));
    from = end;
  }
}

// Finds the parts that are bounded by open chains.
void parts_walk(const std::vector<Chain>& chains, std::vector<CutPart>& parts) {
  std::vector<const Chain*> open;
  for (const Chain& c : chains)
    if (!c.closed) open.push_back(&c);
  std::sort(open.begin(), open.end(), [](const Chain* a, const Chain* b) {
    return perimeter_position(a->points.front()) < perimeter_position(b->points.front());
  });
  std::vector<bool> visited(open.size());
  for (std::size_t start = 0; start < open.size(); ++start) {
    if (visited[start]) continue;
    CutPart part{chains[0].place, 0, {}, {{}}};
    for (std::size_t k = start; !visited[k];) {
      visited[k] = true;
      const std::vector<Vec2>& points = open[k]->points;
      part.loops[0].insert(part.loops[0].end(), points.begin(), points.end());
      const double out = perimeter_position(points.back());
      const auto next = std::find_if(open.begin(), open.end(), [&](const Chain* c) {
        return perimeter_position(c->points.front()) >= out;
      });
      k = next == open.end() ? 0 : std::size_t(next - open.begin());
      perimeter_walk(part, out, perimeter_position(open[k]->points.front()));
    }
    parts.push_back(std::move(part));
  }
}

CutPart whole_part(int place) {
  CutPart part{place, 0, {}, {{{0, 0}, {1, 0}, {1, 1}, {0, 1}}}};
  for (int side = 0; side < 4; ++side) part.sides.push_back({side, 0, 1});
  return part;
}

// A point of a loop that is not on the sides of the place, if there is one.
Vec2 inner_point(const std::vector<Vec2>& loop) {
  for (const Vec2& p : loop)
    if (p[0] > 0 && p[0] < 1 && p[1] > 0 && p[1] < 1) return p;
  return {(loop[0][0] + loop[1][0]) / 2, (loop[0][1] + loop[1][1]) / 2};
}

void hole_attach(std::vector<CutPart>& parts, const std::vector<Vec2>& hole) {
  const Vec2 p = inner_point(hole);
  for (CutPart& part : parts)
    if (outline_contains({OutlineLoop{part.loops[0], {}}}, p)) {
      part.loops.push_back(hole);
      return;
    }
}

// The parts of a place that the outline cuts. `inside`: a place without open chains is inside the piece.
std::vector<CutPart> place_parts(const std::vector<Chain>& chains, bool inside) {
  std::vector<CutPart> parts;
  parts_walk(chains, parts);
  if (parts.empty() && inside) parts.push_back(whole_part(chains[0].place));
  for (const Chain& c : chains)
    if (c.closed && polygon_area(c.points) > 0) parts.push_back({c.place, 0, {}, {c.points}});
  for (const Chain& c : chains)
    if (c.closed && polygon_area(c.points) < 0) hole_attach(parts, c.points);
  for (CutPart& part : parts)
    for (const std::vector<Vec2>& loop : part.loops) part.share += polygon_area(loop);
  std::erase_if(parts, [](const CutPart& part) { return !(part.share > 0); });
  return parts;
}

Tracing tracing_begin(const std::vector<std::vector<Vec2>>& loops) {
  Vec2 low = loops[0][0], high = low;
  for (const Vec2& p : loops[0])
    for (std::size_t a = 0; a < 2; ++a) low[a] = std::min(low[a], p[a]), high[a] = std::max(high[a], p[a]);
  Tracing t;
  t.cut.i0 = int(std::floor(low[0])) - 1;
  t.cut.j0 = int(std::floor(low[1])) - 1;
  t.cut.columns = int(std::ceil(high[0])) + 1 - t.cut.i0;
  t.cut.rows = int(std::ceil(high[1])) + 1 - t.cut.j0;
  t.cut.first.assign(std::size_t(t.cut.rows) * std::size_t(t.cut.columns), kPlaceOutside);
  t.toggled.assign(t.cut.first.size() + 1, 0);
  return t;
}

}  // namespace

void cut_segment(Vec2 p, Vec2 q, std::vector<Vec2>& points) {
  std::vector<std::pair<double, Vec2>> crossed;
  for (std::size_t a = 0; a < 2; ++a) {
    const double low = std::min(p[a], q[a]), high = std::max(p[a], q[a]);
    for (double line = std::floor(low) + 1; line < high; ++line) {
      const double t = (line - p[a]) / (q[a] - p[a]);
      Vec2 r;
      r[a] = line;
      r[1 - a] = cut_snapped(mixed(p[1 - a], q[1 - a], t));
      crossed.emplace_back(t, r);
    }
  }
  std::stable_sort(crossed.begin(), crossed.end(),
                   [](const auto& a, const auto& b) { return a.first < b.first; });
  for (const auto& m : crossed)
    if (m.second != points.back()) points.push_back(m.second);
  if (q != points.back()) points.push_back(q);
}

double cut_snapped(double v) {
  const double whole = std::round(v);
  return std::abs(v - whole) <= kSnap ? whole : v;
}

Cut cut_make(const std::vector<std::vector<Vec2>>& loops) {
  Tracing t = tracing_begin(loops);
  for (const std::vector<Vec2>& loop : loops) loop_trace(t, loop);
  std::stable_sort(t.chains.begin(), t.chains.end(),
                   [](const Chain& a, const Chain& b) { return a.place < b.place; });
  auto chain = t.chains.begin();
  for (int place = 0, inside = 0; place < int(t.cut.first.size()); ++place) {
    inside ^= t.toggled[std::size_t(place)];
    int& first = t.cut.first[std::size_t(place)];
    if (inside) first = kPlaceWhole;
    if (chain == t.chains.end() || chain->place != place) continue;
    const auto end = std::find_if(chain, t.chains.end(), [&](const Chain& c) { return c.place != place; });
    std::vector<CutPart> parts =
        place_parts({std::make_move_iterator(chain), std::make_move_iterator(end)}, inside);
    first = parts.empty() ? int(kPlaceOutside) : int(t.cut.parts.size());
    std::move(parts.begin(), parts.end(), std::back_inserter(t.cut.parts));
    chain = end;
  }
  return t.cut;
}

}  // namespace drape::piece
