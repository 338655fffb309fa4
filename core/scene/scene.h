// A scene as plain structs: what the TOML file says, converted to SI units, nothing derived from it.
#pragma once
#include <array>
#include <cmath>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace drape {

using Vec2 = std::array<double, 2>;
using Vec3 = std::array<double, 3>;

enum class Integrator { kLeapfrog, kPaper };
enum class Scaling { kWidth, kPaperArea };
enum class BiasModel { kOdd, kTension, kPaper };

// A load-elongation diagram of a strip: point k is (elongation[k], force[k]); point 0 is the origin.
struct DiagramSpec {
  std::vector<double> elongation;  // [n] fraction, rising
  std::vector<double> force;       // [n] N on the strip, not falling
  std::vector<double> correction;  // [n] law = diagram x correction; empty = 1
};

struct FabricSpec {
  std::string name;
  double areal_density = 0;                      // kg/m^2
  double thickness = 0;                          // m
  double strip_width = 0.05, strip_gauge = 0.2;  // m, the tensile specimen
  DiagramSpec warp, weft, bias;                  // empty = law off
  double bending_warp = 0, bending_weft = 0;     // N m, EI per width before the Poisson factor
  double poisson = 0;                            // B = EI / (1 - poisson^2)
  double compression = 1;                        // slope below zero over the slope at zero
  double compression_blend = 0.002;              // strain over which it gets there
};

// r = origin + x axis_x + y axis_y; the axes orthonormal after reading.
struct PlaceSpec {
  Vec3 origin{0, 0, 0}, axis_x{1, 0, 0}, axis_y{0, 1, 0};
};

struct PieceSpec {
  std::string name;
  int fabric = -1;            // index into Scene::fabrics
  double cell = 0;            // m
  std::vector<Vec2> outline;  // [n] m; edge i runs from point i to point i + 1
  Vec3 velocity{0, 0, 0};     // m/s
  PlaceSpec place;
};

struct PinSpec {
  std::string name;
  int piece = -1;          // index into Scene::pieces
  std::vector<Vec2> at;    // points of the piece ...
  std::vector<int> edges;  // ... or outline edges, counted from 0
};

struct ProbeSpec {
  std::string name;
  int piece = -1;
  Vec2 at{0, 0};
};

struct Scene {
  std::string name;
  double duration = 1;        // s
  Vec3 gravity{0, 0, -9.81};  // m/s^2
  Integrator integrator = Integrator::kLeapfrog;
  double step = 0;              // s; 0 = automatic
  double communication = 1e-3;  // s
  double damping = 0;           // 1/s
  bool energy = false;
  Scaling scaling = Scaling::kWidth;
  BiasModel bias_model = BiasModel::kOdd;
  bool clamp_correction = true;
  std::vector<FabricSpec> fabrics;
  std::vector<PieceSpec> pieces;
  std::vector<PinSpec> pins;
  std::vector<ProbeSpec> probes;
};

// One thing wrong with the input: where, "scene.toml:12: piece.sheet.cell", and what, "= -0.01 m; allowed:
// above 0, at most 10 m". Together they are a sentence.
struct Problem {
  std::string place, message;
};

inline std::string problem_text(const Problem& p) { return p.place + " " + p.message; }

}  // namespace drape
