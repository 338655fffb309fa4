// Saved states as cases of the fuzzer.
#pragma once
#include "cases.h"

namespace drape::fuzz {

// Adds the states of some scenes in motion.
void states_corpus(const std::filesystem::path& work, std::vector<std::string>& corpus);

void state_run(const std::filesystem::path& file, Outcome& outcome);

}  // namespace drape::fuzz
