/* drape.h is C. */
#include "drape/drape.h"

#include <string.h>

/* NOLINTNEXTLINE(misc-use-internal-linkage): cloth_test.cpp calls it */
int header_is_c(void);
int header_is_c(void) {
  drape_outputs outputs;
  memset(&outputs, 0, sizeof outputs);
  return outputs.probe_count;
}
