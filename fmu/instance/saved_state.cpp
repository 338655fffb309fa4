#include <algorithm>

#include "instance/instance.h"

namespace drape::instance {
namespace {

void save_into(Instance& instance, Saved& saved) {
  saved.cloth = drape_save(instance.cloth, saved.cloth);
  saved.phase = instance.phase;
  saved.stop_time = instance.stop_time;
}

void restore_from(Instance& instance, const Saved& saved) {
  drape_restore(instance.cloth, saved.cloth);
  instance.phase = saved.phase;
  instance.stop_time = saved.stop_time;
  instance.read = 0;
}

auto find_saved(Instance& instance, const Saved* saved) {
  return std::find_if(instance.saved.begin(), instance.saved.end(),
                      [&](const auto& own) { return own.get() == saved; });
}

}  // namespace

Saved* instance_save(Instance& instance, Saved* into) {
  if (!into) {
    instance.saved.push_back(std::make_unique<Saved>());
    into = instance.saved.back().get();
  } else if (find_saved(instance, into) == instance.saved.end()) {
    instance_refuse(instance, DRAPE_DISCARD,
                    "the state to overwrite is none of this instance's saved states");
    return nullptr;
  }
  save_into(instance, *into);
  return into;
}

drape_status instance_restore(Instance& instance, const Saved* saved) {
  const auto own = find_saved(instance, saved);
  if (own == instance.saved.end())
    return instance_refuse(instance, DRAPE_DISCARD,
                           "the state to restore is none of this instance's saved states");
  restore_from(instance, **own);
  return DRAPE_OK;
}

drape_status instance_forget(Instance& instance, const Saved* saved) {
  const auto own = find_saved(instance, saved);
  if (own == instance.saved.end())
    return instance_refuse(instance, DRAPE_DISCARD,
                           "the state to free is none of this instance's saved states");
  drape_snapshot_free((*own)->cloth);
  instance.saved.erase(own);
  return DRAPE_OK;
}

}  // namespace drape::instance
