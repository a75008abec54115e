// SPDX-License-Identifier: MIT
//
// States and children come first, which takes no arithmetic in K. Then the exact work is counted against its limit, and
// only then are the rows made, from one piece of the curve for each state. Equal rows are kept once: a hash of their
// doubles finds them, their exact weights decide.

#include "internode/stencil/automaton.h"

#include "internode/spline/window.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cassert>
#include <limits>
#include <optional>
#include <string>

namespace internode {

/// Explores the states breadth first from the start, each once, and shares equal rows.
class AutomatonBuilder {
public:
    AutomatonBuilder(const IntervalSystem& system, int degree, const ExactLimits& limits)
        : system_(system)
        , limits_(limits)
        , limit_(std::min<std::size_t>(limits.entries, std::numeric_limits<std::uint32_t>::max())) {
        automaton_.degree_ = degree;
        automaton_.width_ = static_cast<std::size_t>(degree) + 1;
    }

    void add(const CellState& state) {
        if (state.window.size() != 2 * automaton_.width() - 3)
            throw std::invalid_argument("a window of degree d has 2d-1 letters");
        if (state.lead > automaton_.width() - 1)
            throw std::invalid_argument("a cell is at most d left of its interval");
        if (state.window[automaton_.width() - 2] == zero_interval)
            throw std::invalid_argument("the middle interval of a window is not empty");
        (void)number(state);
    }

    StencilAutomaton build(AutomatonRows rows) {
        // Expanding a state may add others behind it.
        std::size_t expanded = 0;
        while (expanded < automaton_.states_.size()) {
            automaton_.first_child_.push_back(automaton_.children_.size());
            expand(automaton_.states_[expanded++]);
        }
        automaton_.first_child_.push_back(automaton_.children_.size());
        assert(automaton_.first_child_.size() == automaton_.state_count() + 1);
        if (rows == AutomatonRows::None) return std::move(automaton_);
        // A piece for each state, a row for each child.
        begin_exact_work(
            exact_work(system_, automaton_.degree_, {automaton_.states_.size(), automaton_.children_.size()}), limits_);
        for (std::uint32_t state = 0; state < automaton_.state_count(); ++state) add_rows(state);
        return std::move(automaton_);
    }

private:
    /// By value: the states move while new ones are added.
    void expand(CellState state) {
        std::vector<Word> windows = child_windows(system_.rules(), state.window);
        assert(!windows.empty());
        if (state.lead > 0) windows.resize(1);
        for (Word& window : windows) automaton_.children_.push_back({number({std::move(window), state.lead}), 0});
    }

    void add_rows(std::uint32_t state) {
        const auto [window, lead] = automaton_.states_[state];
        const WindowPiece piece(system_, window);
        StencilAutomaton::Child* const children = automaton_.children_.data() + automaton_.first_child_[state];
        assert(automaton_.children(state).size() == (lead > 0 ? 1 : piece.child_count()));
        if (lead > 0) {
            children[0].row = shared(piece.leading(lead));
            return;
        }
        for (std::size_t c = 0; c < piece.child_count(); ++c) children[c].row = shared(piece.child(c));
    }

    std::uint32_t number(const CellState& state) {
        std::vector<std::uint32_t>& same_window = automaton_.index_[state.window];
        for (const std::uint32_t known : same_window)
            if (automaton_.states_[known].lead == state.lead) return known;
        if (automaton_.states_.size() >= limit_)
            throw TooManyStates("the stencil automaton has more than " + std::to_string(limit_) + " states");
        const auto added = static_cast<std::uint32_t>(automaton_.states_.size());
        same_window.push_back(added);
        automaton_.states_.push_back(state);
        automaton_.offset_.push_back(static_cast<std::int32_t>(state.lead) - automaton_.degree_);
        return added;
    }

    std::uint32_t shared(const std::vector<Number>& row) {
        assert(row.size() == automaton_.width());
        std::vector<double> rounded;
        std::uint64_t hash = 0;
        for (const Number& weight : row) {
            rounded.push_back(weight.to_double());
            hash = (std::rotl(hash, 7) ^ std::bit_cast<std::uint64_t>(rounded.back())) * 0x9e3779b97f4a7c15U;
        }
        std::vector<std::uint32_t>& candidates = rows_[hash];
        for (const std::uint32_t known : candidates)
            if (std::ranges::equal(automaton_.exact_weights(known), row)) return known;
        const auto added = static_cast<std::uint32_t>(automaton_.row_count());
        candidates.push_back(added);
        automaton_.exact_.insert(automaton_.exact_.end(), row.begin(), row.end());
        automaton_.weights_.insert(automaton_.weights_.end(), rounded.begin(), rounded.end());
        return added;
    }

    const IntervalSystem& system_;
    const ExactLimits& limits_;
    std::size_t limit_; ///< the most states that there may be
    StencilAutomaton automaton_;
    std::unordered_map<std::uint64_t, std::vector<std::uint32_t>>
        rows_; ///< indices of rows by the hash of their doubles
};

std::uint32_t StencilAutomaton::find(const CellState& state) const {
    const auto same_window = index_.find(state.window);
    if (same_window != index_.end())
        for (const std::uint32_t known : same_window->second)
            if (states_[known].lead == state.lead) return known;
    throw std::out_of_range("the stencil automaton does not have that state");
}

StencilAutomaton make_automaton(const IntervalSystem& system, int degree, const std::vector<CellState>& start,
                                const ExactLimits& limits, AutomatonRows rows) {
    if (degree < 1 || degree > 12) throw std::invalid_argument("a stencil automaton has a degree from 1 to 12");
    AutomatonBuilder builder(system, degree, limits);
    for (const CellState& state : start) builder.add(state);
    return builder.build(rows);
}

namespace {

/// How many empty letters stand from place i on, going round in a circular word; stops counting beyond d.
std::size_t zeros_from(WordView word, std::size_t i, std::size_t d) {
    assert(i < word.size());
    std::size_t zeros = 0;
    while (zeros <= d && word[i] == zero_interval) {
        ++zeros;
        if (++i == word.size()) i = 0;
    }
    return zeros;
}

/// The 2d-1 letters around place j, going round in a circular word.
class Window {
public:
    Window(WordView word, std::size_t j, std::size_t d)
        : word_(word)
        , first_((j + word.size() * d + 1 - d) % word.size()) // j + n·d is the same place, and no letter left of 0
        , size_(2 * d - 1) {}

    [[nodiscard]] Word letters() const {
        Word window;
        window.reserve(size_);
        for_each([&](Symbol symbol) { window.push_back(symbol); });
        return window;
    }
    [[nodiscard]] std::uint64_t hash() const {
        std::uint64_t hash = 0;
        for_each([&](Symbol symbol) { hash = (std::rotl(hash, 7) ^ to_index(symbol)) * 0x9e3779b97f4a7c15U; });
        return hash;
    }
    [[nodiscard]] bool is(const Word& window) const {
        std::size_t place = 0;
        bool same = window.size() == size_;
        for_each([&](Symbol symbol) { same = same && window[place++] == symbol; });
        return same;
    }

private:
    template<typename Visit>
    void for_each(Visit visit) const {
        std::size_t at = first_;
        for (std::size_t i = 0; i < size_; ++i) {
            visit(word_[at]);
            if (++at == word_.size()) at = 0;
        }
    }
    WordView word_;
    std::size_t first_;
    std::size_t size_;
};

/// Calls visit(k, lead) for every cell k of a word, from left to right: the cell's window is around place k + lead.
template<typename Visit>
void for_each_cell(WordView word, int degree, Ends ends, Visit visit) {
    if (degree < 1) throw std::invalid_argument("a degree is at least 1");
    const auto d = static_cast<std::size_t>(degree);
    const bool open = ends == Ends::Open;
    if (word.size() < (open ? 2 * d + 1 : 1)) throw std::invalid_argument("the word is too short for its degree");
    const std::size_t count = open ? word.size() - d : word.size();
    if (open && (word[d] == zero_interval || word[count - 1] == zero_interval))
        throw std::invalid_argument("the domain begins or ends with an empty interval");
    for (std::size_t k = 0; k < count; ++k) {
        const std::size_t lead = open && k < d ? d - k : zeros_from(word, k, d);
        if (lead > d) throw std::invalid_argument("more than d intervals in a row are empty");
        visit(k, static_cast<std::uint32_t>(lead));
    }
}

} // namespace

std::vector<CellState> cell_states(WordView word, int degree, Ends ends) {
    std::vector<CellState> states;
    states.reserve(word.size());
    for_each_cell(word, degree, ends, [&](std::size_t k, std::uint32_t lead) {
        states.push_back({Window(word, k + lead, static_cast<std::size_t>(degree)).letters(), lead});
    });
    return states;
}

namespace {

/// Gives numbers to the states of cells in the order in which they are met.
class CellNumbers {
public:
    CellNumbers(WordView word, int degree)
        : word_(word)
        , degree_(static_cast<std::size_t>(degree))
        , last_((degree_ - 1) % word.size()) {
        numbered_.cells.reserve(word.size());
    }

    /// The next cell.
    void add(std::size_t k, std::uint32_t lead) {
        const Symbol letter = word_[last_]; // of the window, where the lead is 0
        const bool follows = lead == 0 && k > 0;
        if (!follows) {
            state_ = number(Window(word_, k + lead, degree_), lead);
        } else if (const std::optional<std::uint32_t> known = followers_[state_].find(letter)) {
            state_ = *known;
        } else {
            const std::uint32_t state = number(Window(word_, k + lead, degree_), lead);
            followers_[state_].remember(letter, state);
            state_ = state;
        }
        numbered_.cells.push_back(state_);
        if (++last_ == word_.size()) last_ = 0;
    }

    [[nodiscard]] NumberedCells take() && { return std::move(numbered_); }

private:
    /// A window without its first letter and with one more is the next one, and a lead of 1 ends in the same window: so
    /// the state before and the last letter give the state. What came the last two times by different letters.
    class Followers {
    public:
        [[nodiscard]] std::optional<std::uint32_t> find(Symbol letter) const {
            for (const Follower& one : last_)
                if (one.known && one.letter == letter) return one.state;
            return std::nullopt;
        }
        void remember(Symbol letter, std::uint32_t state) { last_ = {Follower{true, letter, state}, last_[0]}; }

    private:
        struct Follower {
            bool known = false;
            Symbol letter{};
            std::uint32_t state = 0;
        };
        std::array<Follower, 2> last_;
    };

    std::uint32_t number(const Window& window, std::uint32_t lead) {
        std::vector<std::uint32_t>& candidates = same_hash_[window.hash() + lead];
        for (const std::uint32_t known : candidates)
            if (numbered_.states[known].lead == lead && window.is(numbered_.states[known].window)) return known;
        const auto added = static_cast<std::uint32_t>(numbered_.states.size());
        candidates.push_back(added);
        numbered_.states.push_back({window.letters(), lead});
        followers_.push_back({});
        return added;
    }

    WordView word_;
    std::size_t degree_;
    std::size_t last_;        ///< place of the last letter of the window around cell k
    std::uint32_t state_ = 0; ///< of the cell before
    NumberedCells numbered_;
    std::vector<Followers> followers_; ///< of each state
    std::unordered_map<std::uint64_t, std::vector<std::uint32_t>> same_hash_;
};

} // namespace

NumberedCells numbered_cells(WordView word, int degree, Ends ends) {
    if (word.empty() || degree < 1) throw std::invalid_argument("a degree is at least 1, and a word has letters");
    CellNumbers numbers(word, degree);
    for_each_cell(word, degree, ends, [&](std::size_t k, std::uint32_t lead) { numbers.add(k, lead); });
    return std::move(numbers).take();
}

} // namespace internode
