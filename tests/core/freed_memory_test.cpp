// SPDX-License-Identifier: BSD-3-Clause
#include "core/freed_memory.hpp"

#include <vector>

#include <gtest/gtest.h>

namespace packbed {
namespace {

constexpr std::size_t large = std::size_t{64} << 20U;

std::size_t mapped() { return mallinfo2().hblkhd; }

// SuperLU_DIST, which PETSc brings in, asks for the opposite as it is loaded.
TEST(FreedMemory, GoesBackEvenWhereALibraryWantedToKeepIt) {
#ifdef __SANITIZE_ADDRESS__
  GTEST_SKIP() << "memory comes from the sanitizer";
#endif
  mallopt(M_MMAP_MAX, 0);
  mallopt(M_TRIM_THRESHOLD, -1);

  give_back_freed_memory();

  const auto before = mapped();
  {
    const std::vector<char> block(large, 1);
    EXPECT_GE(mapped(), before + large);
  }
  EXPECT_EQ(mapped(), before);
}

TEST(FreedMemory, OfTheEndOfTheHeapGoesBackToo) {
#ifdef __SANITIZE_ADDRESS__
  GTEST_SKIP() << "memory comes from the sanitizer";
#endif
  mallopt(M_TRIM_THRESHOLD, -1);
  give_back_freed_memory();
  const auto before = mallinfo2().arena;
  {
    std::vector<std::vector<char>> blocks;
    blocks.reserve(64);  // below the blocks, not between them
    for (int k = 0; k < 64; ++k) blocks.emplace_back(std::size_t{1} << 20U, 1);
    EXPECT_GT(mallinfo2().arena, before + (std::size_t{32} << 20U));
  }
  EXPECT_LT(mallinfo2().arena, before + (std::size_t{16} << 20U));
}

}  // namespace
}  // namespace packbed
