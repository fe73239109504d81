// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// @file
/// What becomes of freed memory.

#include <malloc.h>

namespace packbed {

/// Lets memory of 4 MiB and more come from the system and go back there when it is freed, and the end of the
/// heap too. glibc would keep up to 32 MiB each for later; a library that PETSc brings in (SuperLU_DIST) even
/// asks it, as it is loaded, to keep everything. Call it first in main.
inline void give_back_freed_memory() {
  mallopt(M_MMAP_MAX, 65536);
  mallopt(M_MMAP_THRESHOLD, 4 << 20);
  mallopt(M_TRIM_THRESHOLD, 4 << 20);
}

}  // namespace packbed
