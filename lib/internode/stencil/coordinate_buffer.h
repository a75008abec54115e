// SPDX-License-Identifier: MIT
//
// Memory for coordinates that are about to be written: not initialised, and in large pages where the system has them.
//
// A fresh page of 4 KiB costs more to be given than its points to be computed; a large buffer therefore starts at a
// multiple of 2 MiB and asks for pages of that size. On other systems the request is left out.

#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <vector>

namespace internode {

namespace detail {
/// \throw std::bad_alloc
[[nodiscard]] void* allocate_coordinates(std::size_t bytes);
/// Asks for large pages for memory that has not been touched, where the system has them and it is large enough.
void advise_large_pages(void* memory, std::size_t bytes);
struct FreeCoordinates {
    void operator()(void* memory) const noexcept;
};
} // namespace detail

template<typename Scalar>
class CoordinateBuffer {
public:
    CoordinateBuffer() = default;
    /// \throw std::bad_alloc
    explicit CoordinateBuffer(std::size_t size)
        : memory_(static_cast<Scalar*>(detail::allocate_coordinates(size * sizeof(Scalar))))
        , size_(size) {}

    [[nodiscard]] std::size_t size() const { return size_; }
    [[nodiscard]] Scalar* data() { return memory_.get(); }
    [[nodiscard]] const Scalar* data() const { return memory_.get(); }
    [[nodiscard]] std::span<Scalar> values() { return {memory_.get(), size_}; }
    [[nodiscard]] std::span<const Scalar> values() const { return {memory_.get(), size_}; }

private:
    std::unique_ptr<Scalar[], detail::FreeCoordinates> memory_;
    std::size_t size_ = 0;
};

/// So many zeros that are about to be written over.
template<typename Scalar>
[[nodiscard]] std::vector<Scalar> in_large_pages(std::size_t size) {
    std::vector<Scalar> values;
    values.reserve(size);
    detail::advise_large_pages(values.data(), size * sizeof(Scalar));
    values.resize(size);
    return values;
}

} // namespace internode
