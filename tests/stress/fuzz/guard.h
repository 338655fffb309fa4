// What watches a case: time, memory, leaks, and a trace of the case that ended the program.
#pragma once
#include <string>

namespace drape::fuzz {

// Processor time that one case may take, s: where it reads only, and where it advances cloth. An interval may
// take a million steps.
inline constexpr int kFileSeconds = 10, kSequenceSeconds = 120;

// Installs the limits. Once per process.
void guard_begin();

// The case that runs now, to be named if it ends the program, and its time limit. An empty name: no case
// runs.
void guard_case(const std::string& name, int seconds = 0);

// True if memory has leaked since the last call. Without the address sanitizer: false.
bool guard_leaks();

}  // namespace drape::fuzz
