#include "body/library.h"

#include <mutex>

#include "body/shared_object.h"

namespace drape::body {

std::shared_ptr<const drape_contact_library> contact_library(std::string& hindrance) {
  static std::mutex one_at_a_time;
  static std::weak_ptr<const drape_contact_library> shared;
  const std::lock_guard<std::mutex> lock(one_at_a_time);
  if (auto library = shared.lock()) return library;
  SharedObject object = shared_object_beside(DRAPE_CONTACT_FILE, hindrance);
  if (!object.handle) return nullptr;
  using Get = const drape_contact_library* (*)();
  const auto get = reinterpret_cast<Get>(shared_object_symbol(object, "drape_contact_library_2"));
  if (!get) {
    hindrance = object.file + " is of another version";
    shared_object_close(object);
    return nullptr;
  }
  const std::shared_ptr<const drape_contact_library> library(
      get(), [object](const drape_contact_library*) { shared_object_close(object); });
  shared = library;
  return library;
}

}  // namespace drape::body
