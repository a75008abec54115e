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
#include <vector>

namespace internode::cli {

/// \throw Failure (Refused) for a word that is known to explode
void refuse_growth(const LoadedPoints& loaded, std::uint64_t cycles);

/// The drawing of a word, interpreted.
[[nodiscard]] PointStrands drawn(const LoadedPoints& loaded, const ModuleWord& word);

/// The drawings after every cycle, the start included; of more than max_level_panels the first and the last ones.
[[nodiscard]] std::vector<PictureLevel> all_levels(const LoadedPoints& loaded, std::uint64_t cycles);

/// A word as text, interpreted, a line.
void write_word(Sink& sink, const LoadedPoints& loaded, const ModuleWord& word);

/// The start, the word after every derivation step and after every interpretation pass, a line each.
void write_trace(Sink& sink, const LoadedPoints& loaded, std::uint64_t cycles);

/// Words and records of all steps. \throw Failure (Refused) for more modules than a tree may have
[[nodiscard]] DerivationTree all_steps(const LoadedPoints& loaded, std::uint64_t cycles);

} // namespace internode::cli
