// SPDX-License-Identifier: MIT
//
// Modules computed from their programs and put at the end of a word; a parameter is finite or is not stored.

#pragma once

#include "internode/expression/program_run.h"
#include "internode/point/module_word.h"
#include "internode/point/rule_programs.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

namespace internode {

class ModuleWriter {
public:
    /// `functions` of the programs; must outlive the writer.
    explicit ModuleWriter(std::span<const Program> functions)
        : evaluator_(functions) {}

    /// Puts the module at the end of the word; or the number of the first argument that is not finite, and the word as
    /// it was. `formals`: the doubles of all formals.
    [[nodiscard]] std::optional<std::size_t> write(const ModulePrograms& programs, std::span<const double> formals,
                                                   ModuleWord& word);
    /// The value of a condition or a weight.
    [[nodiscard]] double number(const Program& program, std::span<const double> formals) {
        return evaluator_.number(program, formals);
    }
    /// Operations so far.
    [[nodiscard]] std::uint64_t work() const { return evaluator_.work(); }

private:
    Evaluator evaluator_;
};

} // namespace internode
