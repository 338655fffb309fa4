// Crossings and touches of outlines, against a comparison of all pairs in whole numbers.
#include "piece/outline/crossings.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace drape::piece {
namespace {

using Point = std::array<int, 2>;

int side(Point a, Point b, Point c) {
  const int cross = (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
  return (cross > 0) - (cross < 0);
}

bool within(Point a, Point b, Point c) {  // c on the line of a and b: is it between them?
  for (std::size_t k = 0; k < 2; ++k)
    if (c[k] < std::min(a[k], b[k]) || c[k] > std::max(a[k], b[k])) return false;
  return true;
}

bool meet(Point a, Point b, Point c, Point d) {
  const int abc = side(a, b, c), abd = side(a, b, d), cda = side(c, d, a), cdb = side(c, d, b);
  if (abc != abd && cda != cdb) return true;
  return (abc == 0 && within(a, b, c)) || (abd == 0 && within(a, b, d)) || (cda == 0 && within(c, d, a)) ||
         (cdb == 0 && within(c, d, b));
}

bool is_simple(const std::vector<Point>& p) {
  const std::size_t n = p.size();
  for (std::size_t i = 0; i < n; ++i) {
    const Point a = p[i], b = p[(i + 1) % n], c = p[(i + 2) % n];
    if (side(a, b, c) == 0 && (within(a, b, c) || within(b, c, a))) return false;  // folded back
    for (std::size_t j = i + 2; j < n; ++j)
      if ((j + 1) % n != i && meet(a, b, p[j], p[(j + 1) % n])) return false;
  }
  return true;
}

std::vector<Point> random_points(std::mt19937& random, int count) {
  std::uniform_int_distribution<int> place(0, 6);
  std::vector<Point> points;
  while (int(points.size()) < count) {
    const Point p{place(random), place(random)};
    if (!points.empty() && (p == points.back() || (int(points.size()) + 1 == count && p == points[0])))
      continue;
    points.push_back(p);
  }
  return points;
}

// Whole numbers leave gaps of 0 or at least 0.1. Shifted by a hundredth of the contact distance, and turned.
TEST(OutlineCrossings, AreFoundWhereverAnyTwoSegmentsMeet) {
  constexpr double kContact = 1e-6, kTurn = 0.7;
  std::mt19937 random(1);
  std::uniform_real_distribution<double> shift(-1e-2 * kContact, 1e-2 * kContact);
  int simple = 0, trials = 20000;
  for (int t = 0; t < trials; ++t) {
    const std::vector<Point> points = random_points(random, 3 + t % 9);
    OutlineLoop loop, shifted, turned;
    for (const Point& p : points) {
      const double x = p[0] + shift(random), y = p[1] + shift(random);
      loop.points.push_back({double(p[0]), double(p[1])});
      shifted.points.push_back({x, y});
      turned.points.push_back(
          {x * std::cos(kTurn) - y * std::sin(kTurn), x * std::sin(kTurn) + y * std::cos(kTurn)});
      for (OutlineLoop* l : {&loop, &shifted, &turned}) l->edge.push_back(int(l->edge.size()));
    }
    const bool expected = is_simple(points);
    simple += expected;
    for (const OutlineLoop& l : {loop, shifted, turned})
      ASSERT_EQ(outline_crossings({l}, kContact, 10).empty(), expected) << "trial " << t;
  }
  EXPECT_GT(simple, trials / 10);
  EXPECT_LT(simple, trials / 2);
}

// Both sides of a slit are closer than `contact`, from end to end: at every angle.
TEST(OutlineCrossings, FindANarrowSlit) {
  constexpr double kContact = 1e-6;
  for (int k = 0; k < 64; ++k) {
    const double c = std::cos(0.1 * k), s = std::sin(0.1 * k);
    for (const double width : {0.3 * kContact, 3 * kContact}) {
      OutlineLoop loop;
      for (const Vec2 p :
           {Vec2{0, 0}, {3, 0}, {3, 2}, {2, 2}, {2, 1}, {2 - width, 1 + 2 * width}, {2 - width, 2}, {0, 2}}) {
        loop.points.push_back({p[0] * c - p[1] * s, p[0] * s + p[1] * c});
        loop.edge.push_back(int(loop.edge.size()));
      }
      EXPECT_EQ(outline_crossings({loop}, kContact, 10).empty(), width > kContact) << k;
    }
  }
}

// All crossings are listed, up to the number that was asked for.
TEST(OutlineCrossings, AreListed) {
  const OutlineLoop star{{{0, 0}, {4, 0}, {0.5, 3}, {2, -2}, {3.5, 3}}, {0, 1, 2, 3, 4}};
  EXPECT_EQ(outline_crossings({star}, 1e-9, 10).size(), 5u);
  EXPECT_EQ(outline_crossings({star}, 1e-9, 2).size(), 2u);
}

}  // namespace
}  // namespace drape::piece
