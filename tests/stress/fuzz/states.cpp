// Damaged saved states. Most of them get a header that is right again, so that the damage reaches the fields.
#include "states.h"

#include <cmath>
#include <cstring>
#include <fstream>
#include <iterator>
#include <map>
#include <memory>

#include "drape/drape.h"
#include "state/bulk.h"
#include "state/sealed.h"

namespace drape::fuzz {
namespace {

namespace fs = std::filesystem;

constexpr const char* kScenes[] = {"driven", "sewn", "fitted", "order_4", "bodies_and_self_contact"};
constexpr double kMaxSteps = 1000;  // in an interval; states with more are read, but not moved on

struct CloseCloth {
  void operator()(drape_cloth* cloth) const { drape_close(cloth); }
};
struct Subject {
  std::unique_ptr<drape_cloth, CloseCloth> owner;
  std::string bytes;  // of its own state, some intervals after the start
  state::Seal seal;

  drape_cloth* cloth() const { return owner.get(); }
};
Outcome* present = nullptr;  // of the case under way

void log_take(void*, drape_log_kind kind, const char* message) {
  if (kind == DRAPE_LOG_ERROR && present) present->sentences.push_back(message);
}

std::string bytes_of(drape_cloth* cloth) {
  drape_snapshot* saved = drape_save(cloth, nullptr);
  std::string bytes(drape_snapshot_size(saved), '\0');
  drape_snapshot_write(cloth, saved, bytes.data());
  drape_snapshot_free(saved);
  return bytes;
}

state::Seal seal_of(const std::string& bytes) {
  state::Seal seal;
  std::memcpy(&seal.layout, bytes.data() + 8, 8);
  std::memcpy(&seal.scene, bytes.data() + 24, 8);
  return seal;
}

// One cloth for each scene, opened once and kept.
std::map<std::string, Subject>& subjects() {
  static std::map<std::string, Subject> all;
  return all;
}

bool restore(const Subject& subject, const std::string& bytes) {
  drape_snapshot* read = drape_snapshot_read(subject.cloth(), bytes.data(), bytes.size());
  if (!read) return false;
  drape_restore(subject.cloth(), read);
  drape_snapshot_free(read);
  return true;
}

// What a master would do next.
void go_on(const Subject& subject, Outcome& outcome) {
  const double q = drape_communication(subject.cloth());
  if (!(q / drape_progress_of(subject.cloth()).step_size <= kMaxSteps)) return;
  drape_get_outputs(subject.cloth(), DRAPE_OUT_ALL);
  for (int k = 0; k < 3; ++k) {
    const std::size_t before = outcome.sentences.size();
    if (drape_advance(subject.cloth(), q) != DRAPE_OK && outcome.sentences.size() == before)
      outcome.faults.push_back("an advance failed without a sentence");
  }
  drape_get_outputs(subject.cloth(), DRAPE_OUT_ALL);
}

}  // namespace

void states_corpus(const fs::path& work, std::vector<std::string>& corpus) {
  const fs::path seeds = fs::path(DRAPE_SOURCE_DIR) / "tests/stress/fuzz/seeds", folder = work / "states";
  fs::create_directories(folder);
  for (const char* mesh : {"box.obj", "ball.obj"})
    fs::copy_file(seeds / mesh, folder / mesh, fs::copy_options::overwrite_existing);
  for (const char* name : kScenes) {
    Subject& subject = subjects()[name];
    const fs::path scene = folder / (std::string(name) + ".toml");
    fs::copy_file(seeds / "fmi" / scene.filename(), scene, fs::copy_options::overwrite_existing);
    subject.owner.reset(drape_open(scene.c_str(), log_take, nullptr));
    if (!subject.cloth()) throw std::runtime_error("cannot open " + scene.string());
    drape_parameters_of(subject.cloth())->ramp = 40 * drape_communication(subject.cloth());
    drape_parameters_of(subject.cloth())->gravity[0] = 1;
    for (int k = 0; k < 30; ++k) {
      drape_advance(subject.cloth(), drape_communication(subject.cloth()));
      if (k % 15 == 14) corpus.push_back(bytes_of(subject.cloth()));
    }
    subject.bytes = corpus.back();
    subject.seal = seal_of(subject.bytes);
  }
}

void state_run(const fs::path& file, Outcome& outcome) {
  if (subjects().empty()) {
    std::vector<std::string> none;
    states_corpus(file.parent_path().parent_path(), none);
  }
  std::ifstream stream(file, std::ios::binary);
  std::string bytes{std::istreambuf_iterator<char>(stream), {}};
  const Subject* subject = &subjects().begin()->second;
  if (bytes.size() >= state::kHeaderSize)
    for (const auto& [name, candidate] : subjects())
      if (candidate.seal.scene == seal_of(bytes).scene) subject = &candidate;
  const bool sealed =
      bytes.size() >= state::kHeaderSize && state::bytes_hash(bytes.data(), bytes.size(), 0) % 8 != 0;
  if (sealed) state::seal_write(reinterpret_cast<unsigned char*>(bytes.data()), bytes.size(), subject->seal);
  present = &outcome;
  if (restore(*subject, bytes)) {
    go_on(*subject, outcome);
    outcome.sentences.push_back("restored");
  } else if (outcome.sentences.size() != 1) {
    outcome.faults.push_back("a refused state gave " + std::to_string(outcome.sentences.size()) +
                             " sentences");
  }
  // Whatever came of it, the cloth takes back its own state, of which nothing is lost.
  if (!restore(*subject, subject->bytes) || bytes_of(subject->cloth()) != subject->bytes)
    outcome.faults.push_back("the cloth does not return to its own state");
  present = nullptr;
}

}  // namespace drape::fuzz
