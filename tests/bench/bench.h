// The benchmark: groups of rows, each a ratio measured in one run. Run it pinned to a core: taskset -c 0
// drape bench.
#pragma once
#include <string>
#include <vector>

namespace drape::bench {

// One row of the table.
struct Row {
  std::string group, name;
  std::size_t particles;
  std::string contender;  // the kernel
  double rate;            // million particle-steps per second
  double ratio;           // of this rate to that of the row named in `against`
  std::string against;
};

// How long each figure is measured, `turns` times `seconds`; and the scenes of the group "scenes".
struct Patience {
  int turns = 7;
  double seconds = 0.1;
  std::vector<std::string> scenes;  // files
};

struct Group {
  const char* name;
  const char* description;
  std::vector<Row> (*rows)(const Patience&);
  bool by_default = true;  // false: the group runs only when it is named
};
const std::vector<Group>& groups();

}  // namespace drape::bench
