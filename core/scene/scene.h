// A scene as plain structs: the values of the TOML file in SI units, without derived quantities.
#pragma once
#include <array>
#include <cmath>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "math/vector3.h"

namespace drape::scene {

enum class Integrator { kLeapfrog, kPaper };
enum class Scaling { kWidth, kPaperArea };
enum class BiasModel { kOdd, kTension, kPaper };
enum class OutlineModel { kCutCell, kPaper };
enum class Mode { kDynamic, kFit };
enum class Drive { kNone, kPosition, kVelocity, kBoth };

// The key and unit in which the user gave a list; used in messages.
struct GivenAs {
  const char *key, *unit;
  double per_si;  // key units in one SI unit
};

// What the diagrams of a fabric hold: points for a law, or the samples of a tensile tester, with noise.
enum class Diagrams { kFinished, kSamples };

// A load-elongation diagram of a strip: point k is (elongation[k], force[k]); point 0 is the origin.
struct DiagramSpec {
  std::vector<double> elongation;               // [n] fraction, increasing
  std::vector<double> force;                    // [n] N on the strip, not decreasing
  std::vector<double> correction;               // [n] factor of the forces; empty: 1
  std::vector<double> correction_elongation{};  // [n] factor of the elongations; empty: 1
  bool jaws = true;                             // bias: the strip was clamped in jaws, which stiffen it
  GivenAs elongation_as{"elongation_percent", "percent", 100}, force_as{"force", "N", 1};
};

struct FabricSpec {
  std::string name;
  double areal_density = 0;                      // kg/m^2
  double thickness = 0;                          // m
  double strip_width = 0.05, strip_gauge = 0.2;  // m, the tensile specimen
  DiagramSpec warp, weft, bias;                  // empty: law off
  double bending_warp = 0, bending_weft = 0;     // N m, EI per width before the Poisson factor
  double bending_width = 0.03;                   // m, width of the bending specimen
  double poisson = 0;                            // B = EI / (1 - poisson^2)
  double compression = 1;                        // slope below zero over the slope at zero
  double compression_blend = 0.002;              // strain over which the slope changes from one to the other
  double damping = 0;                            // s, of the springs: force + damping x its rate
  Vec2 friction{0.3, 0.3};                       // static, kinetic
};

// The placement of a piece in space: r = origin + x axis_x + y axis_y. The axes are orthonormal after
// reading. The plane can be rolled onto a circular or elliptic cylinder: core/README.md, section 1.
struct PlaceSpec {
  Vec3 origin{0, 0, 0}, axis_x{1, 0, 0}, axis_y{0, 1, 0};
  Vec2 radius{0, 0};                        // m, radii of the cylinder along and across the plane; 0: flat
  Vec3 axis_point{0, 0, 0}, axis{0, 0, 1};  // of the cylinder; `axis` has length 1 after reading
};

// A curved edge of an outline. With control points it is a Bezier curve (1: quadratic, 2: cubic); without, an
// arc.
struct CurveSpec {
  int edge = -1;
  std::vector<Vec2> bezier;          // [1 or 2] m
  double radius = 0;                 // m, radius of the arc
  bool large = false, right = true;  // the longer of the two arcs; the arc along which the angle increases
};

struct PieceSpec {
  std::string name;
  int fabric = -1;                       // index into Scene::fabrics
  double cell = 0;                       // m
  std::vector<Vec2> outline;             // [n] m; edge i runs from point i to point i + 1
  std::vector<CurveSpec> curves;         // curved edges of the outline
  std::vector<std::vector<Vec2>> holes;  // m
  double grain = 0;                      // rad, counter-clockwise, from y to the warp
  std::optional<Vec2> grid_origin;       // m; default: core/README.md, section 1
  Vec3 velocity{0, 0, 0};                // m/s
  PlaceSpec place;
};

struct PinSpec {
  std::string name;
  int piece = -1;              // index into Scene::pieces
  std::vector<Vec2> at;        // the pin supports points of the piece ...
  std::vector<int> edges;      // ... or outline edges, counted from 0 ...
  std::vector<Vec2> region{};  // ... or a polygon
  bool clamp = false;          // also supports the slope of the cloth
  Drive drive = Drive::kNone;
};

// One side of a seam: consecutive edges of an outline, in the order of the outline.
struct SeamSide {
  int piece = -1;  // index into Scene::pieces
  std::vector<int> edges;
  bool reverse = false;  // the side starts at the end of its last edge
};

// A seam joins two sides, start to start.
struct SeamSpec {
  std::string name;
  SeamSide side[2];
  double closed_at = 0;         // s, time at which closing starts; infinite: only on request
  double gap_tolerance = 1e-4;  // m
  double pull = 0;              // w, 1/s, closing rate; 0: automatic
  double speed = 1;             // m/s, largest closing speed of free points
  double tape = 0;              // N per unit strain, stiffness of a tape sewn into the seam
};

// A polyhedral object that is in contact with the cloth.
struct BodySpec {
  std::string name;
  std::string mesh;       // a file
  Vec2 friction{-1, -1};  // static, kinetic; below 0: the fabric's
  double damping = 1;     // of the normal motion in contact, relative to critical damping
  bool moves = false;
  Drive drive = Drive::kNone;  // of a body that moves; kNone: by its positions until a velocity is given
  Vec3 position{0, 0, 0};      // m
  std::array<double, 4> orientation{1, 0, 0, 0};  // w, x, y, z
  double scale = 1;                               // m per unit of the mesh
};

struct ProbeSpec {
  std::string name;
  int piece = -1;
  Vec2 at{0, 0};
};

// What the scene says of itself, for the description of its FMU. Texts may be empty.
struct About {
  std::string description, author, version, copyright, license;
};

struct Scene {
  std::string name;
  About about;
  double duration = 1;        // s
  Vec3 gravity{0, 0, -9.81};  // m/s^2
  Integrator integrator = Integrator::kLeapfrog;
  int order = 2;                // 2, 4, 6
  double step = 0;              // s; 0: automatic
  double communication = 1e-3;  // s
  double damping = 0;           // 1/s
  bool energy = false;
  bool self_contact = false;
  Scaling scaling = Scaling::kWidth;
  BiasModel bias_model = BiasModel::kOdd;
  bool clamp_correction = true;
  OutlineModel outline = OutlineModel::kCutCell;
  Mode mode = Mode::kDynamic;
  Vec3 wind{0, 0, 0};        // m/s
  bool has_air = false;      // air coefficients are given
  double air_density = 1.2;  // kg/m^3
  double air_normal = 0, air_tangential = 0;
  double imperfection_amplitude = 0;  // m
  std::int64_t imperfection_seed = 0;
  std::vector<FabricSpec> fabrics;
  std::vector<PieceSpec> pieces;
  std::vector<SeamSpec> seams;
  std::vector<BodySpec> bodies;
  std::vector<PinSpec> pins;
  std::vector<ProbeSpec> probes;
};

// One problem of the input: its place, "scene.toml:12: piece.sheet.cell", and a message,
// "= -0.01 m; allowed: above 0, at most 10 m". Joined by a space they form a sentence.
struct Problem {
  std::string place, message;
};

inline std::string problem_text(const Problem& p) { return p.place + " " + p.message; }

}  // namespace drape::scene

namespace drape {
using scene::Problem;
using scene::Scene;
}  // namespace drape
