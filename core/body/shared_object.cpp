#include "body/shared_object.h"

#include <dlfcn.h>

#include <filesystem>

namespace drape::body {

SharedObject shared_object_beside(const char* name, std::string& hindrance) {
  Dl_info here{};
  if (!dladdr(reinterpret_cast<const void*>(&shared_object_beside), &here))
    return hindrance = "dladdr failed", SharedObject{};
  std::error_code error;
  const auto self = std::filesystem::canonical(here.dli_fname, error);
  SharedObject object{nullptr, (self.parent_path() / name).string()};
  object.handle = dlopen(object.file.c_str(), RTLD_NOW | RTLD_LOCAL);
  if (!object.handle) hindrance = dlerror();
  return object;
}

void* shared_object_symbol(const SharedObject& object, const char* name) {
  return dlsym(object.handle, name);
}

void shared_object_close(const SharedObject& object) { dlclose(object.handle); }

}  // namespace drape::body
