// SPDX-License-Identifier: MIT
//
// Memory of the two regimes. Reused: large pages, touched before. Fresh: given while the clock runs, freed after it.

#pragma once

#include "bench/rows.h"

#include "internode/stencil/coordinate_buffer.h"
#include "internode/stencil/line_writer.h"

#include <algorithm>
#include <cstring>
#include <memory>

namespace internode::bench {

template<typename Scalar>
[[nodiscard]] std::shared_ptr<CoordinateBuffer<Scalar>> touched_buffer(std::size_t size) {
    auto buffer = std::make_shared<CoordinateBuffer<Scalar>>(size);
    std::ranges::fill(buffer->values(), Scalar{});
    return buffer;
}

/// A copy of `points` points into touched memory from touched memory.
[[nodiscard]] inline Contestant memcpy_of(std::size_t points) {
    auto from = touched_buffer<double>(points * dimension);
    auto to = touched_buffer<double>(points * dimension);
    const auto copy = [from, to] { std::memcpy(to->data(), from->data(), from->size() * sizeof(double)); };
    return {"memcpy", static_cast<double>(points), points, [copy] { return seconds_of(copy); }};
}

/// Writes every number, past the caches.
inline void fill_streamed(std::span<double> to) {
    LineStage<double> stage;
    LineWriter<double> writer(stage, to.data());
    for (std::size_t rest = to.size(); rest > 0;) {
        const std::size_t part = std::min(rest, LineWriter<double>::line);
        std::fill_n(writer.next(part), part, 1.0);
        writer.wrote(part);
        rest -= part;
    }
    writer.finish();
}

inline void fill_cached(std::span<double> to) {
    std::ranges::fill(to, 1.0);
}

using Fill = void(std::span<double>);

/// As many bytes as `points` points have, into touched memory.
[[nodiscard]] inline Contestant fill_of(const std::string& name, std::size_t points, Fill* fill) {
    auto to = touched_buffer<double>(points * dimension);
    return {name, static_cast<double>(points), points, [to, fill] { return seconds_of([&] { fill(to->values()); }); }};
}

/// Both, of which the better counts; `suffix` tells rows of several sizes apart.
inline void add_fills(std::vector<Contestant>& contestants, std::size_t points, const std::string& suffix = "") {
    contestants.push_back(fill_of("fill" + suffix, points, fill_cached));
    contestants.push_back(fill_of("fill-streamed" + suffix, points, fill_streamed));
}

} // namespace internode::bench
