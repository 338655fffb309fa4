// Time derivatives of outputs. Those of positions are exact; others are slopes between communication points.
#include "decimal.h"
#include "instance/instance.h"

namespace drape::instance {
namespace {

std::string derivative_problem(const Instance& instance, std::uint32_t reference, int order) {
  const bool known = reference >= 1 && reference <= instance.table.size();
  const description::Variable* v = known ? &instance.table[reference - 1] : nullptr;
  if (!v || v->causality != description::Causality::kOutput || v->type != description::Type::kReal)
    return (v ? v->name() : "value reference " + std::to_string(reference)) +
           " is no Real output; allowed: derivatives of Real outputs";
  if (order != 1)
    return "the order of the derivative of " + v->name() + " is " + std::to_string(order) + "; allowed: 1";
  if (v->needs & DRAPE_OUT_NODE_VELOCITY)
    return "the derivative of " + v->name() + " is not computed; allowed: node.position, and outputs of " +
           "probes, pins, bodies and the whole cloth";
  return "";
}

// The groups that a derivative reads at the present point.
int needs_of(const description::Variable& v) {
  if (v.derivative) return v.derivative_needs;
  return v.variability == description::Variability::kContinuous ? v.needs : 0;
}

double slope_of(const Instance& instance, std::size_t row) {
  const description::Variable& v = instance.table[row];
  const History& before = instance.history;
  if (!(before.length > 0) || (v.needs & ~before.read)) return 0;
  for (std::size_t k = 0; k < before.value.size(); ++k)
    if (instance.recorded[k] == row) return (*v.value - before.value[k]) / before.length;
  return 0;
}

}  // namespace

History history_take(Instance& instance) {
  History now;
  now.read = (instance.read | instance.read_before_saving | instance.derivatives_asked) & DRAPE_OUT_SCALARS;
  instance.read_before_saving = 0;
  if (now.read == 0) return now;
  instance_read_outputs(instance, now.read);
  for (const std::size_t row : instance.recorded)
    now.value.push_back(instance.table[row].needs & ~now.read ? 0 : *instance.table[row].value);
  return now;
}

drape_status instance_get_derivatives(Instance& instance, const std::uint32_t* references, std::size_t count,
                                      const int* orders, double* values) {
  int needs = 0;
  for (std::size_t i = 0; i < count; ++i) {
    if (const std::string problem = derivative_problem(instance, references[i], orders[i]); !problem.empty())
      return instance_refuse(instance, DRAPE_DISCARD, problem);
    needs |= needs_of(instance.table[references[i] - 1]);
  }
  instance_read_outputs(instance, needs);
  for (std::size_t i = 0; i < count; ++i) {
    const description::Variable& v = instance.table[references[i] - 1];
    if (!v.derivative) instance.derivatives_asked |= needs_of(v);
    values[i] = v.derivative ? *v.derivative : slope_of(instance, references[i] - 1);
  }
  return DRAPE_OK;
}

}  // namespace drape::instance
