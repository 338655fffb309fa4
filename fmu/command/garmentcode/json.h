// Values of a JSON file. Each fault is reported with its path.
#pragma once
#include <istream>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "scene/scene.h"

namespace drape::command {

using Json = nlohmann::ordered_json;  // members in the order of the file

struct JsonFaults {
  std::string file;
  std::vector<Problem>& problems;
};

// Reads a text. False: it is no JSON, or nested too deeply; `problem` says so.
bool json_parse(std::istream& stream, Json& value, std::string& problem);

// A value as a text in one line, shortened.
std::string json_text(const Json& value);

// "dress.json: pattern.panels.front.edges[3] <message>"
void json_fault(const JsonFaults& faults, const std::string& path, const std::string& message);

// A value; or a fault and null where it is missing or of another kind.
const Json* json_member(const JsonFaults& faults, const Json& object, const std::string& path,
                        const std::string& name, Json::value_t kind);
std::optional<double> json_number(const JsonFaults& faults, const Json& value, const std::string& path,
                                  double low, double high);
std::optional<std::vector<double>> json_numbers(const JsonFaults& faults, const Json& value,
                                                const std::string& path, std::size_t count, double size);
std::optional<int> json_index(const JsonFaults& faults, const Json& value, const std::string& path,
                              std::size_t count);

const char* json_kind(Json::value_t kind);

}  // namespace drape::command
