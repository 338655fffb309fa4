#include <algorithm>
#include <cmath>
#include <cstring>

#include "instance/instance.h"

namespace drape::instance {
namespace {

constexpr double kMaxSteps = 9e15;  // of a master; whole numbers are exact up to here

// What an instance attaches to the bytes of a cloth.
struct Attached {
  double phase = double(unsigned(Phase::kStepComplete));
  double stop_time = std::numeric_limits<double>::infinity();
  double steps = 0, read = 0, derivatives_asked = 0, history_read = 0, history_length = 0;
  double balance_begun = 0, balance_gravity = 0, balance_largest = 0, balance_error = 0, balance_time = 0;
};

void save_into(Instance& instance, Saved& saved) {
  saved.cloth = drape_save(instance.cloth, saved.cloth);
  saved.phase = instance.phase;
  saved.stop_time = instance.stop_time;
  saved.steps = instance.steps;
  saved.read = instance.read | instance.read_before_saving;
  saved.derivatives_asked = instance.derivatives_asked;
  saved.history = instance.history;
  saved.balance = instance.balance;
}

// Before a saved state becomes bytes.
void attach(const Saved& saved) {
  const Attached attached{double(unsigned(saved.phase)),
                          saved.stop_time,
                          double(saved.steps),
                          double(saved.read),
                          double(saved.derivatives_asked),
                          double(saved.history.read),
                          saved.history.length,
                          double(saved.balance.begun),
                          saved.balance.gravity,
                          saved.balance.largest,
                          saved.balance.error,
                          saved.balance.time};
  const std::size_t history = saved.history.value.size() * sizeof(double);
  std::vector<unsigned char> bytes(sizeof attached + history);
  std::memcpy(bytes.data(), &attached, sizeof attached);
  if (history > 0) std::memcpy(bytes.data() + sizeof attached, saved.history.value.data(), history);
  drape_snapshot_attach(saved.cloth, bytes.data(), bytes.size());
}

void restore_from(Instance& instance, const Saved& saved) {
  drape_restore(instance.cloth, saved.cloth);
  instance.phase = saved.phase;
  instance.stop_time = saved.stop_time;
  instance.steps = saved.steps;
  instance.derivatives_asked = saved.derivatives_asked;
  instance.history = saved.history;
  instance.balance = saved.balance;
  instance.read_before_saving = saved.read;
  instance.read = 0;
}

// Whether a number is a whole one from 0 to a maximum.
bool is_whole(double value, double max) { return value >= 0 && value <= max && value == std::floor(value); }

// False where this is not what an instance attaches. A state that was saved without an instance has nothing
// attached: it is one between two steps, without a stop time.
bool attached_read(const Instance& instance, Saved& saved) {
  std::size_t size = 0;
  const auto* bytes = static_cast<const unsigned char*>(drape_snapshot_attached(saved.cloth, &size));
  Attached a;
  if (size != 0 && size < sizeof a) return false;
  if (size != 0) std::memcpy(&a, bytes, sizeof a);
  const std::size_t rows = a.history_read != 0 ? instance.recorded.size() : 0;
  if (size != 0 && size != sizeof a + rows * sizeof(double)) return false;
  saved.history.value.resize(rows);
  if (rows > 0) std::memcpy(saved.history.value.data(), bytes + sizeof a, rows * sizeof(double));
  const bool finite = std::all_of(saved.history.value.begin(), saved.history.value.end(),
                                  [](double value) { return std::isfinite(value); });
  if (!finite || !is_whole(a.phase, double(unsigned(Phase::kError))) || std::isnan(a.stop_time) ||
      !is_whole(a.steps, kMaxSteps) || !is_whole(a.read, DRAPE_OUT_ALL) ||
      !is_whole(a.derivatives_asked, DRAPE_OUT_ALL) || !is_whole(a.history_read, DRAPE_OUT_SCALARS) ||
      !(a.history_length >= 0 && std::isfinite(a.history_length)) || !is_whole(a.balance_begun, 1) ||
      !std::isfinite(a.balance_gravity) || !(a.balance_largest >= 0 && std::isfinite(a.balance_largest)) ||
      !std::isfinite(a.balance_error) || !std::isfinite(a.balance_time))
    return false;
  saved.phase = Phase(unsigned(a.phase));
  saved.stop_time = a.stop_time;
  saved.steps = std::int64_t(a.steps);
  saved.read = int(a.read);
  saved.derivatives_asked = int(a.derivatives_asked);
  saved.history.read = int(a.history_read);
  saved.history.length = a.history_length;
  saved.balance = {a.balance_begun != 0, a.balance_gravity, a.balance_largest, a.balance_error,
                   a.balance_time};
  return true;
}

// The place of a state among those of the instance. Refuses one that is not there; `purpose`: what it is for.
auto find_saved(Instance& instance, const Saved* saved, const char* purpose) {
  const auto own = std::find_if(instance.saved.begin(), instance.saved.end(),
                                [&](const auto& one) { return one.get() == saved; });
  if (own == instance.saved.end())
    instance_refuse(instance, DRAPE_DISCARD,
                    std::string("the state to ") + purpose + " is none of this instance's saved states");
  return own;
}

}  // namespace

Saved* instance_save(Instance& instance, Saved* into) {
  if (!into) {
    instance.saved.push_back(std::make_unique<Saved>());
    into = instance.saved.back().get();
  } else if (find_saved(instance, into, "overwrite") == instance.saved.end()) {
    return nullptr;
  }
  save_into(instance, *into);
  return into;
}

drape_status instance_restore(Instance& instance, const Saved* saved) {
  const auto own = find_saved(instance, saved, "restore");
  if (own == instance.saved.end()) return DRAPE_DISCARD;
  restore_from(instance, **own);
  return DRAPE_OK;
}

drape_status instance_forget(Instance& instance, const Saved* saved) {
  const auto own = find_saved(instance, saved, "free");
  if (own == instance.saved.end()) return DRAPE_DISCARD;
  drape_snapshot_free((*own)->cloth);
  instance.saved.erase(own);
  return DRAPE_OK;
}

drape_status instance_bytes_size(Instance& instance, const Saved* saved, std::size_t* size) {
  if (find_saved(instance, saved, "write") == instance.saved.end()) return DRAPE_DISCARD;
  attach(*saved);
  *size = drape_snapshot_size(saved->cloth);
  return DRAPE_OK;
}

drape_status instance_write(Instance& instance, const Saved* saved, unsigned char* bytes, std::size_t size) {
  std::size_t needed = 0;
  if (const drape_status status = instance_bytes_size(instance, saved, &needed); status != DRAPE_OK)
    return status;
  if (size < needed)
    return instance_refuse(instance, DRAPE_DISCARD,
                           "the place for the state has " + std::to_string(size) +
                               " bytes; allowed: at least its size, " + std::to_string(needed));
  drape_snapshot_write(instance.cloth, saved->cloth, bytes);
  return DRAPE_OK;
}

Saved* instance_read(Instance& instance, const unsigned char* bytes, std::size_t size) {
  auto saved = std::make_unique<Saved>();
  saved->cloth = drape_snapshot_read(instance.cloth, bytes, size);
  instance_flush(instance, saved->cloth ? DRAPE_OK : DRAPE_DISCARD);
  if (!saved->cloth) return nullptr;
  if (!attached_read(instance, *saved)) {
    drape_snapshot_free(saved->cloth);
    instance_refuse(instance, DRAPE_DISCARD,
                    "the saved state is damaged: what belongs to its instance is none of that");
    return nullptr;
  }
  instance.saved.push_back(std::move(saved));
  return instance.saved.back().get();
}

}  // namespace drape::instance
