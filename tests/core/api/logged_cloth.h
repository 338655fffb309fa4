// A cloth behind the C interface, and what it logs.
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

struct Logged {
  std::vector<std::string> errors, warnings, events;
};
inline void on_message(void* user, drape_log_kind kind, const char* message) {
  Logged& logged = *static_cast<Logged*>(user);
  if (kind == DRAPE_LOG_ERROR) logged.errors.push_back(message);
  if (kind == DRAPE_LOG_WARNING) logged.warnings.push_back(message);
  if (kind == DRAPE_LOG_EVENT) logged.events.push_back(message);
}

}  // namespace drape::tests
