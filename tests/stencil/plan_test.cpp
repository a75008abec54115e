// SPDX-License-Identifier: MIT
//
// Plans of automata whose cells die out: no cell is a word, too.

#include "internode/stencil/plan.h"

#include "internode/stencil/cell_rules.h"
#include "internode/stencil/fused_stencils.h"

#include <gmock/gmock.h>

namespace internode {
namespace {

/// The table of one step, written out.
FusedStencils one_step(const CellAutomaton& automaton) {
    FusedStencils table;
    table.width = automaton.width();
    table.first_row = {0};
    for (std::uint32_t state = 0; state < automaton.state_count(); ++state) {
        table.offset.push_back(static_cast<std::int32_t>(automaton.offset(state)));
        for (const CellAutomaton::Child& child : automaton.children(state)) {
            const auto weights = automaton.weights(child.row);
            table.weights.insert(table.weights.end(), weights.begin(), weights.end());
            table.descendants.push_back(child.state);
        }
        table.first_row.push_back(static_cast<std::uint32_t>(table.row_count()));
    }
    return table;
}

TEST(Plan, GoesOnWhenAllCellsHaveDied) {
    const Number half = Rational(1, 2);
    const CellRules rules{{}, {{0, {0, {half, half}}}}}; // state 1 has one child of state 0, which has none
    const auto automaton = std::make_shared<const CellAutomaton>(make_cell_automaton(rules));
    const StepFuser fuser{[&](int, const std::vector<bool>&) { return std::optional(one_step(*automaton)); }};
    PlanOptions options;
    options.most_fused_steps = 1;
    for (const int steps : {1, 2, 3, 5}) {
        const RefinementPlan plan(automaton, {1, 1, 1}, steps, fuser, options);
        EXPECT_THAT(plan.sizes(), testing::SizeIs(static_cast<std::size_t>(steps) + 1));
        std::vector<double> out(plan.output_size());
        plan.apply<double>(std::vector<double>{1, 2, 4}, 1, out);
        EXPECT_EQ(out, steps == 1 ? (std::vector<double>{1.5, 3, 2.5}) : std::vector<double>{});
        EXPECT_EQ(plan.final_cells(), std::vector<std::uint32_t>(out.size(), 0));
    }
}

TEST(Plan, SharesTheTablesOfEqualStepsWhereTheyHaveAllRows) {
    const CellRow same{0, {1}};
    const CellRules rules{{{0, same}, {0, same}},
                          {{0, same}}}; // state 0 has itself twice, state 1 is met at first only
    const auto automaton = std::make_shared<const CellAutomaton>(make_cell_automaton(rules));
    std::vector<std::vector<bool>> asked;
    const StepFuser fuser{[&](int steps, const std::vector<bool>& wanted) {
        EXPECT_EQ(steps, 1);
        asked.push_back(wanted);
        return std::optional(one_step(*automaton));
    }};
    PlanOptions options;
    options.most_fused_steps = 1;
    const RefinementPlan plan(automaton, {1, 0, 1}, 4, fuser, options);
    EXPECT_THAT(plan.blocks(), testing::ElementsAre(1, 1, 1, 1));
    EXPECT_THAT(asked, testing::ElementsAre(std::vector{true, false}, std::vector{true, true}));
    std::vector<double> out(plan.output_size());
    plan.apply<double>(std::vector<double>{1, 2, 4}, 1, out);
    EXPECT_EQ(out.size(), 8U + 16 + 8);
    EXPECT_EQ(out.front(), 1);
    EXPECT_EQ(out[8], 2);
    EXPECT_EQ(out.back(), 4);
}

} // namespace
} // namespace internode
