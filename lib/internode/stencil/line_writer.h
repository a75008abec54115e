// SPDX-License-Identifier: MIT
//
// A run of numbers written past the caches in whole lines.
//
// Numbers are collected in a stage that stays in the first cache and stands to its lines as the output does to those
// of memory. Whole lines leave it by stores that do not read what they replace, some lines behind what is being
// written, so that the processor does both at once. The ends of the run, which share their lines with others, leave by
// ordinary stores. Other threads see streamed bytes after finish().
//
// Every member is inlined into the kernels, each of which is compiled for its own instruction set: a copy that the
// linker could share would bring the instructions of one to a machine of the other.

#pragma once

#include <cassert>
#include <cstddef>
#include <cstdint>
#include <cstring>

#if defined(__SSE2__)
#include <immintrin.h>
#endif

#define INTERNODE_INLINE [[gnu::always_inline]] inline

namespace internode {

template<typename Scalar>
struct LineStage {
    static constexpr std::size_t line = 64 / sizeof(Scalar);
    static constexpr std::size_t capacity = 4096 / sizeof(Scalar);
    alignas(64) Scalar numbers[capacity + line]; ///< and what a vector spills over
};

/// A few registers: a kernel works on a copy and gives it back.
template<typename Scalar>
class LineWriter {
public:
    static constexpr std::size_t line = LineStage<Scalar>::line;
    static constexpr std::size_t capacity = LineStage<Scalar>::capacity;

    /// Writes from `out` on, which is aligned for Scalar; the stage is this writer's until it has finished.
    INTERNODE_INLINE LineWriter(LineStage<Scalar>& stage, Scalar* out)
        : stage_(stage.numbers)
        , out_(out)
        , used_(reinterpret_cast<std::uintptr_t>(out) / sizeof(Scalar) % line)
        , sent_(used_) {
        assert(reinterpret_cast<std::uintptr_t>(out) % sizeof(Scalar) == 0);
    }

    /// Where the next numbers go: `count` <= capacity - line of them, and a vector may spill over behind.
    [[nodiscard]] INTERNODE_INLINE Scalar* next(std::size_t count) {
        assert(count <= capacity - line);
        if (used_ + count > capacity) start_over();
        return stage_ + used_;
    }
    /// So many numbers have been put there: lines that were completed a while ago leave.
    INTERNODE_INLINE void wrote(std::size_t count) {
        used_ += count;
        constexpr std::size_t lag = 8 * line;
        if (used_ > lag) send_lines(used_ - lag);
    }
    /// The rest; nothing may be written after it.
    INTERNODE_INLINE void finish() {
        send_lines(used_);
        std::memcpy(out_, stage_ + sent_, (used_ - sent_) * sizeof(Scalar));
#if defined(__SSE2__)
        _mm_sfence();
#endif
    }

private:
    /// The lines that are whole before the place `end` of the stage; a first one that is not ours alone as it is.
    INTERNODE_INLINE void send_lines(std::size_t end) {
        const std::size_t whole = end / line * line;
        if (sent_ >= whole) return;
        const std::size_t head = sent_ % line;
        if (head > 0) {
            std::memcpy(out_, stage_ + sent_, (line - head) * sizeof(Scalar));
            out_ += line - head;
            sent_ += line - head;
        }
        for (; sent_ != whole; sent_ += line, out_ += line) stream(stage_ + sent_, out_);
    }

    /// Whole lines leave, and the numbers of the last one go to the front.
    INTERNODE_INLINE void start_over() {
        send_lines(used_);
        const std::size_t first = used_ / line * line;
        std::memcpy(stage_, stage_ + first, (used_ - first) * sizeof(Scalar));
        used_ -= first;
        sent_ -= first;
    }

    INTERNODE_INLINE static void stream(const Scalar* from, Scalar* to) {
        assert(reinterpret_cast<std::uintptr_t>(to) % 64 == 0);
#if defined(__AVX__)
        const auto* const pieces = reinterpret_cast<const __m256i*>(from);
        auto* const target = reinterpret_cast<__m256i*>(to);
        _mm256_stream_si256(target, _mm256_load_si256(pieces));
        _mm256_stream_si256(target + 1, _mm256_load_si256(pieces + 1));
#elif defined(__SSE2__)
        const auto* const pieces = reinterpret_cast<const __m128i*>(from);
        auto* const target = reinterpret_cast<__m128i*>(to);
        for (int piece = 0; piece < 4; ++piece) _mm_stream_si128(target + piece, _mm_load_si128(pieces + piece));
#else
        std::memcpy(to, from, 64);
#endif
    }

    Scalar* stage_;
    Scalar* out_;      ///< where the number at sent_ goes
    std::size_t used_; ///< numbers in the stage, with those of others in the first line
    std::size_t sent_; ///< how many of them have left
};

} // namespace internode
