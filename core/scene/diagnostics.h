// The faults of a document and their locations. The code that finds a fault gives a dotted path, such as
// "scene.step"; the file and line are looked up here.
#pragma once
#include <map>
#include <string>
#include <vector>

#include "scene/scene.h"

namespace drape::scene {

struct Location {
  std::string file;   // "" where the path is not in any text
  unsigned line = 0;  // from 1; 0: the file as a whole
};

struct Faults {
  std::string file;                           // the scene file
  std::map<std::string, Location> locations;  // dotted path -> location
  struct Found {
    Location location;
    Problem problem;
    std::string path;  // dotted; "" where the place has no path
  };
  std::vector<Found> found;
};

// Adds a fault. Its line is that of the longest prefix of the path with a known line: a missing key is
// reported on the line of its table, an entry on the line of its list.
void fault_add(Faults& faults, const std::string& path, const std::string& message);

// True if there is a fault at the path or at a path within it.
bool fault_within(const Faults& faults, const std::string& path);

// The place of a fault as text: "scene.toml:12: scene.step".
std::string fault_place(const Faults& faults, const std::string& path);

// Adds a fault at a location without a dotted path; `place` is the text of the message.
void fault_add_at(Faults& faults, const Location& at, const std::string& place, const std::string& message);

// Appends the faults in the order of their locations, those of the scene file first.
void faults_report(const Faults& faults, std::vector<Problem>& problems);

// Parts of messages.
std::string number_text(double value);           // the shortest decimal that gives the same double
std::string shortened(const std::string& text);  // cut after 80 bytes, between characters
std::string in_quotes(const std::string& text);  // shortened
std::string entries_text(std::size_t count);     // the length of a list: "3 entries"
std::string rounded(double value);               // to six digits, for computed numbers
std::string point_text(Vec2 point);
std::string entry(const std::string& path, std::size_t index);  // "piece.outline[3]"

}  // namespace drape::scene
