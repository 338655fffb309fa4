#include "command/garmentcode/json.h"

#include <cmath>
#include <stdexcept>

#include "scene/diagnostics.h"

namespace drape::command {

bool json_parse(std::istream& stream, Json& value, std::string& problem) {
  constexpr int kMaxDepth = 256;  // the library writes and copies a value with one call for every level
  const auto depth_check = [](int depth, Json::parse_event_t event, const Json&) {
    const bool opens =
        event == Json::parse_event_t::object_start || event == Json::parse_event_t::array_start;
    if (opens && depth >= kMaxDepth)
      throw std::length_error("is nested in more than 256 levels; allowed: up to 256");
    return true;
  };
  try {
    value = Json::parse(stream, depth_check);
  } catch (const Json::exception& e) {
    problem = std::string("is not valid JSON: ") + e.what();
    return false;
  } catch (const std::length_error& e) {
    problem = e.what();
    return false;
  }
  return true;
}

std::string json_text(const Json& value) { return scene::shortened(value.dump()); }

void json_fault(const JsonFaults& faults, const std::string& path, const std::string& message) {
  faults.problems.push_back({faults.file + (path.empty() ? ":" : ": " + path), message});
}

const char* json_kind(Json::value_t kind) {
  switch (kind) {
    case Json::value_t::object:
      return "an object {...}";
    case Json::value_t::array:
      return "a list [...]";
    case Json::value_t::string:
      return "a text";
    case Json::value_t::boolean:
      return "true or false";
    case Json::value_t::null:
      return "null";
    default:
      return "a number";
  }
}

const Json* json_member(const JsonFaults& faults, const Json& object, const std::string& path,
                        const std::string& name, Json::value_t kind) {
  const std::string at = path.empty() ? name : path + "." + name;
  const auto found = object.find(name);
  if (found == object.end())
    return json_fault(faults, at, std::string("is missing; wanted: ") + json_kind(kind)), nullptr;
  if (found->type() == kind) return &*found;
  json_fault(faults, at, std::string("is ") + json_kind(found->type()) + "; wanted: " + json_kind(kind));
  return nullptr;
}

std::optional<double> json_number(const JsonFaults& faults, const Json& value, const std::string& path,
                                  double low, double high) {
  if (!value.is_number()) {
    json_fault(faults, path, std::string("is ") + json_kind(value.type()) + "; wanted: a number");
    return {};
  }
  const double number = value.get<double>();
  if (number >= low && number <= high) return number;
  json_fault(faults, path,
             "= " + scene::number_text(number) + "; allowed: from " + scene::number_text(low) + " to " +
                 scene::number_text(high));
  return {};
}

std::optional<std::vector<double>> json_numbers(const JsonFaults& faults, const Json& value,
                                                const std::string& path, std::size_t count, double size) {
  if (!value.is_array() || value.size() != count) {
    json_fault(faults, path,
               value.is_array()
                   ? "has " + scene::entries_text(value.size()) + "; wanted: " + std::to_string(count)
                   : std::string("is ") + json_kind(value.type()) + "; wanted: a list of " +
                         std::to_string(count) + " numbers");
    return {};
  }
  std::vector<double> numbers;
  for (std::size_t k = 0; k < count; ++k)
    if (const auto number = json_number(faults, value[k], path + "[" + std::to_string(k) + "]", -size, size))
      numbers.push_back(*number);
  if (numbers.size() < count) return {};
  return numbers;
}

std::optional<int> json_index(const JsonFaults& faults, const Json& value, const std::string& path,
                              std::size_t count) {
  if (!value.is_number_integer()) {
    json_fault(faults, path, std::string("is ") + json_kind(value.type()) + "; wanted: a whole number");
    return {};
  }
  const double index = value.get<double>();
  if (index >= 0 && index < double(count)) return int(index);
  json_fault(
      faults, path,
      "= " + scene::number_text(index) +
          (count ? "; allowed: 0 to " + std::to_string(count - 1) : "; allowed: none, there are none"));
  return {};
}

}  // namespace drape::command
