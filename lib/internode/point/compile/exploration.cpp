// SPDX-License-Identifier: MIT
//
// A breadth-first walk: the pieces round the cells of the start word are the first states, and each state in turn makes
// the pieces of its children, which are states too. It ends when all children are known, when a piece is too narrow to
// decide, or at a limit.

#include "internode/point/compile/exploration.h"

#include <cassert>
#include <map>

namespace internode {
namespace {

class Explorer {
public:
    Explorer(const PointSystem& system, std::size_t side, std::size_t most_states, ExactBudget& budget)
        : system_(system)
        , most_states_(most_states)
        , budget_(budget)
        , found_{side, KindTable(system), {}, {}} {}

    ExplorationResult run(const ExactWord& start) {
        for (std::size_t m = 0; m < start.size(); ++m)
            for (std::uint32_t slot = 0; slot < points_in(start[m]); ++slot)
                found_.starts.push_back(
                    number(piece_of_word(start, system_.grammar().ring, m, slot, found_.side, found_.kinds)));
        if (found_.starts.empty()) stop_ = ExactStop{{}, "has no points in its first word"};
        for (std::size_t i = 0; i < found_.states.size() && !stop_; ++i)
            if (!expand(i)) return {std::nullopt, std::move(stop_)};
        if (stop_) return {std::nullopt, std::move(stop_)};
        return {std::move(found_), std::nullopt};
    }

private:
    /// The children of a state. False: not decided, or a stop.
    bool expand(std::size_t i) {
        PieceChildren made = children_of(found_.states[i].piece, system_, found_.kinds, found_.side, budget_);
        stop_ = std::move(made.stop);
        if (stop_ && budget_.left == 0) stop_ = ExactStop{{}, "takes too long to compile"};
        if (!made.children) return false;
        for (const PieceChild& child : *made.children) {
            const std::uint32_t state = number(child.piece);
            found_.states[i].states.push_back(state);
        }
        found_.states[i].children = *std::move(made.children);
        return true;
    }

    std::uint32_t number(const CellPiece& piece) {
        const auto [place, is_new] = numbers_.try_emplace(piece, static_cast<std::uint32_t>(found_.states.size()));
        if (is_new) found_.states.push_back({piece, {}, {}});
        if (found_.states.size() > most_states_ && !stop_)
            stop_ = ExactStop{{},
                              "has too many states: letters, numbers and neighbours differ in more than " +
                                  std::to_string(most_states_) + " ways"};
        return place->second;
    }

    const PointSystem& system_;
    std::size_t most_states_;
    ExactBudget& budget_;
    Exploration found_;
    std::map<CellPiece, std::uint32_t> numbers_;
    std::optional<ExactStop> stop_;
};

} // namespace

ExplorationResult explore(const PointSystem& system, StartWord start, std::size_t side, std::size_t most_states,
                          ExactBudget& budget) {
    assert(side > 0);
    std::variant<ExactWord, ExactStop> word = shown_word(system, start, side);
    if (ExactStop* const stop = std::get_if<ExactStop>(&word)) return {std::nullopt, std::move(*stop)};
    return Explorer(system, side, most_states, budget).run(std::get<ExactWord>(word));
}

} // namespace internode
