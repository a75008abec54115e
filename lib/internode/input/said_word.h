// SPDX-License-Identifier: MIT
//
// The degree and the word of a polygon, or of one side of a grid, before the number of letters is settled. What the
// caller says counts over what the file says, and that over the axiom; where two of them speak both must agree. Not
// installed.

#pragma once

#include "internode/interval/interval_system.h"
#include "internode/io/polygon.h"

#include <optional>
#include <string>

namespace internode {

/// How a polygon and its options are called in what is said about them.
struct Wording {
    std::string option = "--word";       ///< the option that says a word
    std::string thing = "the polygon's"; ///< whose word the file's is
    std::string before{};                ///< how a sentence begins: "along u "
    std::string after{};                 ///< how a phrase ends: " along u"
    std::string degree_hint = "give -d, or \"degree\" in the polygon's JSON";
};

struct SaidWord {
    Axiom axiom;
    std::string origin; ///< "--word", "the polygon's word", "the axiom"
};

/// The degree that caller or file says, 1 … max_degree. \throw Refused where neither does, or both differ
[[nodiscard]] int settled_degree(const std::optional<int>& said, const InputPolygon& file, const Wording& wording);

/// A word of the caller's. \throw Refused with every error in it
[[nodiscard]] SaidWord callers_word(const std::string& text, const Alphabet& alphabet, const Wording& wording);

/// The word for `points` points. \throw Refused
[[nodiscard]] SaidWord settled_word(const IntervalSystem& system, const std::string& said, const InputPolygon& file,
                                    std::size_t points, const Wording& wording);

/// Whether the word has the form ( … ).
[[nodiscard]] bool says_circular(const SaidWord& word);

} // namespace internode
