// SPDX-License-Identifier: MIT

#include "internode/stencil/step_tables.h"

#include <algorithm>
#include <functional>
#include <optional>
#include <utility>

namespace internode {

std::shared_ptr<const FusedStencils> StepTables::of(int steps, const std::vector<bool>& wanted) {
    const auto has_all = [&](const Made& one) {
        return one.stencils->steps == steps && std::ranges::equal(wanted, one.wanted, std::ranges::less_equal());
    };
    const auto found = std::ranges::find_if(made_, has_all);
    if (found != made_.end()) return found->stencils;
    std::optional<FusedStencils> stencils = fuser_.table(steps, wanted);
    if (!stencils) return nullptr;
    made_.push_back({wanted, std::make_shared<const FusedStencils>(*std::move(stencils))});
    return made_.back().stencils;
}

} // namespace internode
