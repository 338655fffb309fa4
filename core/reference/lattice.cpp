// Equations: core/README.md, sections 1 (masses and widths from the cells' shares), 3 (bending) and 4
// (clamps).
#include "reference/lattice.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <set>

#include "piece/place.h"
#include "piece/support/support.h"
#include "seam/layout.h"

namespace drape::reference {
namespace {

const double kRoot2 = std::numbers::sqrt2;

// One piece with its grid and the numbers of its particles.
struct Net {
  const Scene& scene;
  int index;  // of the piece
  piece::Grid grid;
  std::vector<int> number;  // [nodes of the grid] particle; -1 where the node has no mass
  std::map<std::pair<int, int>, double> warp, weft;  // m, widths of links by their nodes
  std::vector<piece::Support> supports;              // [pins] empty for pins of other pieces

  const scene::PieceSpec& piece() const { return scene.pieces[std::size_t(index)]; }
  const scene::FabricSpec& fabric() const { return scene.fabrics[std::size_t(piece().fabric)]; }
  int at(int node) const { return number[std::size_t(node)]; }
};

void add_particles(Net& net, Lattice& lattice, std::vector<double>& r, std::vector<double>& v) {
  for (int n = 0; n < net.grid.nodes(); ++n) {
    const double area = net.grid.area[std::size_t(n)];
    net.number.push_back(area > 0 ? lattice.count++ : -1);
    if (!(area > 0)) continue;
    lattice.mass.push_back(net.fabric().areal_density * area);
    const Vec3 place = piece::place_start(net.scene, net.index, net.grid.place(n));
    r.insert(r.end(), place.begin(), place.end());
    v.insert(v.end(), net.piece().velocity.begin(), net.piece().velocity.end());
  }
}

void add_links(Net& net, Lattice& lattice) {
  const double b = net.grid.cell;
  const int warp = int(lattice.laws.size()), weft = warp + 1, bias = warp + 2;
  lattice.laws.push_back(yarn_law(net.scene, net.fabric(), net.fabric().warp, b));
  lattice.laws.push_back(yarn_law(net.scene, net.fabric(), net.fabric().weft, b));
  lattice.laws.push_back(bias_law(net.scene, net.fabric(), b));
  for (int law : {warp, weft, bias}) lattice.laws[std::size_t(law)].damping = net.fabric().damping;
  for (const piece::GridCell& cell : net.grid.cells) {
    const auto [a, right, above, opposite] = cell.node;
    const double half = b * cell.share / 2, diagonal = b * cell.share / kRoot2;
    net.warp[{a, above}] += half;
    net.warp[{right, opposite}] += half;
    net.weft[{a, right}] += half;
    net.weft[{above, opposite}] += half;
    lattice.cells.push_back({{net.at(a), net.at(right), net.at(above), net.at(opposite)}, cell.share});
    lattice.bias.push_back({net.at(a), net.at(opposite), kRoot2 * b, diagonal, bias});
    lattice.bias.push_back({net.at(right), net.at(above), kRoot2 * b, diagonal, bias});
  }
  for (const auto& [ends, width] : net.warp)
    lattice.warp.push_back({net.at(ends.first), net.at(ends.second), b, width, warp});
  for (const auto& [ends, width] : net.weft)
    lattice.weft.push_back({net.at(ends.first), net.at(ends.second), b, width, weft});
}

// The effect of clamps on the hinges along warp or weft.
struct Clamped {
  std::map<std::pair<int, int>, double> series;  // q_c of the link (from, to) in the hinge at `to`; else 1
  std::set<int> pivots;                          // nodes without a hinge

  double q(int from, int to) const {
    const auto found = series.find({from, to});
    return found == series.end() ? 1 : found->second;
  }
};

Clamped clamped_yarns(const Net& net, bool warp) {
  Clamped clamped;
  for (const piece::Support& support : net.supports)
    for (const piece::HeldSlope& slope : support.slopes) {
      if (slope.warp != warp) continue;
      clamped.series.emplace(std::pair{slope.from, slope.to}, slope.series);
      if (slope.pivot) clamped.pivots.insert(slope.from);
    }
  return clamped;
}

// B/b along warp or weft, B = EI/(1 - nu^2).
double link_rigidity(const Net& net, bool warp) {
  const scene::FabricSpec& fabric = net.fabric();
  return (warp ? fabric.bending_warp : fabric.bending_weft) / (1 - fabric.poisson * fabric.poisson) /
         net.grid.cell;
}

// A hinge is half of each of two links in series: kappa = (B/b) 2 w_0 w_1/(q_0 W_1 + q_1 W_0). W_0 and W_1
// are the total widths of the links along the yarn that end and begin at the middle node.
void add_hinges(const Net& net, bool warp, Lattice& lattice) {
  const double B = link_rigidity(net, warp);
  if (!(B > 0)) return;
  const auto& links = warp ? net.warp : net.weft;
  const Clamped clamped = clamped_yarns(net, warp);
  std::map<int, double> ending, beginning;
  for (const auto& [ends, w] : links) {
    beginning[ends.first] += w;
    ending[ends.second] += w;
  }
  for (const auto& [first, w0] : links) {
    const auto [i, j] = first;
    if (clamped.pivots.contains(j)) continue;
    for (auto next = links.lower_bound({j, 0}); next != links.end() && next->first.first == j; ++next) {
      const auto& [second, w1] = *next;
      const double q0 = clamped.q(i, j), q1 = clamped.q(second.second, j);
      lattice.hinges.push_back({net.at(i), net.at(j), net.at(second.second),
                                B * 2 * w0 * w1 / (q0 * beginning[j] + q1 * ending[j])});
    }
  }
}

// A clamp hinge is the half link between a clamp and a link that leaves it: kappa_c = y 2 B w/b.
void add_clamps(const Net& net, const piece::Support& support, int pin, Lattice& lattice) {
  for (const piece::HeldSlope& slope : support.slopes) {
    const double B = link_rigidity(net, slope.warp);
    if (!(B > 0)) continue;
    const auto& links = slope.warp ? net.warp : net.weft;
    const auto found = links.find({slope.from, slope.to});
    const double width = found != links.end() ? found->second : links.at({slope.to, slope.from});
    lattice.clamps.push_back({net.at(slope.from), net.at(slope.to), slope.clamp * 2 * B * width, pin});
  }
}

Point point_at(const Net& net, const piece::GridPoint& found) {
  Point point;
  for (int k = 0; k < 4; ++k) {
    if (found.weight[k] == 0) continue;
    point.node.push_back(net.at(found.node[k]));
    point.weight.push_back(found.weight[k]);
  }
  return point;
}

void add_pin(const Net& net, int index, Lattice& lattice) {
  const scene::PinSpec& spec = net.scene.pins[std::size_t(index)];
  const piece::Support& support = net.supports[std::size_t(index)];
  const Vec3 centre = piece::place_point(net.piece().place, support.centre);
  lattice.pins.push_back({spec.name, {centre[0], centre[1], centre[2]}, spec.drive, spec.clamp});
  for (const piece::GridPoint& at : support.at) lattice.rows.push_back({point_at(net, at), index});
  add_clamps(net, support, index, lattice);
}

// Sets the start positions of held points and the start directions of clamped links.
void measure_start(Lattice& lattice) {
  for (Row& row : lattice.rows) row.start = point_value(row.point, lattice.position);
  for (ClampHinge& clamp : lattice.clamps)
    clamp.direction =
        (lattice.position.segment<3>(3 * clamp.j) - lattice.position.segment<3>(3 * clamp.i)).normalized();
}

// omega of a piece at rest, 1/s.
double omega_at_rest(const Net& net, const Lattice& lattice) {
  const double b = net.grid.cell, nu = net.fabric().poisson;
  const auto slope = [&](int law) {
    return curve_slope(lattice.laws[std::size_t(3 * net.index + law)].curve, 0);
  };
  const double B = (net.fabric().bending_warp + net.fabric().bending_weft) / (1 - nu * nu);
  return std::sqrt((4 * std::max(slope(0), slope(1)) + 8 * slope(2) / 2 + 16 * B / (b * b)) /
                   (net.fabric().areal_density * b * b));
}

// kappa = 2 W/(b_a/B_a + b_b/B_b)
void add_seam_hinge(const std::vector<Net>& nets, const scene::SeamSpec& spec, const seam::SeamLayout& layout,
                    std::size_t n, Seam& seam) {
  std::array<Point, 2> inner;
  double compliance = 0;
  bool bends = true;
  for (std::size_t k = 0; k < 2; ++k) {
    const Net& net = nets[std::size_t(spec.side[k].piece)];
    const double b = net.grid.cell, grain = net.piece().grain;
    const Vec2 in = layout.inward[k][n], p = layout.point[k][n];
    inner[k] = point_at(net, piece::grid_locate(net.grid, {p[0] + b * in[0], p[1] + b * in[1]}));
    const double c = -in[0] * std::sin(grain) + in[1] * std::cos(grain), s2 = 1 - c * c;
    const double B = b * (link_rigidity(net, true) * c * c * c * c + link_rigidity(net, false) * s2 * s2);
    bends = bends && B > 0;
    compliance += b / B;
  }
  const bool end = !seam.closed && (n == 0 || n + 1 == layout.point[0].size());
  seam.inner.push_back(inner);
  seam.kappa.push_back(bends ? (end ? 1 : 2) * seam.rest / compliance : 0);
}

void add_seam_links(const std::vector<Net>& nets, const scene::SeamSpec& spec, const seam::SeamLayout& layout,
                    Seam& seam) {
  const std::size_t shorter = layout.length[1] < layout.length[0] ? 1 : 0;
  const Net& net = nets[std::size_t(spec.side[shorter].piece)];
  const Vec2 from = layout.point[shorter].front(), to = layout.point[shorter].back();
  const double grain = net.piece().grain, x = to[0] - from[0], y = to[1] - from[1];
  const bool warp = std::abs(y * std::cos(grain) - x * std::sin(grain)) >=
                    std::abs(x * std::cos(grain) + y * std::sin(grain));
  seam.rest = std::min(layout.spacing[0], layout.spacing[1]);
  seam.closed = layout.closed;
  seam.linked = std::abs(layout.spacing[0] - layout.spacing[1]) > 1e-6 * seam.rest || spec.tape > 0;
  seam.width = net.grid.cell;
  seam.tape = spec.tape;
  seam.law = 3 * net.index + (warp ? 0 : 1);
}

void add_seam(const std::vector<Net>& nets, const scene::SeamSpec& spec, double omega, Lattice& lattice) {
  const seam::SeamLayout layout = seam::seam_layout(nets[0].scene, spec);
  Seam seam{};
  seam.name = spec.name;
  seam.closed_at = spec.closed_at;
  seam.gap_tolerance = spec.gap_tolerance;
  seam.speed = spec.speed;
  seam.pull = spec.pull > 0 ? spec.pull : omega / 10;
  add_seam_links(nets, spec, layout, seam);
  for (std::size_t n = 0; n < layout.point[0].size(); ++n) {
    std::array<Point, 2> pair;
    for (std::size_t k = 0; k < 2; ++k) {
      const Net& net = nets[std::size_t(spec.side[k].piece)];
      const Vec2 p = layout.point[k][n], in = layout.inward[k][n];
      const double d = 1e-6 * net.grid.cell;
      const int cell = piece::grid_cell_of(net.grid, {p[0] + d * in[0], p[1] + d * in[1]});
      pair[k] = point_at(net, piece::grid_point(net.grid, cell, piece::grid_coordinates(net.grid, p)));
    }
    seam.pairs.push_back(pair);
    add_seam_hinge(nets, spec, layout, n, seam);
    if (pair[0].node == pair[1].node && pair[0].weight == pair[1].weight) seam.kappa.back() = 0;
  }
  lattice.seams.push_back(std::move(seam));
}

Net net_make(const Scene& scene, int piece) {
  Net net{scene, piece, piece::grid_make(scene, piece), {}, {}, {}, {}};
  for (const scene::PinSpec& pin : scene.pins)
    net.supports.push_back(pin.piece == piece ? piece::support_make(net.grid, scene, pin) : piece::Support{});
  return net;
}

}  // namespace

Lattice lattice_make(const Scene& scene) {
  Lattice lattice;
  std::vector<double> r, v;
  std::vector<Net> nets;
  for (std::size_t p = 0; p < scene.pieces.size(); ++p) {
    nets.push_back(net_make(scene, int(p)));
    Net& net = nets.back();
    add_particles(net, lattice, r, v);
    add_links(net, lattice);
    for (bool warp : {true, false}) add_hinges(net, warp, lattice);
    lattice.cell = p == 0 ? net.grid.cell : std::min(lattice.cell, net.grid.cell);
  }
  for (std::size_t k = 0; k < scene.pins.size(); ++k)
    add_pin(nets[std::size_t(scene.pins[k].piece)], int(k), lattice);
  for (const scene::ProbeSpec& probe : scene.probes) {
    const Net& net = nets[std::size_t(probe.piece)];
    lattice.probes.push_back(point_at(net, piece::grid_locate(net.grid, probe.at)));
  }
  double omega = 0;
  for (const Net& net : nets) omega = std::max(omega, omega_at_rest(net, lattice));
  for (const scene::SeamSpec& seam : scene.seams) add_seam(nets, seam, omega, lattice);
  lattice.position = Eigen::Map<Eigen::VectorXd>(r.data(), Eigen::Index(r.size()));
  lattice.velocity = Eigen::Map<Eigen::VectorXd>(v.data(), Eigen::Index(v.size()));
  measure_start(lattice);
  return lattice;
}

Eigen::Vector3d point_value(const Point& point, const Eigen::VectorXd& x) {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (std::size_t k = 0; k < point.node.size(); ++k) {
    sum += point.weight[k] * x.segment<3>(3 * point.node[k]);
  }
  return sum;
}

}  // namespace drape::reference
