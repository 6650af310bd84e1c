// SPDX-License-Identifier: BSD-3-Clause
#ifndef PARALLEL_ASPECTS_TEST_SUPPORT_COUNTED_ALLOCATIONS_H
#define PARALLEL_ASPECTS_TEST_SUPPORT_COUNTED_ALLOCATIONS_H

// For one source of a program: counts what malloc and its like are asked for, in `allocations`.
#include <atomic>
#include <cstdlib>

namespace {

std::atomic<long> allocations{0};

}  // namespace

// Everything that asks for memory comes to malloc and its like, operator new included.
extern "C" {

void* __libc_malloc(std::size_t size) noexcept;
void* __libc_calloc(std::size_t count, std::size_t size) noexcept;
void* __libc_realloc(void* memory, std::size_t size) noexcept;
void* __libc_memalign(std::size_t alignment, std::size_t size) noexcept;

void* malloc(std::size_t size) noexcept {
  ++allocations;
  return __libc_malloc(size);
}

void* calloc(std::size_t count, std::size_t size) noexcept {
  ++allocations;
  return __libc_calloc(count, size);
}

void* realloc(void* memory, std::size_t size) noexcept {
  ++allocations;
  return __libc_realloc(memory, size);
}

void* aligned_alloc(std::size_t alignment, std::size_t size) noexcept {
  ++allocations;
  return __libc_memalign(alignment, size);
}

}  // extern "C"

namespace {

const bool counting = true;

}  // namespace

#endif  // PARALLEL_ASPECTS_TEST_SUPPORT_COUNTED_ALLOCATIONS_H
