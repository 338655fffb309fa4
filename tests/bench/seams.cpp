#include "bench/seams.h"

#include <Eigen/SparseCholesky>
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <stdexcept>

#include "assembly/assemble.h"
#include "forces/seam_bending.h"
#include "laboratory/stiffness.h"
#include "model/node_sums.h"

namespace drape::bench {
namespace {

constexpr double kWidth = 0.06, kHeight = 3 * kWidth;  // m
constexpr double kPull = 1e-4;                         // of the height
constexpr double kPenalty = 1e3;                       // s over the largest entry of K
constexpr int kSweeps = 12;
constexpr double kLocked = 10;   // stiffer than that: links between jaws that cannot stretch
constexpr double kRest = 1e-13;  // of the force

struct Rest {
  std::vector<piece::Grid> grids;
  System system;
  State state;
  laboratory::Unknowns unknowns;
  Eigen::VectorXd u;
  double force = 0, left = 0;
};

scene::DiagramSpec straight(double k) { return {{0, 0.1}, {0, 0.1 * k * 0.05}, {}}; }

scene::PieceSpec piece_of(const char* name, double cell, std::vector<Vec2> outline) {
  scene::PieceSpec piece;
  piece.name = name;
  piece.fabric = 0;
  piece.cell = cell;
  piece.outline = std::move(outline);
  return piece;
}

void pin_add(Scene& scene, int piece, int edge, bool high) {
  scene::PinSpec pin;
  pin.name = (high ? "high" : "low") + std::to_string(piece);
  pin.piece = piece;
  pin.edges = {edge};
  scene.pins.push_back(pin);
}

Scene strip(bool paper) {
  Scene scene;
  scene.name = "strip";
  scene.clamp_correction = false;
  scene.gravity = {0, 0, 0};
  scene.outline = paper ? scene::OutlineModel::kPaper : scene::OutlineModel::kCutCell;
  scene::FabricSpec fabric;
  fabric.name = "linear";
  fabric.areal_density = 0.15;
  fabric.thickness = 5e-4;
  fabric.warp = straight(1000);
  fabric.weft = straight(800);
  fabric.bias = straight(200);
  scene.fabrics = {fabric};
  return scene;
}

Scene uncut(const SeamCase& of) {
  Scene scene = strip(of.paper);
  scene.pieces = {
      piece_of("whole", kWidth / of.across, {{0, 0}, {kWidth, 0}, {kWidth, kHeight}, {0, kHeight}})};
  pin_add(scene, 0, 0, false);
  pin_add(scene, 0, 2, true);
  return scene;
}

Scene cut(const SeamCase& of) {
  Scene scene = strip(of.paper);
  const double b = kWidth / of.across, c = b * of.ratio, w = kWidth, h = kHeight, middle = h / 2;
  scene::SeamSpec seam;
  seam.name = "cut";
  if (of.cut == SeamCut::kWarp) {
    scene.pieces = {piece_of("left", b, {{0, 0}, {w / 2, 0}, {w / 2, h}, {0, h}}),
                    piece_of("right", c, {{w / 2, 0}, {w, 0}, {w, h}, {w / 2, h}})};
    for (int p : {0, 1}) pin_add(scene, p, 0, false), pin_add(scene, p, 2, true);
    seam.side[0] = {0, {1}, false};
    seam.side[1] = {1, {3}, true};
  } else {
    const double rise = of.cut == SeamCut::kOblique ? std::tan(std::numbers::pi / 6) * w / 2 : 0;
    scene.pieces = {piece_of("lower", b, {{0, 0}, {w, 0}, {w, middle + rise}, {0, middle - rise}}),
                    piece_of("upper", c, {{0, middle - rise}, {w, middle + rise}, {w, h}, {0, h}})};
    pin_add(scene, 0, 0, false);
    pin_add(scene, 1, 2, true);
    seam.side[0] = {0, {2}, true};
    seam.side[1] = {1, {0}, false};
  }
  scene.seams = {seam};
  return scene;
}

using Entries = std::vector<Eigen::Triplet<double>>;

// The matrix B and the targets t.
struct Held {
  Eigen::SparseMatrix<double> rows;
  Eigen::VectorXd target;
  std::vector<Eigen::Index> high;  // rows along y of the upper jaw
};

Held held_of(const Scene& scene, const Rest& rest) {
  Held held;
  Entries entries;
  std::vector<double> target;
  const auto& first = rest.unknowns.first;
  const auto entry = [&](std::size_t node, double weight, int axis) {
    if (weight != 0) entries.emplace_back(Eigen::Index(target.size()), first[node] + axis, weight);
  };
  const auto add = [&](const constraint::ConstraintRow& row, int axis, double to) {
    for (std::size_t k = 0; k < row.node.size(); ++k) entry(row.node[k], row.weight[k], axis);
    target.push_back(to);
  };
  for (const constraint::ConstraintRow& row : rest.system.pin_rows) {
    const bool high = scene.pins[std::size_t(row.pin)].name[0] == 'h';
    add(row, 0, 0);
    if (high) held.high.push_back(Eigen::Index(target.size()));
    add(row, 1, high ? kPull * kHeight : 0);
  }
  for (const model::SeamPair& pair : rest.system.seams.pair)
    for (int axis : {0, 1}) {
      for (const model::NodeTerm& t : pair.gap) entry(t.node, t.weight, axis);
      target.push_back(0);
    }
  for (const constraint::RigidLink& link : rest.system.links) {
    const auto [a, b] = link.node;
    const double x = (rest.state.x[b] - rest.state.x[a]) / link.length,
                 y = (rest.state.y[b] - rest.state.y[a]) / link.length;
    for (int axis : {0, 1}) {
      const double along = axis == 0 ? x : y;
      entries.emplace_back(Eigen::Index(target.size()), first[a] + axis, -along);
      entries.emplace_back(Eigen::Index(target.size()), first[b] + axis, along);
    }
    target.push_back(0);
  }
  held.rows.resize(Eigen::Index(target.size()), rest.unknowns.count);
  held.rows.setFromTriplets(entries.begin(), entries.end());
  held.target = Eigen::Map<Eigen::VectorXd>(target.data(), Eigen::Index(target.size()));
  return held;
}

// Adds the links along a seam.
void links_add(const Rest& rest, Entries& to) {
  for (const model::Seam& seam : rest.system.seams.seam)
    for (std::size_t k = seam.link_first; k < seam.link_first + seam.link_count; ++k) {
      const model::NodeSum& row = rest.system.seams.link[k].edge;
      const Vec3 edge = model::sum_value(row, rest.state);
      const double length = math::vector3::norm(edge),
                   stiff = forces::seam_link_slope(rest.system, seam) / seam.rest;
      for (const model::NodeTerm& i : row)
        for (const model::NodeTerm& j : row)
          for (std::size_t p : {0u, 1u})
            for (std::size_t q : {0u, 1u})
              to.emplace_back(rest.unknowns.first[i.node] + Eigen::Index(p),
                              rest.unknowns.first[j.node] + Eigen::Index(q),
                              stiff * i.weight * j.weight * edge[p] * edge[q] / (length * length));
    }
}

Rest rest_of(const Scene& scene) {
  Rest rest;
  std::vector<Problem> problems;
  rest.system = assembly::system_assemble(scene, rest.state, problems);
  for (const Problem& p : problems) throw std::runtime_error(scene::problem_text(p));
  for (std::size_t p = 0; p < scene.pieces.size(); ++p) rest.grids.push_back(piece::grid_make(scene, int(p)));
  rest.unknowns = laboratory::unknowns_make(rest.system, 2);
  laboratory::Triplets entries;
  laboratory::stiffness_add(rest.system, rest.state, laboratory::Stiffness::kTangent, rest.unknowns, entries);
  links_add(rest, entries);
  Eigen::SparseMatrix<double> K(rest.unknowns.count, rest.unknowns.count);
  K.setFromTriplets(entries.begin(), entries.end());
  const Held held = held_of(scene, rest);
  const double s = kPenalty * K.coeffs().cwiseAbs().maxCoeff();
  const Eigen::SparseMatrix<double> B = held.rows, normal = B.transpose() * B, M = K + s * normal;
  const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> solver(M);
  rest.u = Eigen::VectorXd::Zero(rest.unknowns.count);
  Eigen::VectorXd q = Eigen::VectorXd::Zero(B.rows());
  for (int sweep = 0; sweep < kSweeps; ++sweep) {
    const Eigen::VectorXd pull = q + s * (B * rest.u - held.target);
    rest.u += solver.solve(-(K * rest.u) - B.transpose() * pull);
    q += s * (B * rest.u - held.target);
    rest.force = 0;
    for (Eigen::Index r : held.high) rest.force -= q[r];
    rest.left = (K * rest.u + B.transpose() * q).norm() / rest.force;
    if ((B * rest.u - held.target).norm() <= kRest * kPull * kHeight) break;
  }
  return rest;
}

// The displacement along y at a point of a piece.
double lift(const Rest& rest, std::size_t piece, Vec2 p) {
  const piece::GridPoint at = piece::grid_locate(rest.grids[piece], p);
  double sum = 0;
  for (int k = 0; k < 4; ++k)
    if (at.weight[k] != 0)
      sum += at.weight[k] * rest.u[rest.unknowns.first[rest.system.lattices[piece].node_of(at.node[k])] + 1];
  return sum;
}

// The rms difference of the strains between points two coarse cells apart.
double strain_error(const SeamCase& of, const Rest& sewn, const Rest& whole) {
  const double step = 2 * of.ratio * kWidth / of.across, slope = std::tan(std::numbers::pi / 6);
  double sum = 0;
  int count = 0;
  for (int i = 1; i < 12; ++i)
    for (int j = 1; j < 60; ++j) {
      const Vec2 p{kWidth * i / 12, kHeight * j / 60};
      const double cut_at = kHeight / 2 + (of.cut == SeamCut::kOblique ? slope * (p[0] - kWidth / 2) : 0);
      const double off = of.cut == SeamCut::kWarp ? p[0] - kWidth / 2 : p[1] - cut_at;
      const double end = std::min(p[1], kHeight - p[1]);
      if (std::abs(off) < 1.5 * step || end < 1.5 * step) continue;
      const std::size_t piece = off > 0;
      const Vec2 low{p[0], p[1] - step / 2}, high{p[0], p[1] + step / 2};
      const double e = (lift(sewn, piece, high) - lift(sewn, piece, low)) / step;
      const double exact = (lift(whole, 0, high) - lift(whole, 0, low)) / step;
      sum += (e - exact) * (e - exact);
      ++count;
    }
  return count > 0 ? std::sqrt(sum / count) / kPull : NAN;
}

const char* name_of(SeamCut cut) {
  return cut == SeamCut::kWeft ? "weft" : cut == SeamCut::kWarp ? "warp" : "30 degrees";
}

}  // namespace

SeamFigure seam_figure(const SeamCase& of) {
  const Rest whole = rest_of(uncut(of)), sewn = rest_of(cut(of));
  return {sewn.force / whole.force - 1, strain_error(of, sewn, whole), std::max(whole.left, sewn.left)};
}

bool seams_print(const std::string& csv_file, bool quick) {
  std::FILE* csv = csv_file.empty() ? nullptr : std::fopen(csv_file.c_str(), "w");
  if (!csv_file.empty() && !csv) return false;
  if (csv) std::fprintf(csv, "cut,ratio,ties,cells_across,stiffness_percent,strain_rms_percent\n");
  std::printf("A strip cut and sewn against the uncut one: stiffness and rms of the strain, percent\n");
  std::printf("%-11s %6s  %-8s %18s %18s %18s %7s\n", "cut", "ratio", "ties", "W/20", "W/40", "W/80",
              "order");
  for (SeamCut cut : {SeamCut::kWeft, SeamCut::kWarp, SeamCut::kOblique})
    for (double ratio : {1.0, std::numbers::sqrt2, 2.0, 3.0})
      for (bool paper : {false, true}) {
        std::printf("%-11s %6.3f  %-8s", name_of(cut), ratio, paper ? "paper" : "cutcell");
        double first = 0, last = 0;
        for (int across : {20, 40, 80}) {
          if (quick && across > 20) break;
          const SeamFigure f = seam_figure({cut, ratio, across, paper});
          if (f.stiffness > kLocked) std::printf(" %18s", "locked");
          else std::printf(" %+9.4f %8.4f", 100 * f.stiffness, 100 * f.strain);
          if (csv)
            std::fprintf(csv, "%s,%.6g,%s,%d,%.6g,%.6g\n", name_of(cut), ratio, paper ? "paper" : "cutcell",
                         across, 100 * f.stiffness, 100 * f.strain);
          first = across == 20 ? f.stiffness : first;
          last = f.stiffness;
        }
        if (!quick && std::abs(last) > 1e-9 && last < kLocked)
          std::printf(" %7.2f", std::log2(std::abs(first / last)) / 2);
        std::printf("\n");
        std::fflush(stdout);
      }
  return !csv || std::fclose(csv) == 0;
}

}  // namespace drape::bench
