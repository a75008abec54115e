// SPDX-License-Identifier: MIT
//
// The length of a word before it is derived: what each letter becomes, counted letter by letter.

#pragma once

#include "internode/point/module_word.h"
#include "internode/point/point_system.h"

#include <cstdint>
#include <optional>

namespace internode {

/// The length of the word after so many cycles, saturating at `limit` + 1, by the growth matrix. None when the rules of
/// a letter differ in the letters of their successors, have strict predecessors of several modules, or may fail to
/// match without being the identity. In a ring of one letter contexts never fail. Cost: at most 2 10^7 letters counted;
/// none beyond.
[[nodiscard]] std::optional<std::uint64_t> predicted_length(const PointSystem& system, const ModuleWord& word,
                                                            std::uint64_t cycles, std::uint64_t limit);

} // namespace internode
