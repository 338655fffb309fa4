// A fault: one edit of a correct text, and all the messages that it gives.
#pragma once
#include <gtest/gtest.h>

#include <stdexcept>

#include "scene_file.h"

namespace drape::tests {

using Messages = std::vector<std::string>;

struct Case {
  const char* name;
  std::string from, to;  // the edit; an empty `from` stands for the whole text
  Messages messages;
};

inline void PrintTo(const Case& c, std::ostream* stream) { *stream << c.name; }

inline std::string edited(std::string text, const Case& c) {
  if (c.from.empty()) return c.to;
  const std::size_t at = text.find(c.from);
  if (at == std::string::npos) throw std::logic_error("nothing to edit: " + c.from);
  return text.replace(at, c.from.size(), c.to);
}

inline std::string name_of(const testing::TestParamInfo<Case>& info) { return info.param.name; }

// The messages for an edit of the scene file, beside a correct fabric file.
inline Messages scene_fault(const Case& c, const std::string& scene = kScene) {
  const SceneFolder folder;
  folder.write("wool.toml", kFabric);
  return messages_of(folder, folder.write("scene.toml", edited(scene, c)));
}

}  // namespace drape::tests
