// SPDX-License-Identifier: BSD-3-Clause
// MPI's clock turned into processor time of the process: preloaded into LIGGGHTS by compare_liggghts.sh, so
// that what it prints as loop time does not count the time that others were on the core.
#include <time.h>

double MPI_Wtime(void) {
  struct timespec t;
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
  return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}
