/* Loads, instantiates, steps, frees and unloads an FMU in fresh folders, again and again.
 *
 *   rounds_master FOLDER_OF_THE_FMU LIBRARY_WITHIN GUID FOLDER_FOR_COPIES ROUNDS REFERENCE_OF_THREADS THREADS
 *
 * Prints how many mappings of the copies are left, how many bytes of the heap are in use, and which key of
 * thread-specific data is the next free one, after half of the rounds and after all.
 */
#include <dlfcn.h>
#include <limits.h>
#include <malloc.h>
#include <pthread.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "fmi2Functions.h"

static int mappings(const char* folder) {
  char line[4096];
  int count = 0;
  FILE* maps = fopen("/proc/self/maps", "r");
  while (fgets(line, sizeof line, maps)) count += strstr(line, folder) != NULL;
  fclose(maps);
  return count;
}

static unsigned free_key(void) {
  pthread_key_t key = 0;
  if (pthread_key_create(&key, NULL) != 0) return PTHREAD_KEYS_MAX;
  pthread_key_delete(key);
  return key;
}

#define LOAD(function) function##TYPE* function = (function##TYPE*)dlsym(library, #function)
#define CALL(call) \
  if ((call) != fmi2OK) return fprintf(stderr, "failed: " #call "\n"), 1

static int round_run(const char* copy, const char* within, const char* guid, fmi2ValueReference reference,
                     fmi2Integer threads) {
  char file[2048], resources[2048];
  snprintf(file, sizeof file, "%s/%s", copy, within);
  snprintf(resources, sizeof resources, "file://%s/resources", copy);
  void* library = dlopen(file, RTLD_NOW | RTLD_LOCAL);
  if (!library) return fprintf(stderr, "%s\n", dlerror()), 1;
  LOAD(fmi2Instantiate);
  LOAD(fmi2SetInteger);
  LOAD(fmi2SetupExperiment);
  LOAD(fmi2EnterInitializationMode);
  LOAD(fmi2ExitInitializationMode);
  LOAD(fmi2DoStep);
  LOAD(fmi2FreeInstance);
  const fmi2CallbackFunctions callbacks = {NULL, calloc, free, NULL, NULL};
  fmi2Component cloth =
      fmi2Instantiate("round", fmi2CoSimulation, guid, resources, &callbacks, fmi2False, fmi2False);
  if (!cloth) return fprintf(stderr, "cannot instantiate\n"), 1;
  CALL(fmi2SetInteger(cloth, &reference, 1, &threads));
  CALL(fmi2SetupExperiment(cloth, fmi2False, 0, 0, fmi2False, 0));
  CALL(fmi2EnterInitializationMode(cloth));
  CALL(fmi2ExitInitializationMode(cloth));
  CALL(fmi2DoStep(cloth, 0, 1e-3, fmi2True));
  if (mappings("drape_contact") == 0) return fprintf(stderr, "the contact library is not loaded\n"), 1;
  fmi2FreeInstance(cloth);
  return dlclose(library);
}

int main(int argc, char** argv) {
  if (argc != 8) return 2;
  const int rounds = atoi(argv[5]), threads = atoi(argv[7]);
  const fmi2ValueReference reference = (fmi2ValueReference)atoi(argv[6]);
  for (int k = 1; k <= rounds; ++k) {
    char copy[1024], command[4096];
    snprintf(copy, sizeof copy, "%s/%d", argv[4], k);
    snprintf(command, sizeof command, "cp -r '%s' '%s'", argv[1], copy);
    if (system(command) != 0 || round_run(copy, argv[2], argv[3], reference, threads) != 0) return 1;
    snprintf(command, sizeof command, "rm -r '%s'", copy);
    if (system(command) != 0) return 1;
    if (k == rounds / 2 || k == rounds)
      printf("%d %zu %u\n", mappings(argv[4]), mallinfo2().uordblks, free_key());
  }
  return 0;
}
