// SPDX-License-Identifier: MIT

#include "internode/curve/knot_walk.h"

#include <cassert>

namespace internode {

namespace {

/// The first non-empty letter from `next` on; `next` is then the one after it.
std::size_t take(const Word& word, std::size_t& next) {
    assert(next < word.size());
    for (; word[next] == zero_interval; ++next) assert(next + 1 < word.size() && "letters are left");
    return next++;
}

} // namespace

KnotWalk::KnotWalk(const Knots& given, const Spans& spans, const Knots& fine)
    : given_(given)
    , spans_(spans)
    , fine_(fine)
    , fine_lengths_(long_lengths(fine, spans.exponent()))
    , counts_(given.system().alphabet().size())
    , next_(given.ends() == Ends::Open ? static_cast<std::size_t>(given.degree()) : 0)
    , next_fine_(next_) {
    assert(fine.step() >= given.step());
    assert(fine.degree() == given.degree() && fine.ends() == given.ends());
}

KnotPlace KnotWalk::next() {
    if (left_ == 0) {
        letter_ = take(given_.word(), next_);
        left_ = descendants(given_.word()[letter_]);
        offset_ = {};
    } else {
        offset_ = offset_ + fine_lengths_[to_index(fine_symbol_)];
    }
    --left_;
    fine_symbol_ = fine_.word()[take(fine_.word(), next_fine_)];
    assert((spans_[static_cast<std::ptrdiff_t>(letter_)] - offset_).hi > 0);
    return {letter_, offset_};
}

KnotPlace KnotWalk::end() const {
    assert(left_ == 0);
    return {letter_, spans_[static_cast<std::ptrdiff_t>(letter_)]};
}

std::uint64_t KnotWalk::descendants(Symbol symbol) {
    std::uint64_t& count = counts_[to_index(symbol)];
    if (count == 0)
        count = letter_counts(given_.system().rules(), Word{symbol},
                              static_cast<std::uint64_t>(fine_.step() - given_.step()))
                    .total;
    return count;
}

} // namespace internode
