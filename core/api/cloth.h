// The object behind the C interface: a scene, the system made from it, its state, and the structs that users
// see.
#pragma once
#include "api/ramp.h"
#include "drape/drape.h"
#include "dynamics/advance.h"
#include "outputs/fields.h"
#include "outputs/outputs.h"

namespace drape::api {

// The tuned values: those in force in the system, and the ramp to their targets.
struct Tuning {
  ParameterValues in_force;
  Ramp ramp;
};

// What has been reported of a driven pin or a moving body.
struct ToldContradiction {
  bool position = false, orientation = false;
  bool zero = false;  // an orientation of length 0; until another is given
};

}  // namespace drape::api

struct drape_cloth {
  drape_log_fn* log = nullptr;
  void* log_user = nullptr;
  drape_interval_fn* on_interval = nullptr;
  void* on_interval_user = nullptr;
  drape::Scene scene;
  std::string text;
  std::vector<std::string> files;  // [bodies] names of the mesh files next to the text
  std::uint64_t scene_hash = 0;    // of the text and the meshes; 0 until the first state is written or read
  drape::System system;
  drape::dynamics::Motion motion;
  drape::State state, good;  // at present, and when the present advance began
  drape::api::Parameters parameters;
  drape_inputs inputs{}, input_rates{};
  std::vector<drape_pin_input> pin_inputs, pin_rates;    // [driven pins]
  std::vector<std::size_t> driven;                       // [driven pins] their indices in Scene::pins
  std::vector<drape_pin_input> body_inputs, body_rates;  // [moving bodies]
  std::vector<std::size_t> moving;                       // [moving bodies] their indices in Scene::bodies
  std::vector<drape::api::ToldContradiction> pin_told, body_told;  // [driven pins], [moving bodies]
  drape::api::Tuning tuning, tuning_good;                          // as for state, good
  drape::outputs::Outputs outputs;
  struct Piece {  // the arrays of drape_piece
    int first = 0;
    std::vector<double> rest;  // [particles x 2]
    std::vector<int> corner;   // [cells x 4]
    int point_first = 0;
    std::vector<int> point_node;       // [points x 4]
    std::vector<double> point_weight;  // [points x 4]
    std::vector<int> polygon_end, polygon_corner;
    int cut = 0, merged = 0, twins = 0;
    double area = 0;
  };
  std::vector<Piece> pieces;  // empty until the first drape_piece_at
  // Results of the last call of the functions that return them.
  drape::outputs::Fields fields;
  drape_fields fields_view{};
  std::vector<double> seam_line[2], surface_point;
  std::string limit_link;
  bool step_above_limit = false;  // the step limit fell below the scene's step in the last advance
  bool surprised = false;         // the last commit or advance took a value that may surprise
};

namespace drape::api {

void log_message(const drape_cloth& cloth, drape_log_kind kind, const std::string& message);
void log_problems(const drape_cloth& cloth, const std::vector<Problem>& problems);
std::string number(double value, int digits = 6);

// Checks that the cloth can step on from its present state. Problems: there is no step limit, the scene's
// step is above it, or an interval takes more than kMaxStepsPerInterval steps.
void step_check(const drape_cloth& cloth, std::vector<Problem>& problems);

// What sets the automatic step, in words: a link, or a node that moves fast near a body. `ahead` as in
// step_limit_link.
std::string step_setter(const drape_cloth& cloth, double ahead);

// Fills the pieces for drape_piece_at.
void pieces_describe(drape_cloth& cloth);

// Allocates the inputs and sets them to their values at the start.
void inputs_make(drape_cloth& cloth);

// An orientation of length 0 is reset to the present one, with a warning.
void inputs_validate(drape_cloth& cloth);

// Checks the inputs and makes them the end of the next advance, whose length is `length`, s. False on a
// problem: invalid values are reset to the present ones.
bool inputs_apply(drape_cloth& cloth, double length, std::vector<Problem>& problems);

// Sets all rates to 0, after an advance.
void inputs_clear_rates(drape_cloth& cloth);

// Starts the tuning: the values in force are those of the parameters, and all targets are reached.
void tuning_begin(drape_cloth& cloth);

// Advances the ramps by a number of communication intervals. True where that changes the motion.
bool tuning_advance(drape_cloth& cloth, double intervals);

// The error of the energy balance, J; 0 where the balance is not computed. What a change of the system adds
// to it is the work of the change.
double balance_error(drape_cloth& cloth);

// Starts the closing of seams and welds pairs, at the beginning of an interval. True where that changes the
// motion.
bool seam_events_advance(drape_cloth& cloth);

// Restores an earlier state of the tuning.
void tuning_restore(drape_cloth& cloth, const Tuning& tuning);

}  // namespace drape::api
