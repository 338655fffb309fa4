#include <cmath>

#include "decimal.h"
#include "instance/instance.h"

namespace drape::instance {
namespace {

const char* name_of(As as) { return as == As::kReal ? "Real" : as == As::kInteger ? "Integer" : "Boolean"; }

bool is_of(const description::Variable& v, As as) {
  using description::Type;
  if (as == As::kReal) return true;
  return as == As::kBoolean ? v.type == Type::kBoolean : v.type == Type::kInteger || v.type == Type::kMode;
}

const description::Variable* row_of(const Instance& instance, As as, std::uint32_t reference) {
  if (reference < 1 || reference > instance.table.size()) return nullptr;
  const description::Variable& v = instance.table[reference - 1];
  return is_of(v, as) ? &v : nullptr;
}

std::string no_row(const Instance& instance, As as, std::uint32_t reference) {
  const std::string sentence =
      "value reference " + std::to_string(reference) + " names no " + name_of(as) + " variable; allowed: ";
  if (as == As::kReal) return sentence + "1 to " + std::to_string(instance.table.size());
  std::string names;
  for (const description::Variable& v : instance.table)
    if (is_of(v, as)) names += (names.empty() ? "" : ", ") + v.name();
  return sentence + (names.empty() ? "none, as this scene has none" : names.substr(0, 300));
}

// Why a variable may not be set to a value now; empty if it may.
std::string set_problem(const Instance& instance, As as, std::uint32_t reference, double value) {
  const description::Variable* v = row_of(instance, as, reference);
  if (!v) return no_row(instance, as, reference);
  if (v->causality == description::Causality::kOutput)
    return v->name() + " is an output; allowed: setting parameters and inputs";
  const bool initialized = instance.phase != Phase::kInstantiated && instance.phase != Phase::kInitialization;
  if (v->variability == description::Variability::kFixed && initialized)
    return v->name() + " is fixed; allowed: setting it until initialization ends";
  return description::range_problem(*v, value);
}

// The same for the derivative of an input.
std::string rate_problem(const Instance& instance, std::uint32_t reference, int order, double value) {
  const description::Variable* v = row_of(instance, As::kReal, reference);
  if (!v) return no_row(instance, As::kReal, reference);
  if (!v->rate) return v->name() + " is no input; allowed: setting derivatives of inputs";
  if (order != 1)
    return "the order of the derivative of " + v->name() + " is " + std::to_string(order) + "; allowed: 1";
  if (std::isfinite(value)) return "";
  const std::string unit = v->unit == std::string_view("1") ? "1/s" : std::string(v->unit) + "/s";
  return "the derivative of " + v->name() + " is " + description::decimal_text(value) + " " + unit +
         "; allowed: any finite number";
}

}  // namespace

drape_status instance_get(Instance& instance, As as, const std::uint32_t* references, std::size_t count,
                          double* values) {
  int needs = 0;
  for (std::size_t i = 0; i < count; ++i) {
    const description::Variable* v = row_of(instance, as, references[i]);
    if (!v) return instance_refuse(instance, DRAPE_DISCARD, no_row(instance, as, references[i]));
    needs |= v->needs;
  }
  instance_read_outputs(instance, needs);
  for (std::size_t i = 0; i < count; ++i) values[i] = *instance.table[references[i] - 1].value;
  return DRAPE_OK;
}

drape_status instance_set(Instance& instance, As as, const std::uint32_t* references, std::size_t count,
                          const double* values) {
  drape_status status = DRAPE_OK;
  for (std::size_t i = 0; i < count; ++i)
    if (const std::string problem = set_problem(instance, as, references[i], values[i]); !problem.empty())
      status = instance_refuse(instance, DRAPE_DISCARD, problem);
  if (status != DRAPE_OK) return status;
  for (std::size_t i = 0; i < count; ++i) *instance.table[references[i] - 1].setting = values[i];
  if (instance.phase == Phase::kInstantiated || instance.phase == Phase::kInitialization) {
    drape_inputs_start(instance.cloth);
    instance.read = 0;
  }
  return DRAPE_OK;
}

drape_status instance_set_rates(Instance& instance, const std::uint32_t* references, std::size_t count,
                                const int* orders, const double* values) {
  drape_status status = DRAPE_OK;
  for (std::size_t i = 0; i < count; ++i)
    if (const std::string problem = rate_problem(instance, references[i], orders[i], values[i]);
        !problem.empty())
      status = instance_refuse(instance, DRAPE_DISCARD, problem);
  if (status != DRAPE_OK) return status;
  for (std::size_t i = 0; i < count; ++i) *instance.table[references[i] - 1].rate = values[i];
  return DRAPE_OK;
}

}  // namespace drape::instance
