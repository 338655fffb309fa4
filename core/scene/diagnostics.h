// Faults of a document and where they stand. Whoever finds a fault names a dotted path; its line follows.
#pragma once
#include <map>
#include <string>
#include <vector>

#include "scene/scene.h"

namespace drape::scene {

struct Location {
  std::string file;   // "" where no text stands behind a path
  unsigned line = 0;  // from 1; 0 = the file as a whole
};

struct Faults {
  std::string file;                           // the scene file
  std::map<std::string, Location> locations;  // dotted path -> where it stands
  struct Found {
    Location location;
    Problem problem;
    std::string path;  // dotted; "" where none stands for the place
  };
  std::vector<Found> found;
};

// Adds a fault. Its line is that of the longest beginning of the path that has one: a missing key is reported
// on the line of its table, an entry on that of its list.
void fault_add(Faults& faults, const std::string& path, const std::string& message);

// True if there is a fault at the path or in what it holds.
bool fault_within(const Faults& faults, const std::string& path);

// "scene.toml:12: scene.step", the place of such a fault.
std::string fault_place(const Faults& faults, const std::string& path);

// The same where no path stands for the place.
void fault_add_at(Faults& faults, const Location& at, const std::string& place, const std::string& message);

// Appends the faults found, in the order of the text, the scene file first.
void faults_report(const Faults& faults, std::vector<Problem>& problems);

// Texts of messages: the shortest decimal that gives the same double; a text in quotes, cut after 80
// characters; the length of a list.
std::string number_text(double value);
std::string in_quotes(const std::string& text);
std::string entries_text(std::size_t count);
std::string rounded(double value);  // to six digits, of numbers that have been computed
std::string point_text(Vec2 point);
std::string entry(const std::string& path, std::size_t index);  // "piece.outline[3]"

}  // namespace drape::scene
