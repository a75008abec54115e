// SPDX-License-Identifier: MIT
//
// The derivation of a point grammar on its way to a picture or a text: cycle by cycle, or step by step.

#pragma once

#include "cli/points/points.h"
#include "internode/io/file/sink.h"
#include "internode/point/strands.h"
#include "internode/report/picture/derivation_tree.h"
#include "internode/report/picture/levels_picture.h"

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace internode::cli {

/// Modules of the words of all parts together; saturates above `most`. None where a length is not known beforehand.
[[nodiscard]] std::optional<std::uint64_t> predicted_modules(std::span<const LoadedPoints> parts, std::uint64_t cycles,
                                                             std::uint64_t most);

/// \throw Failure (Refused) for words that are known to explode
void refuse_growth(std::span<const LoadedPoints> parts, std::uint64_t cycles);

/// --max-modules counts all parts: what the word of a part has, the next one may not have any more.
void take_modules(std::span<LoadedPoints> parts, std::size_t part, std::uint64_t modules);

/// The drawing of a word, interpreted.
[[nodiscard]] PointStrands drawn(const LoadedPoints& loaded, const ModuleWord& word);

/// The drawings of all parts after every cycle, the start included; of more than max_level_panels the first and the
/// last ones.
[[nodiscard]] std::vector<PictureLevel> all_levels(std::span<LoadedPoints> parts, std::uint64_t cycles);

/// A word as text, interpreted, a line.
[[nodiscard]] std::string word_text(const LoadedPoints& loaded, const ModuleWord& word);

/// The start, the word after every derivation step and after every interpretation pass, a line each. How many modules
/// the last derived word has.
std::uint64_t write_trace(Sink& sink, const LoadedPoints& loaded, std::uint64_t cycles);

/// Words and records of all steps. \throw Failure (Refused) for more modules than a tree may have
[[nodiscard]] DerivationTree all_steps(const LoadedPoints& loaded, std::uint64_t cycles);

} // namespace internode::cli
