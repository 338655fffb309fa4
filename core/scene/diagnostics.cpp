#include "scene/diagnostics.h"

#include <algorithm>
#include <charconv>
#include <cstdio>
#include <tuple>

namespace drape::scene {

namespace {

// A message is one line, so control characters of a quoted text become spaces.
std::string one_line(std::string text) {
  for (char& c : text)
    if (static_cast<unsigned char>(c) < ' ') c = ' ';
  return text;
}

Location location_find(const Faults& faults, std::string path) {
  while (!path.empty()) {
    if (const auto it = faults.locations.find(path); it != faults.locations.end()) return it->second;
    const std::size_t end = path.find_last_of(".[");
    path.resize(end == std::string::npos ? 0 : end);
  }
  return {faults.file, 0};
}

}  // namespace

std::string fault_place(const Faults& faults, const std::string& path) {
  const Location at = location_find(faults, path);
  std::string place = at.file;
  if (at.line) place += ":" + std::to_string(at.line);
  return place + (path.empty() ? ":" : ": " + path);
}

void fault_add(Faults& faults, const std::string& path, const std::string& message) {
  fault_add_at(faults, location_find(faults, path), fault_place(faults, path), message);
  faults.found.back().path = path;
}

bool fault_within(const Faults& faults, const std::string& path) {
  return std::any_of(faults.found.begin(), faults.found.end(), [&](const Faults::Found& f) {
    return f.path.starts_with(path) &&
           (f.path.size() == path.size() || f.path[path.size()] == '.' || f.path[path.size()] == '[');
  });
}

void fault_add_at(Faults& faults, const Location& at, const std::string& place, const std::string& message) {
  faults.found.push_back({at, {one_line(place), one_line(message)}, ""});
}

void faults_report(const Faults& faults, std::vector<Problem>& problems) {
  std::vector<Faults::Found> sorted = faults.found;
  std::stable_sort(sorted.begin(), sorted.end(), [&](const Faults::Found& a, const Faults::Found& b) {
    const auto key = [&](const Location& p) { return std::tuple(p.file != faults.file, p.file, p.line); };
    return key(a.location) < key(b.location);
  });
  for (const Faults::Found& f : sorted) problems.push_back(f.problem);
}

std::string number_text(double value) {
  char text[32];
  return {text, std::to_chars(text, text + sizeof text, value, std::chars_format::general).ptr};
}

std::string shortened(const std::string& text) {
  constexpr std::size_t kMaxLength = 80;
  if (text.size() <= kMaxLength) return text;
  std::size_t end = kMaxLength;
  while (end > 0 && (static_cast<unsigned char>(text[end]) & 0xC0) == 0x80)
    --end;  // within a character of UTF-8
  return text.substr(0, end) + "...";
}

std::string in_quotes(const std::string& text) { return '"' + shortened(text) + '"'; }

std::string entries_text(std::size_t count) {
  return std::to_string(count) + (count == 1 ? " entry" : " entries");
}

std::string rounded(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.6g", value);
  return text;
}

std::string point_text(Vec2 p) { return "[" + rounded(p[0]) + ", " + rounded(p[1]) + "] m"; }

std::string entry(const std::string& path, std::size_t i) { return path + "[" + std::to_string(i) + "]"; }

}  // namespace drape::scene
