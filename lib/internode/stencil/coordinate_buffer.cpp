// SPDX-License-Identifier: MIT

#include "internode/stencil/coordinate_buffer.h"

#include <cstdlib>
#include <memory>
#include <new>

#if defined(__linux__)
#include <sys/mman.h>
#endif

namespace internode::detail {
namespace {

constexpr std::size_t large_page = std::size_t{2} << 20;
constexpr std::size_t cache_line = 64;

} // namespace

void* allocate_coordinates(std::size_t bytes) {
    const std::size_t alignment = bytes >= 2 * large_page ? large_page : cache_line;
    if (bytes > SIZE_MAX - alignment) throw std::bad_alloc();
    const std::size_t whole = (bytes / alignment + 1) * alignment;
    void* const memory = std::aligned_alloc(alignment, whole);
    if (memory == nullptr) throw std::bad_alloc();
    if (alignment == large_page) advise_large_pages(memory, whole);
    return memory;
}

void advise_large_pages([[maybe_unused]] void* memory, [[maybe_unused]] std::size_t bytes) {
#if defined(__linux__)
    // Only whole large pages can be had; advice, so memory that cannot follow it is as good.
    std::size_t room = bytes;
    if (std::align(large_page, large_page, memory, room) == nullptr) return;
    (void)madvise(memory, room / large_page * large_page, MADV_HUGEPAGE);
#endif
}

void FreeCoordinates::operator()(void* memory) const noexcept {
    std::free(memory);
}

} // namespace internode::detail
