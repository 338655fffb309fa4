#include "variables.h"

#include "scene/limits.h"

#include <algorithm>
#include <cstdio>
#include <numeric>

namespace drape::description {
namespace {

using Table = std::vector<Variable>;

// What the rows of a family share.
struct Row {
  Causality causality;
  Variability variability;
  const char* unit;
  Range range;
  int needs = 0;
  AtStart at_start = AtStart::kNothing;
  const char* display_unit = nullptr;
  Type type = Type::kReal;
};

constexpr Range kAny{};
constexpr Range range_of(const scene::Quantity& l) { return {l.low, l.high, l.above, false, l.whole}; }

constexpr Row tunable(const scene::Quantity& l) {
  return {Causality::kParameter, Variability::kTunable, l.unit, range_of(l), 0, AtStart::kActs};
}
constexpr Row fixed(const scene::Quantity& l) {
  return {Causality::kParameter, Variability::kFixed, l.unit, range_of(l), 0, AtStart::kActs};
}
constexpr Row input(const scene::Quantity& l) {
  return {Causality::kInput, Variability::kContinuous, l.unit, range_of(l)};
}
constexpr Row output(int needs, const char* unit) {
  return {Causality::kOutput, Variability::kContinuous, unit, kAny, needs};
}
constexpr Row output_discrete(int needs, const char* unit) {
  return {Causality::kOutput, Variability::kDiscrete, unit, kAny, needs};
}

// The same row, with another part in outputs before the first step, unit of display, or type.
constexpr Row idle(Row row) { return row.at_start = AtStart::kNothing, row; }
constexpr Row acting(Row row) { return row.at_start = AtStart::kActs, row; }
constexpr Row of_parameters(Row row) { return row.at_start = AtStart::kOfParameters, row; }
constexpr Row of_forces(Row row) { return row.at_start = AtStart::kOfForces, row; }
constexpr Row shown_in(const char* unit, Row row) { return row.display_unit = unit, row; }
constexpr Row typed(Type type, Row row) { return row.type = type, row; }

// Where a value is kept. An output comes as a constant, and is read only.
struct Storage {
  const double* value;
  double* setting;

  Storage(const double* v) : value(v), setting(nullptr) {}
  Storage(double* v) : value(v), setting(v) {}
  Storage operator+(int k) const {
    Storage shifted = *this;
    shifted.value += k;
    if (setting) shifted.setting += k;
    return shifted;
  }
};

void add(Table& table, const std::string& name, const Storage& storage, const Row& row,
         const std::string& description) {
  double* const setting = row.causality == Causality::kOutput ? nullptr : storage.setting;
  table.push_back({name, "", description, "", row.causality, row.variability, row.unit, row.range,
                   storage.value, setting, nullptr, row.needs, row.type, row.display_unit, row.at_start});
}

// "[INSIDE]". Not "[" + inside + "]": of that GCC 12 gives a wrong warning (bug 105651).
std::string bracketed(const std::string& inside) {
  std::string text = "[";
  text += inside;
  return text += ']';
}

// name[1] to name[3], along x, y and z.
void add_vector(Table& table, const std::string& name, const Storage& storage, const Row& row,
                const std::string& description) {
  for (int k = 0; k < 3; ++k) {
    add(table, name, storage + k, row, description);
    table.back().index = bracketed(std::to_string(k + 1));
    table.back().detail = std::string(1, "xyz"[k]);
  }
}

// Gives the last three rows, a position, their derivatives.
void derivatives_set(Table& table, const double* velocity, int needs) {
  for (int k = 0; k < 3; ++k) {
    Variable& row = table[table.size() - 3 + std::size_t(k)];
    row.derivative = velocity + k, row.derivative_needs = needs;
  }
}

// The numbers of an input, and their rates. Each number has a letter.
struct InputStorage {
  double* value;
  double* rate;
  std::string_view letters;
};

// name[1] to name[n], one for each letter.
void add_input(Table& table, const std::string& name, const InputStorage& storage, const Row& row,
               const std::string& description) {
  for (std::size_t k = 0; k < storage.letters.size(); ++k) {
    add(table, name, storage.value + k, row, description);
    table.back().index = bracketed(std::to_string(k + 1));
    table.back().detail = std::string(1, storage.letters[k]);
    table.back().rate = storage.rate + k;
  }
}

// name[1] to name[n] at the diagram's elongations after the origin.
void add_diagram(Table& table, const std::string& name, const drape_diagram& diagram, const char* direction) {
  for (int i = 0; i < diagram.count; ++i) {
    char elongation[48];
    std::snprintf(elongation, sizeof elongation, "at %.6g %% elongation", 100 * diagram.elongation[i]);
    add(table, name, diagram.force + i, tunable(scene::kForce),
        std::string("force on the strip cut ") + direction);
    table.back().index = bracketed(std::to_string(i + 1));
    table.back().detail = elongation;
  }
}

void add_strain(Table& table, const std::string& name, const drape_strain& strain,
                const std::string& direction) {
  const Row row = shown_in("%", output(DRAPE_OUT_STRAIN, "1"));
  add(table, name + ".min", &strain.min, row, "smallest strain of the cloth " + direction);
  add(table, name + ".max", &strain.max, row, "largest strain of the cloth " + direction);
  add(table, name + ".mean", &strain.mean, row,
      "mean strain of the cloth " + direction + ", weighted by area");
}

// A part of a name as FMI's structured naming requires it: an identifier, or else in quotes.
std::string name_part(const char* text) {
  const std::string_view view = text;
  const auto letter = [](char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_'; };
  const auto digit = [](char c) { return c >= '0' && c <= '9'; };
  const bool plain = !view.empty() && letter(view[0]) &&
                     std::all_of(view.begin(), view.end(), [&](char c) { return letter(c) || digit(c); });
  if (plain) return text;
  std::string quoted = "'";
  for (const char c : view) {
    if (c == '\'' || c == '\\') quoted += '\\';
    quoted += c;
  }
  return quoted + "'";
}

void add_fabric(Table& table, drape_fabric& f) {
  const std::string name = "fabric." + name_part(f.name);
  add(table, name + ".areal_density", &f.areal_density, tunable(scene::kArealDensity), "mass per area");
  add_diagram(table, name + ".warp.force", f.warp, "along the warp");
  add_diagram(table, name + ".weft.force", f.weft, "along the weft");
  add_diagram(table, name + ".bias.force", f.bias, "at 45 degrees");
  add(table, name + ".bending.warp", &f.bending_warp, tunable(scene::kBending),
      "bending rigidity per width, warp");
  add(table, name + ".bending.weft", &f.bending_weft, tunable(scene::kBending),
      "bending rigidity per width, weft");
  add(table, name + ".poisson", &f.poisson, tunable(scene::kPoisson),
      "nu: the rigidity in bending is divided by 1 - nu^2");
  add(table, name + ".compression", &f.compression, tunable(scene::kCompression),
      "slope of the thread's law in compression over its slope at zero");
  add(table, name + ".damping", &f.damping, tunable(scene::kSpringDamping),
      "tension of the springs per rate, over their stiffness");
  add(table, name + ".friction", &f.friction, tunable(scene::kFriction),
      "coefficient of static friction; the kinetic one keeps its ratio to it");
}

void add_seams(Table& table, drape_parameters& p) {
  for (int i = 0; i < p.seam_count; ++i)
    add(table, "seam." + name_part(p.seam[i].name) + ".close", &p.seam[i].close,
        typed(Type::kBoolean, idle(tunable(scene::kClose))),
        "1: the seam is pulled together from the next communication interval on");
}

void add_parameters(Table& table, drape_parameters& p) {
  for (int i = 0; i < p.fabric_count; ++i) add_fabric(table, p.fabric[i]);
  add(table, "damping", &p.damping, tunable(scene::kDamping), "c in the braking force -m c v");
  add_vector(table, "gravity", p.gravity, tunable(scene::kGravity), "acceleration of gravity");
  if (p.has_air) {
    add(table, "air.normal", &p.air_normal, tunable(scene::kAirCoefficient),
        "drag coefficient across the cloth");
    add(table, "air.tangential", &p.air_tangential, tunable(scene::kAirCoefficient),
        "drag coefficient along the cloth");
  }
  add_seams(table, p);
  add(table, "parameter_ramp", &p.ramp, idle(tunable(scene::kRamp)),
      "time over which a tuned value moves to its new one");
  add(table, "step.max", &p.step_max, fixed(scene::kStepMax), "longest time step");
  add(table, "threads", &p.threads, typed(Type::kInteger, idle(fixed(scene::kThreads))),
      "threads that share a step; they change no result");
  const Range own{p.mode, p.mode, false, false, true};
  add(table, "mode", &p.mode,
      {Causality::kParameter, Variability::kFixed, "1", own, 0, AtStart::kNothing, nullptr, Type::kMode},
      "1: the cloth moves, 2: only its equilibrium is computed; as the scene has it");
}

// What the inputs of a pin or a body mean.
struct MotionText {
  const char *position, *orientation, *velocity, *angular_velocity;
};

// Those that the drive names; what turns has orientations too.
void add_motion(Table& table, const std::string& name, drape_pin_input& in, drape_pin_input& rate,
                const MotionText& text) {
  if (in.drive & DRAPE_DRIVE_POSITION)
    add_input(table, name + ".position", {in.position, rate.position, "xyz"}, input(scene::kPinPosition),
              text.position);
  if (in.drive & DRAPE_DRIVE_POSITION && in.clamp)
    add_input(table, name + ".orientation", {in.orientation, rate.orientation, "wxyz"},
              input(scene::kPinOrientation), text.orientation);
  if (in.drive & DRAPE_DRIVE_VELOCITY)
    add_input(table, name + ".velocity", {in.velocity, rate.velocity, "xyz"}, input(scene::kPinVelocity),
              text.velocity);
  if (in.drive & DRAPE_DRIVE_VELOCITY && in.clamp)
    add_input(table, name + ".angular_velocity", {in.angular_velocity, rate.angular_velocity, "xyz"},
              shown_in("deg/s", input(scene::kPinAngularVelocity)), text.angular_velocity);
}

void add_inputs(Table& table, drape_inputs& u, drape_inputs& rates) {
  if (u.has_wind)
    add_input(table, "wind", {u.wind, rates.wind, "xyz"}, acting(input(scene::kWind)), "velocity of the air");
  for (int i = 0; i < u.pin_count; ++i)
    add_motion(table, "pin." + name_part(u.pin[i].name), u.pin[i], rates.pin[i],
               {"where the pin is to be at the end of the step",
                "rotation of the clamp since the start, a quaternion of any length above 0",
                "velocity that the pin is to have at the end of the step",
                "angular velocity that the clamp is to have at the end of the step"});
}

void add_bodies(Table& table, drape_inputs& u, drape_inputs& rates) {
  for (int i = 0; i < u.body_count; ++i)
    add_motion(table, "body." + name_part(u.body[i].name), u.body[i], rates.body[i],
               {"where the body's origin is to be at the end of the step",
                "rotation of the body from its mesh, a quaternion of any length above 0",
                "velocity that the body's origin is to have at the end of the step",
                "angular velocity that the body is to have at the end of the step"});
}

void add_contact(Table& table, const drape_outputs& o) {
  for (int i = 0; i < o.body_count; ++i) {
    const std::string name = "body." + name_part(o.body[i].name);
    add_vector(table, name + ".force", o.body[i].force, of_forces(output(DRAPE_OUT_VELOCITY, "N")),
               "mean force of the cloth on the body over the last communication step");
    add_vector(table, name + ".torque", o.body[i].torque, of_forces(output(DRAPE_OUT_VELOCITY, "N.m")),
               "mean torque of the cloth on the body likewise, about the body's origin");
  }
  if (o.body_count == 0 && !o.has_self_contact) return;
  add(table, "contact.count", &o.contact_count, typed(Type::kInteger, output_discrete(DRAPE_OUT_STRAIN, "1")),
      o.has_self_contact
          ? "particles that touch a body, links and cells on its sharp edges, and pairs of cloth that touch"
          : "particles that touch a body, and links and cells on its sharp edges");
  add(table, "contact.penetration.max", &o.contact_penetration, shown_in("mm", output(DRAPE_OUT_STRAIN, "m")),
      "the most that a particle is pressed into the thickness of its cloth");
  add(table, "contact.pressure.max", &o.contact_pressure, of_forces(output(DRAPE_OUT_STRAIN, "Pa")),
      o.has_self_contact ? "largest pressure of a body or of cloth on the cloth"
                         : "largest pressure of a body on the cloth");
}

void add_probes_pins_seams(Table& table, const drape_outputs& o) {
  for (int i = 0; i < o.probe_count; ++i) {
    const std::string name = "probe." + name_part(o.probe[i].name);
    add_vector(table, name + ".position", o.probe[i].position, output(DRAPE_OUT_POSITION, "m"),
               "where the probe is");
    derivatives_set(table, o.probe[i].velocity, DRAPE_OUT_VELOCITY);
    add_vector(table, name + ".velocity", o.probe[i].velocity, output(DRAPE_OUT_VELOCITY, "m/s"),
               "how fast the probe moves");
  }
  for (int i = 0; i < o.pin_count; ++i) {
    const std::string name = "pin." + name_part(o.pin[i].name);
    add_vector(table, name + ".force", o.pin[i].force, of_forces(output(DRAPE_OUT_VELOCITY, "N")),
               "mean force of the cloth on the pin over the last communication step");
    add_vector(table, name + ".torque", o.pin[i].torque, of_forces(output(DRAPE_OUT_VELOCITY, "N.m")),
               "mean torque of the cloth on the pin likewise, about the pin's position");
  }
  for (int i = 0; i < o.seam_count; ++i) {
    const std::string name = "seam." + name_part(o.seam[i].name);
    add(table, name + ".gap.max", &o.seam[i].gap_max, shown_in("mm", output(DRAPE_OUT_POSITION, "m")),
        "largest gap of the seam");
    add(table, name + ".closed", &o.seam[i].closed,
        typed(Type::kBoolean, output_discrete(DRAPE_OUT_POSITION, "1")),
        "1 where all of the seam is sewn, else 0");
    add(table, name + ".length", &o.seam[i].length, output(DRAPE_OUT_POSITION, "m"),
        "length of the seam, along the middle of its sides");
  }
}

void add_strains_and_step(Table& table, const drape_outputs& o) {
  add_strain(table, "strain.warp", o.strain_warp, "along the warp");
  add_strain(table, "strain.weft", o.strain_weft, "along the weft");
  add_strain(table, "strain.bias", o.strain_bias, "along the diagonals");
  add(table, "tension.max", &o.tension_max, of_parameters(output(DRAPE_OUT_STRAIN, "N/m")),
      "largest tension per width");
  add(table, "strain.beyond_test.count", &o.strain_beyond_test_count,
      typed(Type::kInteger, output_discrete(DRAPE_OUT_STRAIN, "1")),
      "links strained beyond the last point of their diagram");
  add(table, "step.size", &o.step_size, of_forces(output_discrete(DRAPE_OUT_STRAIN, "s")),
      "present time step");
  add(table, "step.count", &o.step_count, output_discrete(DRAPE_OUT_STRAIN, "1"),
      "time steps since the start");
  add(table, "step.stability", &o.step_stability, of_forces(output(DRAPE_OUT_STRAIN, "1")),
      "h omega_max over its limit, 2 for order 2: the motion is stable below 1");
  if (o.has_fit)
    add(table, "fit.residual", &o.fit_residual, output(DRAPE_OUT_STRAIN, "1"),
        "largest force left on a particle over the larger of total weight and total pin force");
}

void add_energies(Table& table, const drape_outputs& o) {
  if (!o.has_energy) return;
  const Row energy = of_parameters(output(DRAPE_OUT_ENERGY, "J"));
  add(table, "energy.kinetic", &o.energy.kinetic, energy, "energy of motion");
  add(table, "energy.stretch", &o.energy.stretch, energy, "energy of the threads in tension and compression");
  add(table, "energy.shear", &o.energy.shear, energy, "energy of the diagonals");
  add(table, "energy.bending", &o.energy.bending, energy, "energy of the hinges");
  add(table, "energy.gravity", &o.energy.gravity, energy, "potential energy of the weight");
  if (o.body_count > 0 || o.has_self_contact)
    add(table, "energy.contact", &o.energy.contact, energy,
        o.has_self_contact ? "energy of what is pressed on bodies and on cloth"
                           : "energy of what is pressed on bodies");
  if (!o.has_balance) return;
  add(table, "energy.dissipated", &o.energy.dissipated, energy,
      "energy that damping, air and friction have taken");
  add(table, "energy.input", &o.energy.input, energy,
      "work of pins, bodies, wind, seams and tuning on the cloth");
  add(table, "energy.balance_error", &o.energy.balance_error, energy,
      "growth of all energies since the start, minus input, plus dissipated");
}

void add_outputs(Table& table, const drape_outputs& o) {
  add_probes_pins_seams(table, o);
  add_contact(table, o);
  add_strains_and_step(table, o);
  add_energies(table, o);
}

// The particles that have variables of their own, by index: all, or those at fewer than four cells.
std::vector<int> nodes_selected(drape_cloth* cloth, Nodes nodes, int node_count) {
  std::vector<int> selected;
  if (nodes == Nodes::kAll) {
    selected.resize(std::size_t(node_count));
    std::iota(selected.begin(), selected.end(), 0);
  }
  if (nodes != Nodes::kOutline) return selected;
  std::vector<int> cells_at(std::size_t(node_count), 0);
  for (int p = 0; p < drape_piece_count(cloth); ++p) {
    const drape_piece piece = drape_piece_at(cloth, p);
    for (int k = 0; k < 4 * piece.cell_count; ++k) ++cells_at[std::size_t(piece.corner[k])];
  }
  for (int n = 0; n < node_count; ++n)
    if (cells_at[std::size_t(n)] < 4) selected.push_back(n);
  return selected;
}

// The vectors of all particles, and their derivatives or null.
struct NodeStorage {
  const double *value, *velocity = nullptr;
};

// name[n,1] to name[n,3] of each of these particles, along x, y and z.
void add_nodes(Table& table, const std::vector<int>& selected, const char* name, const NodeStorage& storage,
               const Row& row, const char* description) {
  for (const int n : selected) {
    for (int k = 0; k < 3; ++k) {
      add(table, name, storage.value + 3 * std::size_t(n) + k, row, description);
      table.back().index = bracketed(std::to_string(n + 1) + "," + std::to_string(k + 1));
      table.back().detail = "particle " + std::to_string(n + 1) + ", " + "xyz"[k];
    }
    if (storage.velocity)
      derivatives_set(table, storage.velocity + 3 * std::size_t(n), DRAPE_OUT_NODE_VELOCITY);
  }
}

}  // namespace

std::vector<Variable> variables_of(drape_cloth* cloth, Nodes nodes) {
  // The outputs belong to the cloth, which keeps them in one place: the table may point into them.
  const drape_outputs& outputs =
      *drape_get_outputs(cloth, nodes != Nodes::kNone ? DRAPE_OUT_ALL : DRAPE_OUT_SCALARS);
  Table table;
  add_parameters(table, *drape_parameters_of(cloth));
  add_inputs(table, *drape_inputs_of(cloth), *drape_input_rates_of(cloth));
  add_bodies(table, *drape_inputs_of(cloth), *drape_input_rates_of(cloth));
  add_outputs(table, outputs);
  const std::vector<int> selected = nodes_selected(cloth, nodes, outputs.node_count);
  add_nodes(table, selected, "node.position", {outputs.node_position, outputs.node_velocity},
            output(DRAPE_OUT_NODE_POSITION, "m"), "where a particle is");
  add_nodes(table, selected, "node.velocity", {outputs.node_velocity}, output(DRAPE_OUT_NODE_VELOCITY, "m/s"),
            "how fast a particle moves");
  return table;
}

}  // namespace drape::description
