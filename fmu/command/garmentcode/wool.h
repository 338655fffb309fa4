// The measured wool of examples/fabrics, built into the command: the fabric of an import without one.
#pragma once

namespace drape::command {

extern const char* const kWool;  // TOML

}  // namespace drape::command
