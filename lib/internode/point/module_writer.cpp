// SPDX-License-Identifier: MIT

#include "internode/point/module_writer.h"

#include <algorithm>
#include <cmath>

namespace internode {

std::optional<std::size_t> ModuleWriter::write(const ModulePrograms& programs, std::span<const double> formals,
                                               ModuleWord& word) {
    evaluator_.clear();
    for (std::size_t k = 0; k < programs.arguments.size(); ++k) {
        const std::size_t before = evaluator_.values().size();
        evaluator_.push(programs.arguments[k], formals);
        const std::span<const double> value = evaluator_.values().subspan(before);
        if (!std::ranges::all_of(value, [](double one) { return std::isfinite(one); })) return k;
    }
    word.push_back(programs.letter, evaluator_.values());
    return std::nullopt;
}

} // namespace internode
