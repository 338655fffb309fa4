// outline = "paper": rigid links tie the particles of seams to the outlines. core/README.md, sections 4 and
// 6.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <numeric>

#include "model/node_sums.h"
#include "piece/outline/outline.h"
#include "seam/particles.h"
#include "seam_fixture.h"

namespace drape::constraint {

using namespace tests;
namespace {

using reference::curved_fabric;
using reference::rectangle;

// Two pieces side by side, `gap` apart, whose grids do not meet the outlines.
Scene two_pieces(Vec3 gap) {
  Scene scene = rectangle(curved_fabric(), 0.05, 0.05, 0.008);
  scene.outline = scene::OutlineModel::kPaper;
  scene.gravity = {0, 0, 0};
  scene.pieces[0].grain = 0.3;
  scene.pieces.push_back(scene.pieces[0]);
  scene.pieces[1].name = "right";
  scene.pieces[1].cell = 0.008 * std::numbers::sqrt2;
  scene.pieces[1].grain = -0.4;
  scene.pieces[1].place.origin = {0.05 + gap[0], gap[1], gap[2]};
  scene.seams = {seam_join()};
  return scene;
}

double worst_link(const Assembled& a) {  // |r_b - r_a|/L - 1
  double largest = 0;
  const State& s = a.state;
  for (const RigidLink& l : a.system.links) {
    const auto [i, j] = l.node;
    const Vec3 d{s.x[j] - s.x[i], s.y[j] - s.y[i], s.z[j] - s.z[i]};
    largest = std::max(largest, std::abs(math::vector3::norm(d) / l.length - 1));
  }
  return largest;
}

// Links reach 1.5 cells, except for particles with fewer than three nodes so near. Points on the grid use
// the grid.
TEST(RigidLinks, TiesToTheEdgeWithinOneAndAHalfCells) {
  const Scene scene = two_pieces({0, 0, 0});
  std::vector<std::vector<seam::GridTie>> ties;
  const std::vector<piece::Grid> grids = seam::grids_make(scene, &ties);
  for (std::size_t p = 0; p < 2; ++p) {
    std::map<int, int> count;
    std::map<int, double> longest;
    for (const seam::GridTie& t : ties[p]) {
      ++count[t.node[0]];
      longest[t.node[0]] = std::max(longest[t.node[0]], t.length);
      const Vec2 a = grids[p].place(t.node[0]), b = grids[p].place(t.node[1]);
      EXPECT_DOUBLE_EQ(t.length, std::hypot(a[0] - b[0], a[1] - b[1]));
      EXPECT_NEAR(a[0], p == 0 ? 0.05 : 0, 1e-15);  // on the outline
    }
    EXPECT_EQ(count.size(), grids[p].on_outline.size());
    for (const auto& [particle, n] : count) {
      EXPECT_GE(n, 3);
      if (n > 3) {
        EXPECT_LE(longest[particle], 1.5 * grids[p].cell * (1 + 1e-8));
      }
    }
    const double area = std::accumulate(grids[p].area.begin(), grids[p].area.end(), 0.0);
    EXPECT_NEAR(area, 0.05 * 0.05, 1e-12 * area);
  }
  Scene even = two_pieces({0, 0, 0});
  even.pieces[0].grain = 0;
  even.pieces[0].cell = 0.01;
  EXPECT_TRUE(seam::grids_make(even)[0].on_outline.empty());
}

// While the pieces are pulled, during the weld and after it, links keep their lengths and the cloth its
// momentum. Joined, the two trusses have more links than their particles can satisfy once the cloth bends:
// they share the remaining error.
TEST(RigidLinks, KeepsLengthsAndMomentum) {
  Scene scene = two_pieces({0.004, 0.001, 0.003});
  scene.pieces[0].velocity = {0.3, -0.2, 0.1};
  Assembled a = assemble(scene);
  double apart = 0, joined = 0, mass = 0;  // worst links
  const auto momentum = [&] {
    Vec3 sum{0, 0, 0};
    for (std::size_t n : a.system.particle) {
      using namespace math::vector3;
      sum += a.system.mass[n] * Vec3{a.state.vx[n], a.state.vy[n], a.state.vz[n]};
    }
    return sum;
  };
  for (std::size_t n : a.system.particle) mass += a.system.mass[n];
  EXPECT_NEAR(mass, 2 * 0.15 * 0.05 * 0.05, 1e-12 * mass);
  const Vec3 start = momentum();
  for (int k = 0; k < 300; ++k) {
    sewn_advance(a, 1e-3);
    const bool sewn = std::count(a.state.sewn.begin(), a.state.sewn.end(), model::Sewn::kWelded) > 0;
    (sewn ? joined : apart) = std::max(sewn ? joined : apart, worst_link(a));
    const Vec3 now = momentum();
    for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR(now[i], start[i], 1e-12 * mass);
  }
  std::printf("rigid links: lengths within %.1e, of the joined trusses within %.1e\n", apart, joined);
  EXPECT_LE(apart, 1e-5);
  EXPECT_LE(joined, 1e-3);
  EXPECT_EQ(std::count(a.state.sewn.begin(), a.state.sewn.end(), model::Sewn::kWelded),
            std::ptrdiff_t(a.state.sewn.size()));
  for (const model::SeamPair& pair : a.system.seams.pair)
    EXPECT_LE(math::vector3::norm(model::sum_value(pair.gap, a.state)), 1e-14);
}

// Before the weld the motion is of order 2 in the step: (x_h - x_{h/2})/(x_{h/2} - x_{h/4}) = 4.
TEST(RigidLinks, IsOfOrderTwo) {
  std::vector<Eigen::VectorXd> ends;
  for (double h : {4e-5, 2e-5, 1e-5}) {
    Scene scene = two_pieces({0.004, 0.001, 0.003});
    scene.seams[0].pull = 400;
    scene.seams[0].gap_tolerance = 1e-9;
    scene.step = h;
    Assembled a = assemble(scene);
    for (int k = 0; k < 10; ++k) sewn_advance(a, 1e-3);
    ends.push_back(positions(a));
  }
  const double order = std::log2((ends[0] - ends[1]).norm() / (ends[1] - ends[2]).norm());
  std::printf("rigid links: order %.2f\n", order);
  EXPECT_NEAR(order, 2, 0.2);
}

// A restored state continues with the same bits: the motion depends on the state alone.
TEST(RigidLinks, GoesOnFromAState) {
  Assembled a = assemble(two_pieces({0.002, 0, 0.001}));
  for (int k = 0; k < 30; ++k) sewn_advance(a, 1e-3);
  const State saved = a.state;
  for (int k = 0; k < 30; ++k) sewn_advance(a, 1e-3);
  const Eigen::VectorXd end = positions(a);
  a.state = saved;
  dynamics::seams_restore(a.system, a.motion, a.state);
  for (int k = 0; k < 30; ++k) sewn_advance(a, 1e-3);
  EXPECT_EQ((positions(a) - end).cwiseAbs().maxCoeff(), 0);
}

}  // namespace
}  // namespace drape::constraint
