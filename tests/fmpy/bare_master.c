/* A co-simulation master that needs nothing but libc: loads an FMU's library, does some steps, prints
 * outputs, a line each, in hexadecimal, and unloads the library. Also for Windows.
 *
 *   bare_master LIBRARY GUID RESOURCES FIRST_REFERENCE COUNT STEPS LENGTH
 */
#ifdef _WIN32
#define WIN32_LEAN_AND_MEAN
#include <windows.h>
/* after windows.h */
#include <shellapi.h>
#else
#include <dlfcn.h>
#endif
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "fmi2Functions.h"

static void print_log(fmi2ComponentEnvironment env, fmi2String name, fmi2Status status, fmi2String category,
                      fmi2String message, ...) {
  (void)env;
  va_list arguments;
  va_start(arguments, message);
  fprintf(stderr, "%s %d %s: ", name, status, category);
  vfprintf(stderr, message, arguments);
  fputc('\n', stderr);
  va_end(arguments);
}

#ifdef _WIN32
static HMODULE library_open(const char* utf8) {
  wchar_t file[1024];
  MultiByteToWideChar(CP_UTF8, 0, utf8, -1, file, 1024);
  HMODULE library = LoadLibraryW(file);
  if (!library) fprintf(stderr, "error %lu of Windows\n", GetLastError());
  return library;
}
#define library_symbol(library, name) (void*)GetProcAddress(library, name)
#define library_close(library) FreeLibrary(library)
static int library_is_loaded(const char* utf8) {
  wchar_t file[1024];
  MultiByteToWideChar(CP_UTF8, 0, utf8, -1, file, 1024);
  return GetModuleHandleW(file) != NULL;
}
#define CONTACT "drape_contact.dll"
#define SEPARATORS "\\/"
#else
static void* library_open(const char* file) {
  void* library = dlopen(file, RTLD_NOW | RTLD_LOCAL);
  if (!library) fprintf(stderr, "%s\n", dlerror());
  return library;
}
#define library_symbol(library, name) dlsym(library, name)
#define library_close(library) dlclose(library)
#define library_is_loaded(name) (dlopen(name, RTLD_NOW | RTLD_NOLOAD) != NULL)
#define CONTACT "libdrape_contact.so"
#define SEPARATORS "/"
#endif

/* Whether the contact library beside the FMU's library is loaded. */
static int contact_is_loaded(const char* library) {
  char file[2048];
  size_t folder = strlen(library);
  while (folder > 0 && !strchr(SEPARATORS, library[folder - 1])) --folder;
  snprintf(file, sizeof file, "%.*s%s", (int)folder, library, CONTACT);
  return library_is_loaded(file);
}

#define LOAD(function)                                                            \
  function##TYPE* function = (function##TYPE*)library_symbol(library, #function); \
  if (!function) return fprintf(stderr, "no " #function "\n"), 1
#define CALL(call) \
  if ((call) != fmi2OK) return fprintf(stderr, "failed: " #call "\n"), 1

static int run(int argc, char** argv) {
  if (argc != 8) return 2;
#ifdef _WIN32
  HMODULE library = library_open(argv[1]);
#else
  void* library = library_open(argv[1]);
#endif
  if (!library) return 1;
  LOAD(fmi2Instantiate);
  LOAD(fmi2SetupExperiment);
  LOAD(fmi2EnterInitializationMode);
  LOAD(fmi2ExitInitializationMode);
  LOAD(fmi2DoStep);
  LOAD(fmi2GetReal);
  LOAD(fmi2Terminate);
  LOAD(fmi2FreeInstance);

  const fmi2CallbackFunctions callbacks = {print_log, calloc, free, NULL, NULL};
  fmi2Component cloth =
      fmi2Instantiate("bare", fmi2CoSimulation, argv[2], argv[3], &callbacks, fmi2False, fmi2False);
  if (!cloth) return 1;
  CALL(fmi2SetupExperiment(cloth, fmi2False, 0, 0, fmi2False, 0));
  CALL(fmi2EnterInitializationMode(cloth));
  CALL(fmi2ExitInitializationMode(cloth));
  const double length = atof(argv[7]);
  for (int k = 0; k < atoi(argv[6]); ++k) CALL(fmi2DoStep(cloth, k * length, length, fmi2True));
  for (int k = 0; k < atoi(argv[5]); ++k) {
    const fmi2ValueReference reference = (fmi2ValueReference)(atoi(argv[4]) + k);
    fmi2Real value = 0;
    CALL(fmi2GetReal(cloth, &reference, 1, &value));
    printf("%a\n", value);
  }
  CALL(fmi2Terminate(cloth));
  fmi2FreeInstance(cloth);
  library_close(library);
  if (library_is_loaded(argv[1])) return fprintf(stderr, "the library is still loaded\n"), 1;
  if (contact_is_loaded(argv[1])) return fprintf(stderr, "the contact library is still loaded\n"), 1;
  return 0;
}

#ifdef _WIN32
int main(void) {  // the words of the line in UTF-8
  static char text[16][2048];
  char* words[16];
  int count = 0;
  wchar_t** wide = CommandLineToArgvW(GetCommandLineW(), &count);
  for (int k = 0; k < count && k < 16; ++k) {
    WideCharToMultiByte(CP_UTF8, 0, wide[k], -1, text[k], sizeof text[k], NULL, NULL);
    words[k] = text[k];
  }
  return run(count, words);
}
#else
int main(int argc, char** argv) { return run(argc, argv); }
#endif
