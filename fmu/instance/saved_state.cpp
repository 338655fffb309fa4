#include <algorithm>

#include "instance/instance.h"

namespace drape::instance {
namespace {

void save_into(Instance& s, Saved& saved) {
  saved.cloth = drape_save(s.cloth, saved.cloth);
  saved.phase = s.phase;
  saved.stop_time = s.stop_time;
}

void restore_from(Instance& s, const Saved& saved) {
  drape_restore(s.cloth, saved.cloth);
  s.phase = saved.phase;
  s.stop_time = saved.stop_time;
  s.read = 0;
}

auto find_saved(Instance& s, const Saved* saved) {
  return std::find_if(s.saved.begin(), s.saved.end(), [&](const auto& own) { return own.get() == saved; });
}

}  // namespace

Saved* instance_save(Instance& s, Saved* into) {
  if (!into) {
    s.saved.push_back(std::make_unique<Saved>());
    into = s.saved.back().get();
  } else if (find_saved(s, into) == s.saved.end()) {
    instance_refuse(s, DRAPE_DISCARD, "the state to overwrite is none of this instance's saved states");
    return nullptr;
  }
  save_into(s, *into);
  return into;
}

drape_status instance_restore(Instance& s, const Saved* saved) {
  const auto own = find_saved(s, saved);
  if (own == s.saved.end())
    return instance_refuse(s, DRAPE_DISCARD, "the state to restore is none of this instance's saved states");
  restore_from(s, **own);
  return DRAPE_OK;
}

drape_status instance_forget(Instance& s, const Saved* saved) {
  const auto own = find_saved(s, saved);
  if (own == s.saved.end())
    return instance_refuse(s, DRAPE_DISCARD, "the state to free is none of this instance's saved states");
  drape_snapshot_free((*own)->cloth);
  s.saved.erase(own);
  return DRAPE_OK;
}

}  // namespace drape::instance
