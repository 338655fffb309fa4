// The fields of State and of its parts: the one list that saving, reading and checking of states follow. A
// new field of State is one line here.
#pragma once
#include "model/system.h"
#include "state/field.h"

namespace drape::state {

template <>
struct Table<math::RigidMotion> {
  static auto of(auto& s) {
    return std::tuple{
        Field{"position", s.position},         Field{"orientation", s.orientation},
        Field{"velocity", s.velocity},         Field{"angular_velocity", s.angular_velocity},
        Field{"acceleration", s.acceleration}, Field{"angular_acceleration", s.angular_acceleration}};
  }
};
static_assert(kListsAll<math::RigidMotion>);

template <>
struct Table<math::Wrench> {
  static auto of(auto& s) { return std::tuple{Field{"force", s.force}, Field{"torque", s.torque}}; }
};
static_assert(kListsAll<math::Wrench>);

template <>
struct Table<model::ContactBlock> {
  static auto of(auto& s) {
    return std::tuple{Field{"side", s.side},
                      Field{"offset", s.offset},
                      Field{"point", s.point},
                      Field{"shape", s.shape},
                      Field{"sink", s.sink},
                      Field{"sticking", s.sticking},
                      Field{"warm_start", s.warm_start},
                      Field{"shared", s.shared},
                      Field{"flat", s.flat},
                      Field{"shares", s.shares},
                      Field{"has_warm_start", s.has_warm_start},
                      Field{"node", s.node, Length::kAny, index_of(Length::kNodes)},
                      Field{"lattice", s.lattice, Length::kAny, index_of(Length::kLattices)}};
  }
};
static_assert(kListsAll<model::ContactBlock>);

template <>
struct Table<model::ContactPlace> {
  static auto of(auto& s) {
    return std::tuple{Field{"node", s.node, Length::kAny, index_of(Length::kGroups)},
                      Field{"block", s.block}};
  }
};
static_assert(kListsAll<model::ContactPlace>);

template <>
struct Table<model::ContactBlocks> {
  static auto of(auto& s) {
    return std::tuple{Field{"pool", s.pool}, Field{"free", s.free}, Field{"order", s.order}};
  }
};
static_assert(kListsAll<model::ContactBlocks>);

template <>
struct Table<model::EdgePair> {
  static auto of(auto& s) {
    return std::tuple{Field{"element", s.element, Length::kAny, index_of(Length::kEdgeElements)},
                      Field{"feature", s.feature},
                      Field{"outside", s.outside},
                      Field{"sticking", s.sticking},
                      Field{"share", s.share},
                      Field{"stored", s.stored},
                      Field{"warm_start", s.warm_start}};
  }
};
static_assert(kListsAll<model::EdgePair>);

template <>
struct Table<model::EdgeContact> {
  static auto of(auto& s) {
    return std::tuple{Field{"near", s.near, Length::kNodesOrNone, kShare},
                      Field{"fresh", s.fresh, Length::kAny, index_of(Length::kNodes)},
                      Field{"node", s.node, Length::kAny, index_of(Length::kNodes)},
                      Field{"last", s.last},
                      Field{"from", s.from},
                      Field{"pair", s.pair},
                      Field{"active_after_travel", s.active_after_travel, Length::kAny, kMayBeInfinite},
                      Field{"travel", s.travel},
                      Field{"reach", s.reach}};
  }
};
static_assert(kListsAll<model::EdgeContact>);

template <>
struct Table<model::BodyContact> {
  static auto of(auto& s) {
    return std::tuple{Field{"motion", s.motion},
                      Field{"rotation", s.rotation},
                      Field{"velocity_given", s.velocity_given},
                      Field{"impulse", s.impulse},
                      Field{"x", s.x, Length::kNodes},
                      Field{"y", s.y, Length::kNodes},
                      Field{"z", s.z, Length::kNodes},
                      Field{"free_distance2", s.free_distance2, Length::kNodes, kMayBeInfinite},
                      Field{"group_clearance", s.group_clearance, Length::kGroups, kMayBeInfinite},
                      Field{"blocks", s.blocks},
                      Field{"edges", s.edges}};
  }
};
static_assert(kListsAll<model::BodyContact>);

template <>
struct Table<model::SelfPoint> {
  static auto of(auto& s) {
    return std::tuple{Field{"node", s.node, Length::kAny, index_of(Length::kNodes)},
                      Field{"contact_distance", s.contact_distance}, Field{"start", s.start}};
  }
};
static_assert(kListsAll<model::SelfPoint>);

template <>
struct Table<model::SelfCross> {
  static auto of(auto& s) {
    return std::tuple{Field{"node", s.node, Length::kAny, index_of(Length::kNodes)},
                      Field{"edge", s.edge, Length::kAny, index_of(Length::kSelfEdges)},
                      Field{"contact_distance", s.contact_distance}, Field{"start", s.start}};
  }
};
static_assert(kListsAll<model::SelfCross>);

template <>
struct Table<model::SelfPairs> {
  static auto of(auto& s) { return std::tuple{Field{"point", s.point}, Field{"cross", s.cross}}; }
};
static_assert(kListsAll<model::SelfPairs>);

template <>
struct Table<model::SelfHold> {
  static auto of(auto& s) {
    return std::tuple{Field{"node", s.node, Length::kAny, index_of(Length::kNodes)}, Field{"cross", s.cross},
                      Field{"sticks", s.sticks}, Field{"force", s.force}};
  }
};
static_assert(kListsAll<model::SelfHold>);

template <>
struct Table<model::SelfState> {
  static auto of(auto& s) {
    return std::tuple{
        Field{"age", s.age},
        Field{"travel", s.travel},
        Field{"speed", s.speed},
        Field{"shape_travel", s.shape_travel},
        Field{"searched", s.searched},
        Field{"margin", s.margin},
        Field{"pairs", s.pairs},
        Field{"active_after_travel", s.active_after_travel, Length::kAny, kMayBeInfinite},
        Field{"block_active_after_travel", s.block_active_after_travel, Length::kAny, kMayBeInfinite},
        Field{"level_until", s.level_until, Length::kSelfEdges, kMayBeInfinite},
        Field{"hold", s.hold}};
  }
};
static_assert(kListsAll<model::SelfState>);

inline constexpr Allowed kFewSteps = from_to(-1e6, 1e6), kCounted = from_to(0, 9e15);

template <>
struct Table<model::RelaxationState> {
  static auto of(auto& s) {
    return std::tuple{
        Field{"damping", s.damping, Length::kAny, kNotNegative},
        Field{"intervals_to_convergence_check", s.intervals_to_convergence_check, Length::kAny, kFewSteps},
        Field{"residual", s.residual, Length::kAny, kMayBeInfinite},
        Field{"load", s.load},
        Field{"max_force", s.max_force},
        Field{"at_rest", s.at_rest},
        Field{"sewing", s.sewing},
        Field{"settling", s.settling},
        Field{"measured", s.measured, Length::kAny, kCounted},
        Field{"measure_every", s.measure_every, Length::kAny, kFewSteps},
        Field{"place", s.place, Length::kNodesOrNone},
        Field{"force", s.force, Length::kNodesOrNone}};
  }
};
static_assert(kListsAll<model::RelaxationState>);

template <>
struct Table<model::EnergyGuard> {
  static auto of(auto& s) {
    return std::tuple{Field{"begun", s.begun},
                      Field{"h", s.h, Length::kAny, kNotNegative},
                      Field{"balance", s.balance},
                      Field{"gravity", s.gravity},
                      Field{"largest", s.largest, Length::kAny, kNotNegative},
                      Field{"unaccounted", s.unaccounted},
                      Field{"step_energy", s.step_energy},
                      Field{"ripple", s.ripple},
                      Field{"worst", s.worst},
                      Field{"worst_size", s.worst_size, Length::kAny, kNotNegative},
                      Field{"worst_time", s.worst_time},
                      Field{"damped", s.damped},
                      Field{"power", s.power},
                      Field{"variance", s.variance, Length::kAny, kNotNegative},
                      Field{"since", s.since, Length::kAny, kNotNegative},
                      Field{"opened", s.opened, Length::kAny, kCounted},
                      Field{"checked", s.checked, Length::kAny, kCounted},
                      Field{"period", s.period, Length::kAny, from_to(1, 1e6)},
                      Field{"refinement", s.refinement, Length::kAny, from_to(1, 1e6)},
                      Field{"refinements", s.refinements, Length::kAny, from_to(0, 1e6)},
                      Field{"refined", s.refined, Length::kAny, kCounted},
                      Field{"missing_refined", s.missing_refined},
                      Field{"ripple_refined", s.ripple_refined},
                      Field{"size_refined", s.size_refined},
                      Field{"ripple_largest", s.ripple_largest, Length::kAny, kNotNegative},
                      Field{"failing", s.failing}};
  }
};
static_assert(kListsAll<model::EnergyGuard>);

template <>
struct Table<model::State> {
  static auto of(auto& s) {
    return std::tuple{Field{"x", s.x, Length::kNodes},
                      Field{"y", s.y, Length::kNodes},
                      Field{"z", s.z, Length::kNodes},
                      Field{"vx", s.vx, Length::kNodes},
                      Field{"vy", s.vy, Length::kNodes},
                      Field{"vz", s.vz, Length::kNodes},
                      Field{"wx", s.wx, Length::kNodesOrNone},
                      Field{"wy", s.wy, Length::kNodesOrNone},
                      Field{"wz", s.wz, Length::kNodesOrNone},
                      Field{"h_older", s.h_older, Length::kAny, kNotNegative},
                      Field{"sewn", s.sewn, Length::kPairs, from_to(0, double(model::Sewn::kWelded))},
                      Field{"gap_rate", s.gap_rate, Length::kPairNumbers},
                      Field{"closing_integral", s.closing_integral, Length::kPairs},
                      Field{"closing_time", s.closing_time, Length::kPairs},
                      Field{"body", s.body, Length::kBodies},
                      Field{"self", s.self},
                      Field{"inverse_mass_scale", s.inverse_mass_scale, Length::kNodesOrNone, kShare},
                      Field{"relaxation", s.relaxation},
                      Field{"wind", s.wind},
                      Field{"pin_rotation", s.pin_rotation, Length::kPins},
                      Field{"pin_motion", s.pin_motion, Length::kPins},
                      Field{"dissipated", s.dissipated},
                      Field{"input", s.input},
                      Field{"drive_work", s.drive_work},
                      Field{"energy_start", s.energy_start},
                      Field{"origin", s.origin},
                      Field{"tick", s.tick, Length::kAny, kCounted},
                      Field{"steps", s.steps, Length::kAny, kCounted},
                      Field{"steps_per_interval", s.steps_per_interval, Length::kAny, from_to(1, 1e16)},
                      Field{"intervals_since_change", s.intervals_since_change, Length::kAny, kCounted},
                      Field{"h_old", s.h_old, Length::kAny, kNotNegative},
                      Field{"steps_to_limit_check", s.steps_to_limit_check, Length::kAny, kFewSteps},
                      Field{"limit_check_period", s.limit_check_period, Length::kAny, from_to(1, 1e6)},
                      Field{"omega2", s.omega2, Length::kAny, kMayBeInfinite},
                      Field{"mean_defect", s.mean_defect, Length::kAny, kMayBeInfinite},
                      Field{"mean_kinetic", s.mean_kinetic, Length::kAny, kMayBeInfinite},
                      Field{"flutter", s.flutter, Length::kAny, kMayBeInfinite},
                      Field{"max_contact_step", s.max_contact_step, Length::kAny, kMayBeInfinite},
                      Field{"max_omega2", s.max_omega2, Length::kAny, kMayBeInfinite},
                      Field{"max_drift", s.max_drift, Length::kAny, kMayBeInfinite},
                      Field{"max_flutter", s.max_flutter, Length::kAny, kMayBeInfinite},
                      Field{"guard", s.guard},
                      Field{"advance_length", s.advance_length, Length::kAny, kNotNegative},
                      Field{"advance_begins", s.advance_begins},
                      Field{"pin_impulse", s.pin_impulse, Length::kPins}};
  }
};
static_assert(kListsAll<model::State>, "a field of State is missing in this table");

}  // namespace drape::state
