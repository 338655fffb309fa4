// The kinds of cases. Each reads one file, or makes one sequence of calls, and says what came of it.
#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "guard.h"
#include "mutate.h"

namespace drape::fuzz {

struct Outcome {
  std::vector<std::string> sentences;  // the problems reported, and the fact if there are none
  std::vector<std::string> faults;     // what the program should not have done
};

// A reader of files. `work` is a folder that is its own; the file in it is to be read.
struct Reader {
  const char* name;
  Form form;
  const char* file;                // its name in the folder
  std::vector<const char*> seeds;  // files and folders below the root of the repository
  void (*run)(const std::filesystem::path& file, Outcome& outcome);
  // Makes further seeds; may be null.
  void (*seeds_make)(const std::filesystem::path& work, std::vector<std::string>& corpus) = nullptr;
  int seconds = kFileSeconds;  // of processor time that a case may take
};
const std::vector<Reader>& readers();

// Puts what the files of this kind refer to beside them.
void readers_prepare(const std::filesystem::path& work);

// A random sequence of calls of the FMI, from this seed alone. `scene`: which of the scenes, by name; empty:
// any.
void fmi_sequence(const std::filesystem::path& work, std::uint64_t seed, const std::string& scene,
                  Outcome& outcome);

// True for a scene with bodies or self-contact.
bool fmi_scene_touches(std::uint64_t seed, const std::string& scene);

}  // namespace drape::fuzz
