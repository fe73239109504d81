// SPDX-License-Identifier: BSD-3-Clause
#pragma once

/// @file
/// Vectors whose storage starts at a cache line, on huge pages where they are large.

#include <cstddef>
#include <cstdlib>
#include <new>
#include <vector>

#include <sys/mman.h>

namespace packbed {

template <class T>
struct AlignedAllocator {
  using value_type = T;

  AlignedAllocator() = default;
  template <class U>
  AlignedAllocator(const AlignedAllocator<U>& /*other*/) {}  // NOLINT: an allocator converts

  T* allocate(std::size_t count) {
    constexpr std::size_t line = 64;
    constexpr std::size_t page = std::size_t{2} << 20U;
    const std::size_t bytes = count * sizeof(T);
    void* memory = nullptr;
    if (posix_memalign(&memory, bytes > page ? page : line, bytes) != 0) throw std::bad_alloc();
    if (bytes > page) madvise(memory, bytes, MADV_HUGEPAGE);
    return static_cast<T*>(memory);
  }
  void deallocate(T* memory, std::size_t /*count*/) { std::free(memory); }
  bool operator==(const AlignedAllocator&) const = default;
};

template <class T>
using AlignedVector = std::vector<T, AlignedAllocator<T>>;

}  // namespace packbed
