// SPDX-License-Identifier: MIT
//
// The tables of a plan by their steps: blocks of as many steps share one, where it has all the rows that they need.

#pragma once

#include "internode/stencil/fused_stencils.h"
#include "internode/stencil/plan.h"

#include <memory>
#include <vector>

namespace internode {

class StepTables {
public:
    /// The fuser must outlive the tables.
    explicit StepTables(const StepFuser& fuser)
        : fuser_(fuser) {}

    /// The table of so many steps with at least the wanted states; none where it would not be precise.
    std::shared_ptr<const FusedStencils> of(int steps, const std::vector<bool>& wanted);

private:
    struct Made {
        std::vector<bool> wanted;
        std::shared_ptr<const FusedStencils> stencils;
    };
    const StepFuser& fuser_;
    std::vector<Made> made_;
};

} // namespace internode
