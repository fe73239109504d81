// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// @file
/// Vectors whose storage starts at a cache line, on huge pages where they are large.

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <new>
#include <vector>

#include <sys/mman.h>

namespace packbed {

inline constexpr std::size_t huge_page = std::size_t{2} << 20U;

/// Gives the huge pages that lie wholly within [first, last) back to the system, for memory that will
/// not be read again: what stood there is lost. Returns where to go on the next time.
inline void* give_back(void* first, void* last) {
  const auto begin = (reinterpret_cast<std::uintptr_t>(first) + huge_page - 1) / huge_page;
  const auto end = reinterpret_cast<std::uintptr_t>(last) / huge_page;
  if (begin >= end) return first;
  void* const go_on =
      reinterpret_cast<void*>(end * huge_page);        // NOLINT(performance-no-int-to-ptr)
  madvise(reinterpret_cast<void*>(begin * huge_page),  // NOLINT(performance-no-int-to-ptr)
          (end - begin) * huge_page, MADV_DONTNEED);
  return go_on;
}

template <class T>
struct AlignedAllocator {
  using value_type = T;

  AlignedAllocator() = default;
  template <class U>
  AlignedAllocator(const AlignedAllocator<U>& /*other*/) {}  // NOLINT: an allocator converts

  T* allocate(std::size_t count) {
    constexpr std::size_t line = 64;
    const std::size_t bytes = count * sizeof(T);
    void* memory = nullptr;
    if (posix_memalign(&memory, bytes > huge_page ? huge_page : line, bytes) != 0)
      throw std::bad_alloc();
    if (bytes > huge_page) madvise(memory, bytes, MADV_HUGEPAGE);
    return static_cast<T*>(memory);
  }
  void deallocate(T* memory, std::size_t /*count*/) { std::free(memory); }
  bool operator==(const AlignedAllocator&) const = default;
};

template <class T>
using AlignedVector = std::vector<T, AlignedAllocator<T>>;

}  // namespace packbed
