// SPDX-License-Identifier: MIT
//
// Words whose cells the tests of this room try.

#pragma once

#include "internode/word/symbol.h"

#include <cstddef>

namespace internode::tests {

inline constexpr std::size_t many_states = 1'000'000;

/// An open word with the ends clamped.
inline Word clamped_word(const Word& domain, std::size_t degree) {
    Word word(degree, zero_interval);
    word.insert(word.end(), domain.begin(), domain.end());
    word.insert(word.end(), degree, zero_interval);
    return word;
}

} // namespace internode::tests
