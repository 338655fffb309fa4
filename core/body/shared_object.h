// A shared library that is opened at run time.
#pragma once
#include <string>

namespace drape::body {

struct SharedObject {
  void* handle = nullptr;
  std::string file;  // UTF-8
};

// Opens the file `name` of the folder of the library or program that contains this code. On failure the
// handle is null, and the reason is in `hindrance`.
SharedObject shared_object_beside(const char* name, std::string& hindrance);
void* shared_object_symbol(const SharedObject& object, const char* name);  // null: there is none
void shared_object_close(const SharedObject& object);

}  // namespace drape::body
