// SPDX-License-Identifier: MIT
//
// Derivation trees of grammars with an axiom.

#pragma once

#include "internode/point/interpreter.h"
#include "internode/point/start_word.h"
#include "internode/report/picture/derivation_tree.h"

#include <cstddef>

namespace internode::testing_report {

/// The tree of so many steps from the axiom.
inline DerivationTree tree_of(const PointSystem& system, std::size_t steps) {
    DerivationTree tree{.title = "t", .generator = {"0.1.0", "internode"}};
    tree.words.push_back(axiom_word(system));
    tree.row_names.emplace_back("axiom");
    for (std::size_t step = 0; step < steps; ++step) {
        const Derivation next = derive_step(system, tree.words.back(), step, {}, tree.steps.emplace_back());
        tree.words.push_back(next.word);
        tree.row_names.emplace_back("step");
    }
    return tree;
}

} // namespace internode::testing_report
