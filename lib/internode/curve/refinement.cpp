// SPDX-License-Identifier: MIT
//
// refine() and Refinement::advance() hand all steps to a RefinementPlan (stencil/plan.h). Refinement::step() is the
// slow and obvious way, one row of the automaton for each new point: what the fast way is tested against. Sizes come
// from counts of letters, without a word.

#include "internode/curve/refinement.h"

#include "internode/curve/gather.h"
#include "internode/stencil/coordinate_buffer.h"

#include <algorithm>
#include <cassert>
#include <stdexcept>

namespace internode {

namespace {

/// What one point, with its letter and its state, occupies.
std::uint64_t bytes_per_point(std::size_t dimension) {
    return dimension * sizeof(double) + sizeof(Symbol) + sizeof(std::uint32_t);
}

void append(Word& word, WordView letters) {
    word.insert(word.end(), letters.begin(), letters.end());
}

/// The number of cells after a step from these states.
std::size_t cells_after(const StencilAutomaton& automaton, const std::vector<std::uint32_t>& states) {
    std::size_t cells = 0;
    for (const std::uint32_t state : states) cells += automaton.children(state).size();
    return cells;
}

} // namespace

RefinementSize refined_size(const Knots& knots, std::size_t dimension, std::uint64_t steps, std::uint64_t cap) {
    // An open curve has d points more than its domain has letters.
    const std::uint64_t extra = knots.ends() == Ends::Open ? static_cast<std::uint64_t>(knots.degree()) : 0;
    const std::uint64_t room = std::min(cap, std::uint64_t{1} << 61) - std::min(cap, extra);
    const auto points_after = [&](std::uint64_t count) {
        return letter_counts(knots.system().rules(), knots.domain(), count, room);
    };
    const LetterCounts last = points_after(steps);
    RefinementSize size;
    size.points = last.total + extra;
    size.exceeded = last.saturated || size.points > cap;
    if (size.exceeded) size.points = std::max(size.points, cap + 1);
    const std::uint64_t before = steps == 0 ? 0 : points_after(steps - 1).total + extra;
    const std::uint64_t each = bytes_per_point(dimension);
    const std::uint64_t most = ~std::uint64_t{0} / each;
    size.bytes = size.points + before > most ? ~std::uint64_t{0} : (size.points + before) * each;
    return size;
}

RefinementSize refined_size(const Curve& curve, std::uint64_t steps, std::uint64_t cap) {
    return refined_size(curve.knots(), curve.dimension(), steps, cap);
}

Word refined_word(const Morphism& rules, WordView word, int degree, Ends ends, int steps) {
    if (ends == Ends::Circular) return rewritten(rules, word, steps);
    const auto d = static_cast<std::size_t>(degree);
    if (degree < 1 || word.size() < 2 * d + 1)
        throw std::invalid_argument("an open word needs a domain and `degree` letters at each end");
    Word before(word.begin(), word.begin() + degree);
    Word after(word.end() - degree, word.end());
    for (int step = 0; step < steps; ++step) {
        before = rules(before);
        before.erase(before.begin(), before.end() - degree);
        after = rules(after);
        after.resize(d);
    }
    const Word domain = rewritten(rules, word.subspan(d, word.size() - 2 * d), steps);
    Word result;
    result.reserve(domain.size() + 2 * d);
    append(result, before);
    append(result, domain);
    append(result, after);
    return result;
}

Word refined_word(const Knots& knots, int steps) {
    return refined_word(knots.system().rules(), knots.word(), knots.degree(), knots.ends(), steps);
}

Knots refined_knots(const Knots& knots, int steps) {
    if (steps < 0) throw std::invalid_argument("a negative number of steps");
    Knots fine = knots;
    fine.word_ = refined_word(knots, steps);
    fine.step_ += steps;
    return fine;
}

Refinement::Refinement(Curve curve, std::size_t state_limit)
    : curve_(std::move(curve)) {
    NumberedCells start = numbered_cells(curve_.word(), curve_.degree(), curve_.ends());
    automaton_ = std::make_shared<const StencilAutomaton>(
        make_automaton(curve_.system(), curve_.degree(), start.states, state_limit));
    states_ = std::move(start.cells);
    assert(states_.size() == curve_.size());
}

void Refinement::step() {
    const StencilAutomaton& automaton = *automaton_;
    const std::size_t dimension = curve_.dimension();
    const std::size_t count = cells_after(automaton, states_);
    std::vector<double> points(count * dimension);
    std::vector<std::uint32_t> states(count);
    Parents parents(curve_.points_, dimension, automaton.width());
    std::size_t next = 0;
    for (std::size_t cell = 0; cell < states_.size(); ++cell) {
        const std::uint32_t state = states_[cell];
        const double* rows = parents.rows(static_cast<std::ptrdiff_t>(cell) + automaton.offset(state));
        for (const StencilAutomaton::Child& child : automaton.children(state)) {
            combine(automaton.weights(child.row), rows, dimension, points.data() + next * dimension);
            states[next++] = child.state;
        }
    }
    assert(next == count);
    curve_.points_ = std::move(points);
    states_ = std::move(states);
    curve_.knots_ = refined_knots(curve_.knots_, 1);
    assert(curve_.points_.size() == curve_.knots_.size() * dimension);
}

void Refinement::advance(int steps, const ApplyOptions& options) {
    const RefinementPlan plan(curve_.system(), automaton_, states_, steps);
    std::vector<double> points = in_large_pages<double>(plan.output_size() * curve_.dimension());
    plan.apply<double>(curve_.points_, curve_.dimension(), points, options);
    curve_.points_ = std::move(points);
    states_ = plan.final_cells();
    curve_.knots_ = refined_knots(curve_.knots_, steps);
    assert(states_.size() == curve_.knots_.size());
}

RefinementPlan refinement_plan(const Knots& knots, int steps, const PlanOptions& options) {
    return {knots.system(), knots.degree(), knots.word(), knots.ends(), steps, options};
}

Curve refine(const Curve& curve, int steps, const ApplyOptions& options) {
    const RefinementPlan plan = refinement_plan(curve.knots(), steps);
    std::vector<double> points = in_large_pages<double>(plan.output_size() * curve.dimension());
    plan.apply<double>(curve.points(), curve.dimension(), points, options);
    return {refined_knots(curve.knots(), steps), curve.dimension(), std::move(points)};
}

} // namespace internode
