/* drape.h is C. */
#include "drape.h"

int header_is_c(void);
int header_is_c(void) {
  const drape_status status = DRAPE_OK;
  const drape_outputs outputs = {{0, 0, 0}, {0, 0, 0}, {0, 0, 0}, 0, 0, 0, 0, 0, 0, {0, 0, 0, 0, 0}, 0, NULL, 0, NULL, 0, NULL, NULL};
  return (int)status + outputs.probe_count;
}
