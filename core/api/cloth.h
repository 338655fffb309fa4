// What stands behind the C interface: a cloth is a scene, the system made from it, its state, and the structs
// it shows.
#pragma once
#include "api/ramp.h"
#include "drape/drape.h"
#include "dynamics/advance.h"
#include "outputs/fields.h"
#include "outputs/outputs.h"

namespace drape::api {

// The tuned values: those in the system, and where they go.
struct Tuning {
  ParameterValues in_force;
  Ramp ramp;
};

}  // namespace drape::api

struct drape_cloth {
  drape_log_fn* log = nullptr;
  void* log_user = nullptr;
  drape::Scene scene;
  std::string text;
  std::vector<std::string> files;  // [bodies] their names beside the text
  drape::System system;
  drape::dynamics::Motion motion;
  drape::State state, good;  // now, and when the running advance began
  drape::api::Parameters parameters;
  drape_inputs inputs{}, input_rates{};
  std::vector<drape_pin_input> pin_inputs, pin_rates;    // [driven pins]
  std::vector<std::size_t> driven;                       // theirs among Scene::pins
  std::vector<drape_pin_input> body_inputs, body_rates;  // [moving bodies]
  std::vector<std::size_t> moving;                       // theirs among Scene::bodies
  drape::api::Tuning tuning, tuning_good;                // as state, good
  drape::outputs::Outputs outputs;
  struct Piece {
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
  std::vector<Piece> pieces;      // empty until one is asked for
  drape::outputs::Fields fields;  // of the last time they were asked for, as are these
  drape_fields fields_view{};
  std::vector<double> seam_line[2], surface_point;
  std::string limit_link;
  bool step_above_limit = false;  // the last advance met a step limit below the given step
};

namespace drape::api {

void log_message(const drape_cloth& cloth, drape_log_kind kind, const std::string& message);
void log_problems(const drape_cloth& cloth, const std::vector<Problem>& problems);
std::string number(double value, int digits = 6);

// What keeps the cloth from stepping on from its present state: no step limit, a given step above it, or more
// than kSubsMost steps in an interval.
void step_check(const drape_cloth& cloth, std::vector<Problem>& problems);

// What drape_piece_at shows.
void pieces_describe(drape_cloth& cloth);

// Room for inputs, with what they are at the start.
void inputs_make(drape_cloth& cloth);

// An orientation of length 0 goes back to what it is now, with a problem.
void inputs_validate(drape_cloth& cloth, std::vector<Problem>& problems);

// Checks the inputs and makes them the end of the next advance, of `length`. On a problem (true without) the
// values at fault are again what they are now.
bool inputs_apply(drape_cloth& cloth, double length, std::vector<Problem>& problems);

// After an advance the rates are 0 again.
void inputs_clear_rates(drape_cloth& cloth);

// The values of the parameters are those of the system.
void tuning_begin(drape_cloth& cloth);

// Moves ramps on by a number of communication intervals; true where that moves the cloth otherwise.
bool tuning_advance(drape_cloth& cloth, double intervals);

// The error of the energy balance; 0 where none is kept. What a change of the system adds to it is the work
// of the change.
double balance_error(drape_cloth& cloth);

// What seams do at the beginning of an interval; true where that moves the cloth otherwise.
bool seam_events_advance(drape_cloth& cloth);

// Takes up an earlier state of the tuning.
void tuning_restore(drape_cloth& cloth, const Tuning& tuning);

}  // namespace drape::api
