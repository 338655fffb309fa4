// Equations: core/README.md, section 1 (masses and widths from the cells' shares) and 3 (laws per width).
#include "reference/lattice.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include "piece/hold.h"
#include "piece/place.h"

namespace drape::reference {
namespace {

const double kRoot2 = std::sqrt(2.0);

bool switched_on(const DiagramSpec& d) {
  return std::any_of(d.force.begin(), d.force.end(), [](double f) { return f != 0; });
}

// P_i = z F_i / (K w_p): the diagram as force per width.
std::vector<double> per_width(const DiagramSpec& d, double z, double K, double strip_width) {
  std::vector<double> P;
  for (double F : d.force) P.push_back(z * F / (K * strip_width));
  return P;
}

// P_i q_i with the stored correction q, 1 where there is none.
std::vector<double> corrected(std::vector<double> P, const DiagramSpec& d) {
  for (std::size_t i = 0; i < d.correction.size(); ++i) P[i] *= d.correction[i];
  return P;
}

Law thread_law(const Scene& scene, const FabricSpec& fabric, const DiagramSpec& d, double b) {
  if (!switched_on(d)) return {Curve{}, std::numeric_limits<double>::infinity()};
  const double z = scene.scaling == Scaling::kPaperArea ? b / fabric.strip_gauge : 1;
  const std::vector<double> P = corrected(per_width(d, z, 1, fabric.strip_width), d);
  return {curve_make(d.elongation, P, Below::kCompression, fabric.compression, fabric.compression_blend),
          d.elongation.back()};
}

// K = r (r - 1.25)/(r - 1)^2: how much the jaws stiffen a strip cut at 45 degrees, r = gauge/width.
double clamp_stiffening(const FabricSpec& fabric) {
  const double r = fabric.strip_gauge / fabric.strip_width;
  return r * (r - 1.25) / ((r - 1) * (r - 1));
}

Law bias_law(const Scene& scene, const FabricSpec& fabric, double b) {
  const DiagramSpec& d = fabric.bias;
  if (!switched_on(d)) return {Curve{}, std::numeric_limits<double>::infinity()};
  const double z = scene.scaling == Scaling::kPaperArea ? kRoot2 * b / fabric.strip_gauge : 1;
  const bool stored = !d.correction.empty();
  const double K = scene.clamp_correction && !stored ? clamp_stiffening(fabric) : 1;
  const std::vector<double> P = per_width(d, z, K, fabric.strip_width);
  const double end = d.elongation.back();
  if (scene.bias_model == BiasModel::kTension) {
    return {curve_make(d.elongation, corrected(P, d), Below::kCompression, 0, fabric.compression_blend), end};
  }
  if (scene.bias_model == BiasModel::kPaper) {
    return {curve_make(d.elongation, corrected(P, d), Below::kCompression, fabric.compression,
                       fabric.compression_blend),
            end};
  }
  if (!stored) return {odd_law(d.elongation, P), end};
  const std::vector<double> kept = below_locking(d.elongation);
  std::vector<double> g = corrected(P, d);
  g.resize(kept.size());
  return {curve_make(kept, g, Below::kOdd), end};
}

// One piece on its grid, and the numbers of its particles.
struct Net {
  const Scene& scene;
  int index;  // of the piece
  Grid grid;
  std::vector<int> number;  // [nodes of the grid] particle, -1 where the node carries nothing
  std::map<std::pair<int, int>, double> warp, weft;  // widths of links by their nodes

  const PieceSpec& piece() const { return scene.pieces[std::size_t(index)]; }
  const FabricSpec& fabric() const { return scene.fabrics[std::size_t(piece().fabric)]; }
  int at(int node) const { return number[std::size_t(node)]; }
};

void add_particles(Net& net, Lattice& lattice, std::vector<double>& r, std::vector<double>& v) {
  for (int n = 0; n < net.grid.nodes(); ++n) {
    const double area = net.grid.area[std::size_t(n)];
    net.number.push_back(area > 0 ? lattice.count++ : -1);
    if (!(area > 0)) continue;
    lattice.mass.push_back(net.fabric().areal_density * area);
    const Vec3 place = place_start(net.scene, net.index, net.grid.place(n));
    r.insert(r.end(), place.begin(), place.end());
    v.insert(v.end(), net.piece().velocity.begin(), net.piece().velocity.end());
  }
}

void add_links(Net& net, Lattice& lattice) {
  const double b = net.grid.cell;
  const int warp = int(lattice.laws.size()), weft = warp + 1, bias = warp + 2;
  lattice.laws.push_back(thread_law(net.scene, net.fabric(), net.fabric().warp, b));
  lattice.laws.push_back(thread_law(net.scene, net.fabric(), net.fabric().weft, b));
  lattice.laws.push_back(bias_law(net.scene, net.fabric(), b));
  for (const GridCell& cell : net.grid.cells) {
    const auto [a, right, above, opposite] = cell.node;
    const double half = b * cell.share / 2, diagonal = b * cell.share / kRoot2;
    net.warp[{a, above}] += half;
    net.warp[{right, opposite}] += half;
    net.weft[{a, right}] += half;
    net.weft[{above, opposite}] += half;
    lattice.bias.push_back({net.at(a), net.at(opposite), kRoot2 * b, diagonal, bias});
    lattice.bias.push_back({net.at(right), net.at(above), kRoot2 * b, diagonal, bias});
  }
  for (const auto& [ends, width] : net.warp)
    lattice.warp.push_back({net.at(ends.first), net.at(ends.second), b, width, warp});
  for (const auto& [ends, width] : net.weft)
    lattice.weft.push_back({net.at(ends.first), net.at(ends.second), b, width, weft});
}

// Two links of a thread in series, half of each: kappa = (B/b) 2 w_0 w_1/(W_1 + W_0), B = EI/(1 - nu^2); W_0, W_1 the
// widths of all links of the thread that end and begin at the middle node.
void add_hinges(const Net& net, Lattice& lattice) {
  const FabricSpec& fabric = net.fabric();
  const double factor = 1 / (1 - fabric.poisson * fabric.poisson) / net.grid.cell;
  for (const auto& [links, B] : {std::pair{&net.warp, fabric.bending_warp * factor},
                                 std::pair{&net.weft, fabric.bending_weft * factor}}) {
    if (!(B > 0)) continue;
    std::map<int, double> ending, beginning;
    for (const auto& [ends, w] : *links) {
      beginning[ends.first] += w;
      ending[ends.second] += w;
    }
    for (const auto& [first, w0] : *links)
      for (auto next = links->lower_bound({first.second, 0});
           next != links->end() && next->first.first == first.second; ++next)
        lattice.hinges.push_back({net.at(first.first), net.at(first.second), net.at(next->first.second),
                                  B * 2 * w0 * next->second / (beginning[first.second] + ending[first.second])});
  }
}

Point point_at(const Net& net, const GridPoint& found) {
  Point point;
  for (int k = 0; k < 4; ++k) {
    if (found.weight[k] == 0) continue;
    point.node.push_back(net.at(found.node[k]));
    point.weight.push_back(found.weight[k]);
  }
  return point;
}

}  // namespace

Lattice lattice_make(const Scene& scene) {
  Lattice lattice;
  std::vector<double> r, v;
  std::vector<Net> nets;
  for (std::size_t p = 0; p < scene.pieces.size(); ++p) {
    nets.push_back({scene, int(p), grid_make(scene, int(p)), {}, {}, {}});
    Net& net = nets.back();
    add_particles(net, lattice, r, v);
    add_links(net, lattice);
    add_hinges(net, lattice);
    lattice.cell = p == 0 ? net.grid.cell : std::min(lattice.cell, net.grid.cell);
  }
  for (const PinSpec& pin : scene.pins) {
    const Net& net = nets[std::size_t(pin.piece)];
    for (const GridPoint& at : hold_make(net.grid, scene, pin).at)
      lattice.rows.push_back({point_at(net, at), int(lattice.pins.size())});
    lattice.pins.push_back(pin.name);
  }
  for (const ProbeSpec& probe : scene.probes) {
    const Net& net = nets[std::size_t(probe.piece)];
    lattice.probes.push_back(point_at(net, grid_locate(net.grid, probe.at)));
  }
  lattice.position = Eigen::Map<Eigen::VectorXd>(r.data(), Eigen::Index(r.size()));
  lattice.velocity = Eigen::Map<Eigen::VectorXd>(v.data(), Eigen::Index(v.size()));
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
