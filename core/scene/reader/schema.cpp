#include "scene/reader/schema.h"

#include <limits>

#include "scene/limits.h"

namespace drape::scene {

namespace {

constexpr double kPercent = 100;        // per 1
constexpr double kMicroNcm2 = 1e10;     // uN cm^2 per N m^2
constexpr double kMaxElongation = 1e3;  // percent
constexpr Range kPosition{-1e4, 1e4};
constexpr Range kWhole{-2147483647, 2147483647};  // checked against the outline later

// The range of a quantity in the unit of the key.
constexpr Range range_of(const Quantity& q, double per_si = 1) {
  return {q.low * per_si, q.high * per_si, q.above};
}

}  // namespace

std::vector<Key> scene_keys(Scene& s) {
  return {
      {"scene.name", Name{&s.name}, kRequired},
      {"scene.description", &s.about.description},
      {"scene.author", &s.about.author},
      {"scene.version", &s.about.version},
      {"scene.copyright", &s.about.copyright},
      {"scene.license", &s.about.license},
      {"scene.duration", &s.duration, kOptional, {0, 1e7, kAbove}, "s"},
      {"scene.gravity", &s.gravity, kOptional, range_of(kGravity), "m/s^2"},
      {"scene.integrator", Choice{{"leapfrog", "paper"}, [&s](int k) { s.integrator = Integrator(k); }}},
      {"scene.step", Auto{&s.step}, kOptional, {0, 1, kAbove}, "s"},
      {"scene.communication", &s.communication, kOptional, range_of(kCommunication), "s"},
      {"scene.damping", &s.damping, kOptional, range_of(kDamping), "1/s"},
      {"scene.energy", Flag{&s.energy}},
      {"scene.wind", &s.wind, kOptional, range_of(kWind), "m/s"},
      {"scene.mode", Choice{{kModeNames[0], kModeNames[1]}, [&s](int k) { s.mode = Mode(k); }}},
      {"scene.order", OneOf{{2, 4, 6}, &s.order}},
      {"scene.self_contact", Flag{&s.self_contact}},
      {"scene.imperfection.amplitude", &s.imperfection_amplitude, kRequired, {0, 1, kAbove}, "m"},
      {"scene.imperfection.seed", Whole{&s.imperfection_seed}, kOptional, {0, 1e15}},
      {"air.density", &s.air_density, kOptional, {0, 1e4}, "kg/m^3"},
      {"air.normal", &s.air_normal, kOptional, range_of(kAirCoefficient)},
      {"air.tangential", &s.air_tangential, kOptional, range_of(kAirCoefficient)},
      {"options.scaling", Choice{{"width", "paper_area"}, [&s](int k) { s.scaling = Scaling(k); }}},
      {"options.bias_model",
       Choice{{"odd", "tension", "paper"}, [&s](int k) { s.bias_model = BiasModel(k); }}},
      {"options.clamp_correction", Flag{&s.clamp_correction}},
      {"options.outline", Choice{{"cutcell", "paper"}, [&s](int k) { s.outline = OutlineModel(k); }}},
      {"fabric", Elsewhere{}},
      {"piece", Elsewhere{}},
      {"pin", Elsewhere{}},
      {"probe", Elsewhere{}},
      {"seam", Elsewhere{}},
      {"body", Elsewhere{}},
  };
}

std::vector<Key> fabric_keys(FabricText& t) {
  FabricSpec& f = t.spec;  // required values may come from a data sheet: datasheet_convert checks them
  std::vector<Key> keys = {
      {"file", &t.file},
      {"description", &t.description},
      {"source", &t.source},
      {"areal_density", &f.areal_density, kOptional, range_of(kArealDensity), "kg/m^2"},
      {"thickness", &f.thickness, kOptional, {1e-6, 0.1}, "m"},
      {"strip.width", &f.strip_width, kOptional, {1e-4, 10}, "m"},
      {"strip.gauge", &f.strip_gauge, kOptional, {1e-4, 100}, "m"},
      {"bending.rigidity_uN_cm2", &t.rigidity, kOptional, range_of(kSpecimenRigidity, kMicroNcm2), "uN cm^2",
       kMicroNcm2},
      {"bending.width", &t.bending_width, kOptional, range_of(kSpecimenWidth), "m"},
      {"bending.poisson", &f.poisson, kOptional, range_of(kPoisson)},
      {"compression", &f.compression, kOptional, range_of(kCompression)},
      {"compression_blend", &f.compression_blend, kOptional, {1e-6, 0.5}},
      {"friction", Pair{&f.friction, "[static, kinetic]"}, kOptional, range_of(kFriction)},
      {"damping", &f.damping, kOptional, range_of(kSpringDamping), "s"},
  };
  const bool samples = t.diagrams == Diagrams::kSamples;  // noise may take them below 0
  const auto diagram = [&](const std::string& name, DiagramSpec& d) {
    keys.push_back({name + ".elongation_percent",
                    &d.elongation,
                    kOptional,
                    {samples ? -kMaxElongation : 0, kMaxElongation},
                    "percent",
                    kPercent});
    keys.push_back({name + ".force", &d.force, kOptional,
                    samples ? Range{-kForce.high, kForce.high} : range_of(kForce), "N"});
    keys.push_back({name + ".correction", &d.correction, kOptional, {1e-3, 1e3}});
    keys.push_back({name + ".correction_elongation", &d.correction_elongation, kOptional, {0.1, 10}});
  };
  diagram("warp", f.warp);
  diagram("weft", f.weft);
  diagram("bias", f.bias);
  keys.push_back({"bias.jaws", Flag{&f.bias.jaws}});
  // The record of a calibration, and its corrections of diagrams that are computed from data sheets.
  keys.push_back({"calibration.cell", &t.calibration_cell, kRequired, {0, 10, kAbove}, "m"});
  keys.push_back({"calibration.residual", &t.calibration_residual, kRequired, {0, 1e3}});
  keys.push_back({"calibration.date", &t.calibration_date, kRequired});
  for (std::size_t k = 0; k < 3; ++k)
    keys.push_back({std::string("calibration.") + kDiagrams[k], &t.calibration[k], kOptional, {1e-3, 1e3}});
  for (std::size_t k = 0; k < 3; ++k) {
    RawText& raw = t.datasheet.raw[k];
    const std::string name = std::string(kDiagrams[k]) + ".raw.";
    keys.push_back({name + "elongation_percent",
                    &raw.percent,
                    kOptional,
                    {-kMaxElongation, kMaxElongation},
                    "percent",
                    kPercent});
    keys.push_back({name + "force", &raw.newtons, kOptional, {-kForce.high, kForce.high}, "N"});
  }
  for (Key& key : datasheet_keys(t)) keys.push_back(std::move(key));
  return keys;
}

std::vector<Key> piece_keys(PieceSpec& p, const std::vector<std::string>& fabrics) {
  return {
      {"name", Name{&p.name}, kRequired},
      {"fabric", Reference{&p.fabric, "fabric", &fabrics}, kRequired},
      {"cell", &p.cell, kRequired, {0, 10, kAbove}, "m"},
      {"outline", &p.outline, kRequired, kPosition, "m"},
      {"velocity", &p.velocity, kOptional, {-1e4, 1e4}, "m/s"},
      {"place.origin", &p.place.origin, kOptional, kPosition, "m"},
      {"place.axis_x", &p.place.axis_x, kOptional, {-1.1, 1.1}},
      {"place.axis_y", &p.place.axis_y, kOptional, {-1.1, 1.1}},
      {"place.cylinder.axis_point", &p.place.axis_point, kRequired, kPosition, "m"},
      {"place.cylinder.axis", &p.place.axis, kRequired, {-1.1, 1.1}},
      {"place.cylinder.radius",
       Pair{&p.place.radius, "[along the plane, across it]"},
       kRequired,
       {1e-4, 1e4},
       "m"},
      {"curves", Tables{[&p] { return curve_keys(p.curves.emplace_back()); }}},
      {"holes", &p.holes, kOptional, kPosition, "m"},
      {"grain", &p.grain, kOptional, {-10, 10}, "rad"},
      {"grid_origin", &p.grid_origin, kOptional, kPosition, "m"},
  };
}

std::vector<Key> curve_keys(CurveSpec& c) {
  return {
      {"edge", &c.edge, kRequired, kWhole},
      {"bezier", &c.bezier, kOptional, kPosition, "m"},
      {"arc", &c.radius, kOptional, {0, 1e4, kAbove}, "m"},
      {"large", Flag{&c.large}},
      {"right", Flag{&c.right}},
  };
}

std::vector<Key> pin_keys(PinSpec& p, const std::vector<std::string>& pieces) {
  return {
      {"name", Name{&p.name}, kRequired},
      {"piece", Reference{&p.piece, "piece", &pieces}, kRequired},
      {"at", &p.at, kOptional, kPosition, "m"},
      {"edges", &p.edges, kOptional, kWhole},
      {"region", &p.region, kOptional, kPosition, "m"},
      {"hold", Choice{{"point", "clamp"}, [&p](int k) { p.clamp = k == 1; }}},
      {"drive", Choice{{"position", "velocity", "both"}, [&p](int k) { p.drive = Drive(k + 1); }}},
  };
}

std::vector<Key> seam_keys(SeamSpec& s, const std::vector<std::string>& pieces) {
  std::vector<Key> keys = {
      {"name", Name{&s.name}, kRequired},
      {"closed_at", &s.closed_at, kOptional, {0, std::numeric_limits<double>::infinity()}, "s"},
      {"gap_tol", &s.gap_tolerance, kOptional, {1e-9, 1}, "m"},
      {"pull", Auto{&s.pull}, kOptional, {0, 1e6, kAbove}, "1/s"},
      {"speed", &s.speed, kOptional, {0, 1e3, kAbove}, "m/s"},
      {"tape", &s.tape, kOptional, {0, 1e6}, "N"},
  };
  for (int k = 0; k < 2; ++k) {
    SeamSide& side = s.side[k];
    const std::string name(1, "ab"[k]);
    keys.push_back({name + ".piece", Reference{&side.piece, "piece", &pieces}, kRequired});
    keys.push_back({name + ".edges", &side.edges, kRequired, kWhole});
    keys.push_back({name + ".reverse", Flag{&side.reverse}});
  }
  return keys;
}

std::vector<Key> body_keys(BodySpec& b, BodyText& text) {
  return {
      {"name", Name{&b.name}, kRequired},
      {"mesh", &text.mesh, kRequired},
      {"friction", Pair{&b.friction, "[static, kinetic]"}, kOptional, range_of(kFriction)},
      {"damping", &b.damping, kOptional, {0, 100}},
      {"moves", Flag{&b.moves}},
      {"drive", Choice{{"position", "velocity", "both"}, [&b](int k) { b.drive = Drive(k + 1); }}},
      {"position", &b.position, kOptional, kPosition, "m"},
      {"orientation", &text.orientation, kOptional, range_of(kPinOrientation)},
      {"scale", &b.scale, kOptional, {0, 1e6, kAbove}, "m per unit of the mesh"},
  };
}

std::vector<Key> probe_keys(ProbeSpec& p, const std::vector<std::string>& pieces) {
  return {
      {"name", Name{&p.name}, kRequired},
      {"piece", Reference{&p.piece, "piece", &pieces}, kRequired},
      {"at", &p.at, kRequired, kPosition, "m"},
  };
}

}  // namespace drape::scene
