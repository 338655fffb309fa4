#include "body/library.h"

#include <dlfcn.h>

#include <filesystem>
#include <mutex>

namespace drape::body {

const drape_contact_library* contact_library(std::string& hindrance) {
  static std::mutex one_at_a_time;
  static const drape_contact_library* library = nullptr;
  const std::lock_guard<std::mutex> lock(one_at_a_time);
  if (library) return library;
  Dl_info here{};
  if (!dladdr(reinterpret_cast<const void*>(&contact_library), &here))
    return hindrance = "dladdr failed", nullptr;
  std::error_code error;
  const auto self = std::filesystem::canonical(here.dli_fname, error);
  const std::string file = (self.parent_path() / "libdrape_contact.so").string();
  void* opened = dlopen(file.c_str(), RTLD_NOW | RTLD_LOCAL);
  if (!opened) return hindrance = dlerror(), nullptr;
  using Get = const drape_contact_library* (*)();
  const auto get = reinterpret_cast<Get>(dlsym(opened, "drape_contact_library_1"));
  if (!get) return hindrance = file + " is of another version", nullptr;
  return library = get();
}

}  // namespace drape::body
