#include "body/shared_object.h"

#include <dlfcn.h>
#include <link.h>

#include <cstring>
#include <filesystem>
#include <fstream>

namespace drape::body {
namespace {

template <class T>
bool read(std::ifstream& stream, std::uint64_t at, T& to) {
  return bool(stream.seekg(std::streamoff(at)).read(reinterpret_cast<char*>(&to), sizeof to));
}

// Whether a part that the loader would map is missing at the end of the file. The loader does not look, and
// the process dies when it touches what is not there. Of files that are no library, dlopen tells.
bool is_cut_off(const std::filesystem::path& file) {
  std::error_code error;
  const std::uintmax_t size = std::filesystem::file_size(file, error);
  std::ifstream stream(file, std::ios::binary);
  ElfW(Ehdr) head;
  if (error || !read(stream, 0, head) || std::memcmp(head.e_ident, ELFMAG, SELFMAG) != 0) return false;
  for (std::uint64_t k = 0; k < head.e_phnum; ++k) {
    ElfW(Phdr) part;
    if (!read(stream, head.e_phoff + k * sizeof part, part)) return true;
    if (part.p_type == PT_LOAD && (part.p_offset > size || part.p_filesz > size - part.p_offset)) return true;
  }
  return false;
}

}  // namespace

SharedObject shared_object_beside(const char* name, std::string& hindrance) {
  Dl_info here{};
  if (!dladdr(reinterpret_cast<const void*>(&shared_object_beside), &here))
    return hindrance = "dladdr failed", SharedObject{};
  std::error_code error;
  const auto self = std::filesystem::canonical(here.dli_fname, error);
  if (error || !self.has_parent_path())
    return hindrance = std::string(here.dli_fname) + ": its folder cannot be found: " + error.message(),
           SharedObject{};
  SharedObject object{nullptr, (self.parent_path() / name).string()};
  if (is_cut_off(object.file)) return hindrance = object.file + ": the file is cut off", object;
  object.handle = dlopen(object.file.c_str(), RTLD_NOW | RTLD_LOCAL);
  if (!object.handle) hindrance = dlerror();
  return object;
}

void* shared_object_symbol(const SharedObject& object, const char* name) {
  return dlsym(object.handle, name);
}

void shared_object_close(const SharedObject& object) { dlclose(object.handle); }

}  // namespace drape::body
