// A copy of all of a cloth that changes, and the tables of its fields beside those of State.
#pragma once
#include "api/cloth.h"
#include "state/fields.h"

struct drape_snapshot {
  drape::State state;
  drape::api::Tuning tuning;
  drape::api::ParameterValues parameters;  // values written, including those not yet committed
  struct Inputs {
    double wind[3];
    std::vector<drape_pin_input> pin, body;
  } inputs, input_rates;
  std::vector<unsigned char> attached;  // a caller's own bytes
};

namespace drape::state {

template <>
struct Table<api::ParameterValues> {
  static auto of(auto& s) { return std::tuple{Field{"value", s.value, Length::kParameters}}; }
};
static_assert(kListsAll<api::ParameterValues>);

template <>
struct Table<api::Ramp> {
  static auto of(auto& s) {
    return std::tuple{Field{"from", s.from}, Field{"to", s.to},
                      Field{"elapsed", s.elapsed, Length::kParameters, kNotNegative},
                      Field{"span", s.span, Length::kParameters, kNotNegative}};
  }
};
static_assert(kListsAll<api::Ramp>);

template <>
struct Table<api::Tuning> {
  static auto of(auto& s) { return std::tuple{Field{"in_force", s.in_force}, Field{"ramp", s.ramp}}; }
};
static_assert(kListsAll<api::Tuning>);

// Without name, drive and clamp, which the scene gives: a reader leaves them as they are. An input may hold a
// number that the next advance will refuse, but none that is not finite gets that far.
template <>
struct Table<drape_pin_input> {
  static auto of(auto& s) {
    return std::tuple{Field{"position", s.position, Length::kAny, kMayBeInfinite},
                      Field{"orientation", s.orientation, Length::kAny, kMayBeInfinite},
                      Field{"velocity", s.velocity, Length::kAny, kMayBeInfinite},
                      Field{"angular_velocity", s.angular_velocity, Length::kAny, kMayBeInfinite}};
  }
};

template <>
struct Table<drape_snapshot::Inputs> {
  static auto of(auto& s) {
    return std::tuple{Field{"wind", s.wind, Length::kAny, kMayBeInfinite},
                      Field{"pin", s.pin, Length::kDrivenPins}, Field{"body", s.body, Length::kMovingBodies}};
  }
};
static_assert(kListsAll<drape_snapshot::Inputs>);

template <>
struct Table<drape_snapshot> {
  static auto of(auto& s) {
    return std::tuple{
        Field{"state", s.state},   Field{"tuning", s.tuning},           Field{"parameters", s.parameters},
        Field{"inputs", s.inputs}, Field{"input_rates", s.input_rates}, Field{"attached", s.attached}};
  }
};
static_assert(kListsAll<drape_snapshot>);

}  // namespace drape::state
