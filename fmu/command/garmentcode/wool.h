// The measured wool of examples/fabrics, carried by the command: what is imported without a fabric is of it.
#pragma once

namespace drape::command {

extern const char* const kWool;  // TOML

}  // namespace drape::command
