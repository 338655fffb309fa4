// Fuzzing: damaged files for what reads files, random calls for the FMI. README.md beside this file says how
// to use it.
//
//     drape_fuzz KIND ... [--cases N] [--seconds S] [--seed S] [--work FOLDER]
//     drape_fuzz KIND --file FILE          reads this file once
//     drape_fuzz fmi [--scene NAME] ...    sequences with this scene only
//
// KIND: scene, fabric, obj, stl, stl_binary, pattern, inputs, state, fmi; or all, files, touching (of fmi,
// scenes with bodies or self-contact). Exits with 1 after a fault.
#include <charconv>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <ctime>
#include <fstream>
#include <iterator>
#include <set>

#include "body/library.h"
#include "cases.h"
#include "guard.h"

namespace drape::fuzz {
namespace {

namespace fs = std::filesystem;

struct Options {
  std::vector<std::string> kinds;
  std::uint64_t cases = 1000, seed = 1;
  double seconds = 1e9;  // of wall time, of each kind
  fs::path work = fs::absolute(fs::temp_directory_path() / "drape_fuzz");
  std::string file, scene;
};

struct Tally {
  std::uint64_t cases = 0, faults = 0, kept = 0;
  bool failed() const { return faults > 0; }
};

std::string bytes_of(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

// The files of this kind below a file or folder, by name.
void corpus_add(const fs::path& place, const std::string& extension, std::vector<std::string>& corpus) {
  std::set<fs::path> files;
  if (fs::is_directory(place))
    for (const fs::directory_entry& entry : fs::recursive_directory_iterator(place))
      if (entry.is_regular_file() && entry.path().extension() == extension) files.insert(entry.path());
  for (const fs::path& file : files) corpus.push_back(bytes_of(file));
}

// A sentence without its numbers and quoted texts: cases that bring a new one are kept, as they came further
// or elsewhere.
std::string shape_of(const std::string& sentence) {
  std::string shape;
  char quote = 0;
  for (const char c : sentence) {
    if (quote) quote = c == quote ? 0 : quote;
    else if (c == '"' || c == '\'') quote = c, shape += c;
    else if (std::strchr("0123456789.-+eE", c) == nullptr) shape += c;
  }
  return shape.substr(0, 300);
}

template <class Run>
Outcome outcome_of(Run run) {
  Outcome outcome;
  try {
    run(outcome);
  } catch (const std::exception& e) {
    outcome.faults.push_back(std::string("it threw: ") + e.what());
  }
  for (const std::string& sentence : outcome.sentences) {
    if (sentence.empty()) outcome.faults.push_back("a problem without a sentence");
    if (sentence.find('\n') != std::string::npos)
      outcome.faults.push_back("a problem of several lines: " + sentence);
  }
  return outcome;
}

void faults_print(const Outcome& outcome, const std::string& name, Tally& tally) {
  if (outcome.faults.empty()) return;
  ++tally.faults;
  std::fprintf(stderr, "FAULT in %s\n", name.c_str());
  for (std::size_t k = 0; k < outcome.faults.size() && k < 5; ++k)
    std::fprintf(stderr, "  %s\n", outcome.faults[k].substr(0, 400).c_str());
}

void leaks_check(const std::string& name, Tally& tally) {
  if (!guard_leaks()) return;
  ++tally.faults;
  std::fprintf(stderr, "FAULT: memory has leaked in %s, or up to 1000 cases before it\n", name.c_str());
}

struct Clock {
  std::time_t begin = std::time(nullptr);
  double seconds() const { return std::difftime(std::time(nullptr), begin); }
};

void file_replay(const Reader& reader, const Options& options) {
  const fs::path file = options.work / "files" / reader.file;
  fs::copy_file(options.file, file, fs::copy_options::overwrite_existing);
  guard_case(options.file, reader.seconds);
  const Outcome outcome = outcome_of([&](Outcome& o) { reader.run(file, o); });
  guard_case("");
  for (const std::string& sentence : outcome.sentences) std::printf("%s\n", sentence.c_str());
  for (const std::string& fault : outcome.faults) std::printf("FAULT: %s\n", fault.c_str());
}

Tally files_fuzz(const Reader& reader, const Options& options) {
  const std::string extension = fs::path(reader.file).extension().string();
  const fs::path kept = options.work / "corpus" / reader.name, faulty = options.work / "faults" / reader.name,
                 file = options.work / "files" / reader.file;
  fs::create_directories(kept), fs::create_directories(faulty);
  std::vector<std::string> corpus;
  for (const char* seeds : reader.seeds) corpus_add(fs::path(DRAPE_SOURCE_DIR) / seeds, extension, corpus);
  if (reader.seeds_make) reader.seeds_make(options.work, corpus);
  corpus_add(kept, extension, corpus);
  Random random{std::mt19937_64(options.seed)};
  std::set<std::string> shapes;
  // The address sanitizer keeps 100 KB for each time that a library is loaded.
  std::string hindrance;
  const auto contact = body::contact_library(hindrance);
  Tally tally;
  const Clock clock;
  for (; tally.cases < options.cases && clock.seconds() < options.seconds; ++tally.cases) {
    const std::string number = std::to_string(options.seed) + "_" + std::to_string(tally.cases),
                      name = std::string(reader.name) + " seed " + std::to_string(options.seed) + " case " +
                             std::to_string(tally.cases) + ", " + file.string();
    const std::string bytes = mutate(random, corpus, reader.form);
    std::ofstream(file, std::ios::binary) << bytes;
    guard_case(name, reader.seconds);
    const Outcome outcome = outcome_of([&](Outcome& o) { reader.run(file, o); });
    if (tally.cases % 1000 == 999) leaks_check(name, tally);
    guard_case("");
    faults_print(outcome, name, tally);
    if (!outcome.faults.empty())
      fs::copy_file(file, faulty / (number + extension), fs::copy_options::overwrite_existing);
    bool fresh = false;
    for (const std::string& sentence : outcome.sentences) fresh |= shapes.insert(shape_of(sentence)).second;
    if (!fresh || bytes.size() > 20000 || tally.kept >= 2000) continue;
    ++tally.kept;
    corpus.push_back(bytes);
    std::ofstream(kept / (number + extension), std::ios::binary) << bytes;
  }
  leaks_check(std::string(reader.name) + ", at its end", tally);
  return tally;
}

// Case k is the sequence of seed + k, whatever came before it.
Tally fmi_fuzz(const Options& options, bool touching) {
  Tally tally;
  const Clock clock;
  for (std::uint64_t seed = options.seed; tally.cases < options.cases && clock.seconds() < options.seconds;
       ++seed) {
    if (touching && !fmi_scene_touches(seed, options.scene)) continue;
    const std::string name = "fmi --seed " + std::to_string(seed) + " --cases 1";
    guard_case(name, kSequenceSeconds);
    const Outcome outcome =
        outcome_of([&](Outcome& o) { fmi_sequence(options.work, seed, options.scene, o); });
    if (tally.cases % 100 == 99) leaks_check(name, tally);
    guard_case("");
    faults_print(outcome, name, tally);
    ++tally.cases;
  }
  leaks_check("fmi, at its end", tally);
  return tally;
}

Tally kind_run(const std::string& kind, const Options& options) {
  if (kind == "fmi" || kind == "touching") return fmi_fuzz(options, kind == "touching");
  for (const Reader& reader : readers()) {
    if (kind != reader.name) continue;
    if (options.file.empty()) return files_fuzz(reader, options);
    file_replay(reader, options);
    return {};
  }
  std::fprintf(stderr, "%s is no kind; see the first lines of main.cpp\n", kind.c_str());
  std::exit(2);
}

// The value of an option as a number, all of it.
template <class Number>
Number number_of(const std::string& text) {
  Number number{};
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc() || end != text.data() + text.size())
    std::fprintf(stderr, "'%s' is no number\n", text.c_str()), std::exit(2);
  return number;
}

Options options_read(int count, char** arguments) {
  Options options;
  for (int k = 1; k < count; ++k) {
    const std::string word = arguments[k];
    const std::string value = k + 1 < count ? arguments[k + 1] : "";
    if (word.starts_with("--")) ++k;
    if (word == "--cases") options.cases = number_of<std::uint64_t>(value);
    else if (word == "--seconds") options.seconds = number_of<double>(value);
    else if (word == "--seed") options.seed = number_of<std::uint64_t>(value);
    else if (word == "--work") options.work = fs::absolute(value);
    else if (word == "--file") options.file = value;
    else if (word == "--scene") options.scene = value;
    else options.kinds.push_back(word);
  }
  std::vector<std::string> kinds;
  for (const std::string& kind : options.kinds) {
    if (kind == "all" || kind == "files")
      for (const Reader& reader : readers()) kinds.push_back(reader.name);
    if (kind == "all") kinds.push_back("fmi");
    if (kind != "all" && kind != "files") kinds.push_back(kind);
  }
  options.kinds = std::move(kinds);
  return options;
}

}  // namespace
}  // namespace drape::fuzz

int main(int count, char** arguments) {
  using namespace drape::fuzz;
  const Options options = options_read(count, arguments);
  if (options.kinds.empty()) {
    std::fprintf(stderr, "usage: drape_fuzz KIND ... [--cases N] [--seconds S] [--seed S] [--work FOLDER]\n");
    return 2;
  }
  readers_prepare(options.work);
  guard_begin();
  bool failed = false;
  for (const std::string& kind : options.kinds) {
    const Clock clock;
    const Tally tally = kind_run(kind, options);
    std::printf("%-10s  seed %llu: %llu cases, %llu kept, %llu faults, %.0f s\n", kind.c_str(),
                static_cast<unsigned long long>(options.seed), static_cast<unsigned long long>(tally.cases),
                static_cast<unsigned long long>(tally.kept), static_cast<unsigned long long>(tally.faults),
                clock.seconds());
    std::fflush(stdout);
    failed |= tally.failed();
  }
  return failed ? 1 : 0;
}
