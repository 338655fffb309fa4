#define WIN32_LEAN_AND_MEAN
#include <windows.h>

#include <filesystem>
#include <vector>

#include "body/shared_object.h"

namespace drape::body {
namespace {

std::filesystem::path folder_of_this_library() {
  HMODULE self = nullptr;
  constexpr DWORD kFlags =
      GET_MODULE_HANDLE_EX_FLAG_FROM_ADDRESS | GET_MODULE_HANDLE_EX_FLAG_UNCHANGED_REFCOUNT;
  if (!GetModuleHandleExW(kFlags, reinterpret_cast<LPCWSTR>(&folder_of_this_library), &self)) return {};
  for (std::vector<wchar_t> name(MAX_PATH);; name.resize(2 * name.size())) {
    const DWORD size = GetModuleFileNameW(self, name.data(), DWORD(name.size()));
    if (size == 0) return {};
    if (size < name.size()) return std::filesystem::path(std::wstring(name.data(), size)).parent_path();
  }
}

}  // namespace

SharedObject shared_object_beside(const char* name, std::string& hindrance) {
  const std::filesystem::path folder = folder_of_this_library();
  if (folder.empty())
    return hindrance = "the folder of this library is unknown: error " + std::to_string(GetLastError()) +
                       " of Windows",
           SharedObject{};
  const std::filesystem::path file = folder / name;
  const std::u8string text = file.u8string();
  SharedObject object{nullptr, std::string(text.begin(), text.end())};
  DWORD mode = 0;  // without it, Windows would show a message on a damaged file and wait for an answer
  const bool is_quiet = SetThreadErrorMode(SEM_FAILCRITICALERRORS, &mode);
  object.handle = LoadLibraryW(file.c_str());
  if (!object.handle)
    hindrance = object.file + ": cannot open shared object file: error " + std::to_string(GetLastError()) +
                " of Windows";
  if (is_quiet) SetThreadErrorMode(mode, nullptr);
  return object;
}

void* shared_object_symbol(const SharedObject& object, const char* name) {
  return reinterpret_cast<void*>(GetProcAddress(static_cast<HMODULE>(object.handle), name));
}

void shared_object_close(const SharedObject& object) { FreeLibrary(static_cast<HMODULE>(object.handle)); }

}  // namespace drape::body
