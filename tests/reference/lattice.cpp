// Equations: core/README.md, section 1 (masses and widths from the cells' shares) and 3 (laws per width).
#include "reference/lattice.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "piece/grid.h"

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
  const PieceSpec& piece;
  const FabricSpec& fabric;
  Grid grid;
  std::vector<int> number;  // [rows x columns] particle, -1 where the node has no mass

  int at(int i, int j) const { return number[std::size_t(j) * std::size_t(grid.columns) + std::size_t(i)]; }
  double phi(int i, int j) const { return grid.share_at(i, j); }
  double warp_width(int i, int j) const { return grid.cell * (phi(i - 1, j) + phi(i, j)) / 2; }
  double weft_width(int i, int j) const { return grid.cell * (phi(i, j - 1) + phi(i, j)) / 2; }
};

void add_particles(Net& net, Lattice& lattice, std::vector<double>& r, std::vector<double>& v) {
  const double b = net.grid.cell;
  for (int j = 0; j < net.grid.rows; ++j) {
    for (int i = 0; i < net.grid.columns; ++i) {
      const double s = net.grid.node_share(i, j);
      net.number.push_back(s > 0 ? lattice.count++ : -1);
      if (!(s > 0)) continue;
      lattice.mass.push_back(net.fabric.areal_density * b * b * s);
      const Vec3 place = place_point(net.piece.place, {net.grid.x0 + i * b, net.grid.y0 + j * b});
      r.insert(r.end(), place.begin(), place.end());
      v.insert(v.end(), net.piece.velocity.begin(), net.piece.velocity.end());
    }
  }
}

void add_links(const Net& net, Lattice& lattice) {
  const double b = net.grid.cell;
  const int warp = int(lattice.laws.size()), weft = warp + 1, bias = warp + 2;
  lattice.laws.push_back(thread_law(net.scene, net.fabric, net.fabric.warp, b));
  lattice.laws.push_back(thread_law(net.scene, net.fabric, net.fabric.weft, b));
  lattice.laws.push_back(bias_law(net.scene, net.fabric, b));
  for (int j = 0; j < net.grid.rows; ++j) {
    for (int i = 0; i < net.grid.columns; ++i) {
      const double along_y = net.warp_width(i, j), along_x = net.weft_width(i, j);
      const double diagonal = b * net.phi(i, j) / kRoot2;
      if (along_y > 0) lattice.warp.push_back({net.at(i, j), net.at(i, j + 1), b, along_y, warp});
      if (along_x > 0) lattice.weft.push_back({net.at(i, j), net.at(i + 1, j), b, along_x, weft});
      if (!(diagonal > 0)) continue;
      lattice.bias.push_back({net.at(i, j), net.at(i + 1, j + 1), kRoot2 * b, diagonal, bias});
      lattice.bias.push_back({net.at(i + 1, j), net.at(i, j + 1), kRoot2 * b, diagonal, bias});
    }
  }
}

// kappa = B w/b with B = EI/(1 - nu^2), w the mean width of the two links; no hinge where one of them is 0.
void add_hinges(const Net& net, Lattice& lattice) {
  const double b = net.grid.cell, factor = 1 / (1 - net.fabric.poisson * net.fabric.poisson);
  const double B_warp = net.fabric.bending_warp * factor, B_weft = net.fabric.bending_weft * factor;
  for (int j = 0; j < net.grid.rows; ++j) {
    for (int i = 0; i < net.grid.columns; ++i) {
      const double below = net.warp_width(i, j - 1), above = net.warp_width(i, j);
      const double left = net.weft_width(i - 1, j), right = net.weft_width(i, j);
      if (B_warp > 0 && below > 0 && above > 0) {
        const double kappa = B_warp * (below + above) / 2 / b;
        lattice.hinges.push_back({net.at(i, j - 1), net.at(i, j), net.at(i, j + 1), kappa});
      }
      if (B_weft > 0 && left > 0 && right > 0) {
        const double kappa = B_weft * (left + right) / 2 / b;
        lattice.hinges.push_back({net.at(i - 1, j), net.at(i, j), net.at(i + 1, j), kappa});
      }
    }
  }
}

Point point_at(const Net& net, Vec2 q) {
  const GridPoint found = grid_locate(net.grid, q);
  Point point;
  for (int k = 0; k < 4; ++k) {
    if (found.weight[k] == 0) continue;
    point.node.push_back(net.at(found.i[k], found.j[k]));
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
    const PieceSpec& piece = scene.pieces[p];
    nets.push_back({scene, piece, scene.fabrics[std::size_t(piece.fabric)], grid_make(scene, int(p)), {}});
    Net& net = nets.back();
    add_particles(net, lattice, r, v);
    add_links(net, lattice);
    add_hinges(net, lattice);
    lattice.cell = p == 0 ? net.grid.cell : std::min(lattice.cell, net.grid.cell);
  }
  for (const PinSpec& pin : scene.pins) {
    const Net& net = nets[std::size_t(pin.piece)];
    for (Vec2 q : pin_points(net.grid, net.piece, pin)) {
      lattice.rows.push_back({point_at(net, q), int(lattice.pins.size())});
    }
    lattice.pins.push_back(pin.name);
  }
  for (const ProbeSpec& probe : scene.probes) {
    lattice.probes.push_back(point_at(nets[std::size_t(probe.piece)], probe.at));
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
