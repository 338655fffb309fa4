// A cloth behind the C interface, and what it says.
#pragma once
#include <memory>
#include <string>
#include <vector>

#include "drape/drape.h"

namespace drape::tests {

struct Close {
  void operator()(drape_cloth* c) const { drape_close(c); }
};
using Cloth = std::unique_ptr<drape_cloth, Close>;

struct Heard {
  std::vector<std::string> errors, events;
};
inline void hear(void* user, drape_log_kind kind, const char* message) {
  Heard& heard = *static_cast<Heard*>(user);
  if (kind == DRAPE_LOG_ERROR) heard.errors.push_back(message);
  if (kind == DRAPE_LOG_EVENT) heard.events.push_back(message);
}

}  // namespace drape::tests
