// The points and rows that pins hold: core/README.md, section 4.
#include "piece/support/support.h"

#include "piece_fixture.h"

namespace drape::piece {

using namespace tests;
namespace {

using Points = std::vector<Vec2>;

struct Held {
  Grid grid;
  Support hold;
};

Held held(const scene::PieceSpec& piece, scene::PinSpec pin, bool clamp = false) {
  pin.piece = 0;
  pin.clamp = clamp;
  Scene scene = scene_of(piece);
  scene.pins = {pin};
  Held h{grid_make(scene, 0), {}};
  h.hold = support_make(h.grid, scene, pin);
  return h;
}

scene::PinSpec edges_pin(const std::vector<int>& edges) {
  scene::PinSpec pin;
  pin.edges = edges;
  return pin;
}

scene::PinSpec points_pin(const Points& points) {
  scene::PinSpec pin;
  pin.at = points;
  return pin;
}

scene::PinSpec region_pin(const Points& region) {
  scene::PinSpec pin;
  pin.region = region;
  return pin;
}

// The indices (i, j) of both ends, y and q_c.
struct Slope {
  std::array<int, 2> from, to;
  double clamp, series;
};

std::vector<Slope> slopes_along(const Held& h, bool warp) {
  std::vector<Slope> list;
  for (const HeldSlope& s : h.hold.slopes)
    if (s.warp == warp) list.push_back({h.grid.index(s.from), h.grid.index(s.to), s.clamp, s.series});
  return list;
}

TEST(Support, EdgeIsHeldAtItsCornersAndCrossings) {
  EXPECT_EQ(held(rectangle(0, 0, 2.5, 2, 1), edges_pin({2})).hold.points,
            (Points{{0, 2}, {1, 2}, {2, 2}, {2.5, 2}}));
  // The last node lies inside, the corner beyond it.
  EXPECT_EQ(held(rectangle(0, 0, 2.125, 2, 1), edges_pin({2})).hold.points,
            (Points{{0, 2}, {1, 2}, {2, 2}, {2.125, 2}}));
  // Edges that meet share their corner. The edge across the cut row crosses the yarns between nodes.
  const scene::PieceSpec piece = rectangle(0, 0, 2.125, 2, 1);
  scene::PieceSpec fixed = piece;
  fixed.grid_origin = Vec2{0, 0};
  EXPECT_EQ(held(fixed, edges_pin({2, 1})).hold.points,
            (Points{{2.125, 0}, {2.125, 1}, {0, 2}, {1, 2}, {2, 2}, {2.125, 2}}));
  EXPECT_EQ(held(fixed, edges_pin({2})).hold.centre, (Vec2{1.0625, 2}));
}

TEST(Support, HeldPointsOfAWholeCellEdgeAreNodes) {
  const Held h = held(rectangle(0.1, -0.7, 0.4, 0.6, 0.01), edges_pin({0, 1, 2, 3}));
  EXPECT_EQ(h.hold.points.size(), 2u * 41 + 2 * 61 - 4);
  for (const GridPoint& at : h.hold.at) EXPECT_EQ(std::count(at.weight, at.weight + 4, 1.0), 1);
}

TEST(Support, PointsAreHeldOnce) {
  const Held h = held(rectangle(0, 0, 2.5, 2, 1),
                      points_pin({{2.5, 2}, {0.3, 0.4}, {1 + 1e-10, 1}, {0.3, 0.4}, {1, 1}}));
  EXPECT_EQ(h.hold.points, (Points{{0.3, 0.4}, {1, 1}, {2.5, 2}}));
  EXPECT_NEAR(h.hold.centre[0], (2.5 + 0.3 + 1 + 0.3 + 1) / 5, 1e-9);
}

// An arc of radius r about (0, 0), rotated with its grain. Its points lie within the sag of r, each on a
// yarn (or at an end). There is one point for each yarn that the arc crosses and that is nearer to its
// normal than the other kind: along the quarter circle the warp at x <= 1/sqrt 2, the weft at y <= 1/sqrt 2.
TEST(Support, CurvedEdgeIsHeldWhereItCrossesYarns) {
  for (const double grain : {0.0, 0.4}) {
    scene::PieceSpec piece = piece_of({{1, 0}, {0, 1}, {0, 0.5}, {0.5, 0}}, 0.1);
    piece.curves = {{0, {}, 1, false, true}};
    piece.grain = grain;
    piece.grid_origin = Vec2{0, 0};
    const Held h = held(piece, edges_pin({0}));
    int on_warp = 0, on_weft = 0;
    for (const Vec2& p : h.hold.points) {
      EXPECT_NEAR(std::hypot(p[0], p[1]), 1, 1.001e-4);
      const Vec2 at = grid_coordinates(h.grid, p);
      on_warp += at[0] == std::floor(at[0]);
      on_weft += at[1] == std::floor(at[1]);
      if (p != piece.outline[0] && p != piece.outline[1] && grain == 0) {
        EXPECT_TRUE(at[0] == std::floor(at[0]) || at[1] == std::floor(at[1]));
      }
    }
    if (grain == 0) {  // yarns at 0, 0.1, ..., 0.7 and the ends at 1
      EXPECT_EQ(on_warp, 9);
      EXPECT_EQ(on_weft, 9);
    }
    // The mean over the length of a quarter circle: 2/pi along either axis.
    for (double v : h.hold.centre) EXPECT_NEAR(v, 2 / std::numbers::pi, 1e-4);
  }
}

// Each yarn that an oblique edge holds has two nodes beside it, in which no other held point takes part
// except those at the corners: the rows leave one motion of the two.
TEST(Support, ObliqueEdgeLeavesOneMotionOfEachYarn) {
  for (const double slope : {0.3, 0.7, 1.0, 1.6, 4.0})
    for (const double shift : {0.0, 0.13, 0.61}) {
      const double w = slope < 1 ? 9 : 9 / slope;
      scene::PieceSpec piece = piece_of({{0.07, 0.11}, {9, -5}, {9, shift}, {9 - w, shift + w * slope}}, 1);
      piece.grid_origin = Vec2{0, 0};
      const Held h = held(piece, edges_pin({2}));
      const Vec2 ends[] = {piece.outline[2], piece.outline[3]};
      std::map<int, int> rows;
      for (std::size_t k = 0; k < h.hold.points.size(); ++k) {
        const Vec2& p = h.hold.points[k];
        const auto near = [&](const Vec2& q) { return std::hypot(p[0] - q[0], p[1] - q[1]) < 1e-6; };
        if (near(ends[0]) || near(ends[1])) continue;
        EXPECT_EQ(p[slope > 1 ? 1 : 0], std::round(p[slope > 1 ? 1 : 0])) << slope;
        const GridPoint& at = h.hold.at[k];
        if (std::count(at.weight, at.weight + 4, 0.0) < 2)
          continue;  // of a merged cell: it has its neighbour's nodes
        for (int n = 0; n < 4; ++n) {
          rows[at.node[n]] += at.weight[n] != 0;
          EXPECT_LE(rows[at.node[n]], 1) << slope << " " << shift;
        }
      }
    }
}

// Along a grid line s = 1. Half a cell beyond it s = 1/2, or 1.1 where the strip of 0.1 cells is merged.
// Where it is not merged, shares below 0.2 become 0.2.
TEST(Clamp, EdgeAcrossTheYarns) {
  for (const double top : {3.0, 2.5, 2.1}) {
    scene::PieceSpec piece = rectangle(0, 0, 4, top, 1);
    piece.grid_origin = Vec2{0, 0};
    const Held h = held(piece, edges_pin({2}), true);
    const std::vector<Slope> slopes = slopes_along(h, true);
    ASSERT_EQ(slopes.size(), 5u) << top;
    const double s = top == 3 ? 1 : top == 2.5 ? 0.5 : 1.1;
    for (const Slope& k : slopes) {
      EXPECT_EQ(k.from[1], top == 2.1 ? 2 : 3);
      EXPECT_EQ(k.to[1], top == 2.1 ? 1 : 2);
      EXPECT_EQ(k.from[0], k.to[0]);
      EXPECT_NEAR(k.clamp, 1 / (s * s), 1e-14);
      EXPECT_NEAR(k.series, s * s, 1e-14);
    }
    for (const HeldSlope& k : h.hold.slopes) EXPECT_TRUE(k.pivot);
    // Along the edge itself no yarn leaves it except those through its ends, which lie on the sides.
    EXPECT_EQ(slopes_along(h, false).size(), 0u);
  }
  EXPECT_TRUE(held(rectangle(0, 0, 4, 3, 1), edges_pin({2})).hold.slopes.empty());
}

// An edge at 45 degrees, with the cloth below left: every yarn that crosses it leaves downwards or to the
// left from the crossing, with s the distance to its next node.
TEST(Clamp, ObliqueEdge) {
  for (const double shift : {0.0, 0.25, 0.5, 0.9}) {
    scene::PieceSpec piece = piece_of({{0, 0}, {6 + shift, 0}, {0, 6 + shift}}, 1);
    piece.grid_origin = Vec2{0, 0};
    for (const bool reversed : {false, true}) {
      if (reversed) std::reverse(piece.outline.begin(), piece.outline.end());
      const Held h = held(piece, edges_pin({reversed ? 0 : 1}), true);
      for (const bool warp : {true, false}) {
        const std::vector<Slope> slopes = slopes_along(h, warp);
        EXPECT_EQ(slopes.size(), shift == 0 ? 6u : 7u) << shift;  // one past the corner leaves no cloth
        for (const Slope& k : slopes) {
          EXPECT_EQ(k.from[warp], k.to[warp] + 1);
          EXPECT_EQ(k.from[!warp], k.to[!warp]);
          // The yarn meets the edge at x + y = 6 + shift.
          const double s = 6 + shift - k.to[0] - k.to[1];
          EXPECT_NEAR(k.clamp, 1 / std::pow(std::max(s, 0.2), 2), 1e-12);
          EXPECT_NEAR(k.clamp * k.series, 1, 1e-14);
        }
      }
    }
  }
}

TEST(Clamp, PointAtANodeAndWithinACell) {
  Held h = held(rectangle(0, 0, 4, 3, 1), points_pin({{2, 1}}), true);
  ASSERT_EQ(h.hold.slopes.size(), 4u);
  for (const HeldSlope& s : h.hold.slopes) {
    EXPECT_EQ(h.grid.index(s.from), (std::array<int, 2>{2, 1}));
    EXPECT_EQ(s.warp, h.grid.index(s.to)[0] == 2);
    EXPECT_TRUE(s.clamp == 1 && s.series == 1 && s.pivot);
  }
  h = held(rectangle(0, 0, 4, 3, 1), points_pin({{2.25, 1.125}}), true);
  ASSERT_EQ(h.hold.slopes.size(), 4u);
  double warp = 0, weft = 0;
  for (const HeldSlope& s : h.hold.slopes) {
    const auto from = h.grid.index(s.from);
    EXPECT_EQ(s.clamp, s.warp ? (from[0] == 2 ? 0.75 : 0.25) : (from[1] == 1 ? 0.875 : 0.125));
    EXPECT_TRUE(s.series == 1 && !s.pivot);
    (s.warp ? warp : weft) += s.clamp;
  }
  EXPECT_EQ(warp, 1);
  EXPECT_EQ(weft, 1);
}

Points disc(Vec2 centre, double radius, int n) {
  Points points;
  for (int k = 0; k < n; ++k) {
    const double f = 2 * std::numbers::pi * (k + 0.3) / n;
    points.push_back({centre[0] + radius * std::cos(f), centre[1] + radius * std::sin(f)});
  }
  return points;
}

// Nodes within the disc, those barely outside, and for each leaving link the share outside the disc.
TEST(Support, DiscRegion) {
  RandomPiece random(4);
  for (int trial = 0; trial < 50; ++trial) {
    const double r = random(1.2, 4);
    const Vec2 c{random(5, 6), random(5, 6)};
    const Points polygon = disc(c, r, 90);
    scene::PieceSpec piece = rectangle(0, 0, 11, 11, 1);
    piece.grid_origin = Vec2{0, 0};
    const Held plain = held(piece, region_pin(polygon)), clamped = held(piece, region_pin(polygon), true);
    std::set<std::array<int, 2>> inside, nodes;
    for (int i = 0; i < 12; ++i)
      for (int j = 0; j < 12; ++j)
        if (polygon_distance(polygon, {i + 0.0, j + 0.0}) == 0) inside.insert({i, j});
    for (const GridPoint& at : plain.hold.at) {
      EXPECT_EQ(at.weight[0], 1);
      nodes.insert(plain.grid.index(at.node[0]));
    }
    EXPECT_EQ(nodes, inside);
    std::set<std::array<int, 2>> held_nodes;
    for (const GridPoint& at : clamped.hold.at) held_nodes.insert(clamped.grid.index(at.node[0]));
    for (const auto& n : inside) EXPECT_EQ(held_nodes.count(n), 1u);
    for (const HeldSlope& s : clamped.hold.slopes) {
      const auto from = clamped.grid.index(s.from), to = clamped.grid.index(s.to);
      EXPECT_EQ(held_nodes.count(from), 1u);
      EXPECT_EQ(held_nodes.count(to), 0u);
      // The distance from the circle to x1 along the yarn, which meets it at up to 64 degrees. The polygon
      // lies within r (1 - cos(pi/90)) of the circle.
      const double sag = r * (1 - std::cos(std::numbers::pi / 90)) / std::sqrt(1 - 0.81);
      const double across = s.warp ? to[0] - c[0] : to[1] - c[1],
                   along = s.warp ? to[1] - c[1] : to[0] - c[0];
      if (std::abs(across) > 0.9 * r) continue;  // grazes the rim
      const double rim = std::sqrt(r * r - across * across);
      double free = std::abs(along) - rim;
      if (inside.contains(from) || free < 1.2) {
        EXPECT_NEAR(1 / std::sqrt(s.clamp), free, sag);
        EXPECT_NEAR(s.series, 2 * free - free * free, 2 * sag);
        EXPECT_GE(free, 0.2 - sag);
      }
    }
    // Every link from a held node to a free one has a slope.
    std::set<std::pair<int, int>> links;
    std::set<int> held_at;
    for (const GridPoint& at : clamped.hold.at) held_at.insert(at.node[0]);
    for (const GridCell& cell : clamped.grid.cells)
      for (const auto& [k, l] : {std::pair{0, 1}, {2, 3}, {0, 2}, {1, 3}})
        if (held_at.count(cell.node[k]) != held_at.count(cell.node[l]))
          links.insert({cell.node[k], cell.node[l]});
    EXPECT_EQ(links.size(), clamped.hold.slopes.size());
    EXPECT_NEAR(std::hypot(clamped.hold.centre[0] - c[0], clamped.hold.centre[1] - c[1]), 0, 1e-13);
  }
}

// A region that holds all cloth of a cut cell also holds its corners beyond the piece. A region far larger
// than the piece holds all.
TEST(Support, RegionHoldsCellsWhoseClothLiesInside) {
  scene::PieceSpec piece = rectangle(0, 0, 2.5, 2, 1);
  EXPECT_EQ(held(piece, region_pin({{1, -1}, {2.5, -1}, {2.5, 3}, {1, 3}})).hold.points,
            (Points{{1, 0}, {2, 0}, {3, 0}, {1, 1}, {2, 1}, {3, 1}, {1, 2}, {2, 2}, {3, 2}}));
  EXPECT_EQ(held(piece, region_pin({{1, -1}, {2.4, -1}, {2.4, 3}, {1, 3}})).hold.points,
            (Points{{1, 0}, {2, 0}, {1, 1}, {2, 1}, {1, 2}, {2, 2}}));
  const Held all = held(piece, region_pin({{-1e4, -1e4}, {1e4, -1e4}, {1e4, 1e4}, {-1e4, 1e4}}), true);
  EXPECT_EQ(all.hold.points.size(), 12u);
  EXPECT_TRUE(all.hold.slopes.empty());
  EXPECT_TRUE(held(piece, region_pin({{8, 8}, {9, 8}, {9, 9}})).hold.points.empty());
  // Points on the rim count. A concave region leaves out the cell between its arms.
  EXPECT_EQ(held(rectangle(0, 0, 3, 1, 1),
                 region_pin({{0, 0}, {3, 0}, {3, 1}, {2, 1}, {2, 0.5}, {1, 0.5}, {1, 1}, {0, 1}}))
                .hold.points.size(),
            8u);
  // both sides of a slit
  const double w = 1e-6;
  const Held slit =
      held(piece_of({{0, 0}, {2.5 - w, 0}, {2.5, 2.5}, {2.5 + w, 0}, {5, 0}, {5, 5}, {0, 5}}, 1),
           region_pin({{0, 0}, {5, 0}, {5, 1}, {0, 1}}));
  EXPECT_EQ(slit.grid.twin.size(), 4u);
  EXPECT_EQ(slit.hold.at.size(), 2u * 6 + 4);
}

}  // namespace
}  // namespace drape::piece
