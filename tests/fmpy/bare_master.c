/* A co-simulation master that needs nothing but libc: loads an FMU's library, does some steps, prints one
 * output.
 *
 *   bare_master LIBRARY GUID RESOURCES VALUE_REFERENCE STEPS LENGTH
 */
#include <dlfcn.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>

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

#define LOAD(function)                                                   \
  function##TYPE* function = (function##TYPE*)dlsym(library, #function); \
  if (!function) return fprintf(stderr, "no " #function "\n"), 1
#define CALL(call) \
  if ((call) != fmi2OK) return fprintf(stderr, "failed: " #call "\n"), 1

int main(int argc, char** argv) {
  if (argc != 7) return 2;
  void* library = dlopen(argv[1], RTLD_NOW | RTLD_LOCAL);
  if (!library) return fprintf(stderr, "%s\n", dlerror()), 1;
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
  const double length = atof(argv[6]);
  for (int k = 0; k < atoi(argv[5]); ++k) CALL(fmi2DoStep(cloth, k * length, length, fmi2True));
  const fmi2ValueReference reference = (fmi2ValueReference)atoi(argv[4]);
  fmi2Real value = 0;
  CALL(fmi2GetReal(cloth, &reference, 1, &value));
  printf("%.17g\n", value);
  CALL(fmi2Terminate(cloth));
  fmi2FreeInstance(cloth);
  return 0;
}
