// SPDX-License-Identifier: MIT
//
// Refinement of a curve: the same curve over more and more intervals (Nivoliers et al. 2012, 2.3).
//
// A step rewrites the word and gathers every new point once from d+1 old ones (stencil/automaton.h): linear in the
// output. Closed: |σ(w)| points and the word σ(w), not rotated. Open: N' = |σ(domain)| + d points and the word
// (last d letters of σ(first d letters)) · σ(domain) · (first d letters of σ(last d letters)): the domain never
// shrinks.

#pragma once

#include "internode/curve/curve.h"
#include "internode/stencil/plan.h"

#include <cstdint>
#include <memory>
#include <vector>

namespace internode {

struct RefinementSize {
    std::uint64_t points = 0; ///< after all steps
    std::uint64_t bytes = 0;  ///< memory that the last step needs: points, letters and states before and after it
    bool exceeded = false;    ///< more than the cap: points and bytes are then lower bounds
};

/// The number of points after `steps` steps, without refining. Stops counting beyond `cap` points.
[[nodiscard]] RefinementSize refined_size(const Curve& curve, std::uint64_t steps, std::uint64_t cap);
/// The same for points of `dimension` coordinates over these knots.
[[nodiscard]] RefinementSize refined_size(const Knots& knots, std::size_t dimension, std::uint64_t steps,
                                          std::uint64_t cap);

/// A curve with the states of its cells, one step at a time.
class Refinement {
public:
    /// Derives the automaton of the curve's word. \throw TooManyStates beyond `state_limit`
    explicit Refinement(Curve curve, std::size_t state_limit = 1'000'000);
    [[nodiscard]] const Curve& curve() const { return curve_; }
    [[nodiscard]] const StencilAutomaton& automaton() const { return *automaton_; }
    /// The state of each cell of the current curve.
    [[nodiscard]] const std::vector<std::uint32_t>& states() const { return states_; }
    /// One step of subdivision.
    void step();
    /// Several steps >= 0 at once, the fast way (stencil/plan.h): within rounding what as many calls of step() give.
    /// \throw std::invalid_argument for fewer
    void advance(int steps, const ApplyOptions& options = {});

private:
    Curve curve_;
    std::shared_ptr<const StencilAutomaton> automaton_;
    std::vector<std::uint32_t> states_;
};

/// What refining curves, or anything else over these knots, by `steps` steps needs. Exceptions of RefinementPlan.
[[nodiscard]] RefinementPlan refinement_plan(const Knots& knots, int steps, const PlanOptions& options = {});

/// The curve after `steps` >= 0 steps, the fast way: within rounding what Refinement gives step by step.
/// \throw std::invalid_argument for fewer, TooManyStates
[[nodiscard]] Curve refine(const Curve& curve, int steps, const ApplyOptions& options = {});

/// The word after `steps` >= 0 steps, cut as above. \throw std::invalid_argument for fewer
[[nodiscard]] Word refined_word(const Morphism& rules, WordView word, int degree, Ends ends, int steps = 1);
[[nodiscard]] Word refined_word(const Knots& knots, int steps = 1);

/// The knots after `steps` >= 0 steps. \throw std::invalid_argument for fewer
[[nodiscard]] Knots refined_knots(const Knots& knots, int steps);

} // namespace internode
