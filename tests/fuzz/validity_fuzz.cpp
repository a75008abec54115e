// SPDX-License-Identifier: MIT
//
// Any bytes as a small grammar: the decision gives reasons or a system, the system satisfies ρ a = M a with a > 0. The
// rows of a window sum to 1, those of its children without a negative weight.
//
// Bytes: degree, number of symbols, then per symbol a length and its letters; what is left is the window.

#include "internode/interval/validity.h"
#include "internode/spline/window.h"
#include "tests/fuzz/require.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>

using namespace internode;

namespace {

using internode::fuzz::require;

/// Reads numbers from bytes; zeros after the end.
class Bytes {
public:
    explicit Bytes(std::span<const std::uint8_t> bytes)
        : bytes_(bytes) {}
    /// 0 … bound - 1.
    std::size_t below(std::size_t bound) {
        if (bytes_.empty()) return 0;
        const std::size_t value = bytes_.front() % bound;
        bytes_ = bytes_.subspan(1);
        return value;
    }

private:
    std::span<const std::uint8_t> bytes_;
};

IntervalGrammar read_grammar(Bytes& bytes) {
    IntervalGrammar grammar;
    const std::size_t n = 1 + bytes.below(5);
    for (std::size_t i = 0; i < n; ++i) grammar.alphabet.add(std::string(1, static_cast<char>('a' + i)));
    std::vector<Word> images(n);
    for (Word& image : images) {
        image.resize(1 + bytes.below(5));
        for (Symbol& letter : image) letter = to_symbol(bytes.below(n));
    }
    grammar.rules = Morphism(std::move(images));
    return grammar;
}

void check_lengths(const IntervalSystem& system) {
    require(system.ratio() > Number(1));
    for (std::size_t i = 0; i < system.alphabet().size(); ++i) {
        Number sum;
        for (const Symbol letter : system.rules().image(to_symbol(i))) sum += system.length(letter);
        require(system.length(to_symbol(i)).sign() > 0);
        require(sum == system.ratio() * system.length(to_symbol(i)));
    }
}

void check_row(const std::vector<Number>& row) {
    Number sum;
    for (const Number& weight : row) sum += weight;
    require(sum == Number(1));
}

void check_window(const IntervalSystem& system, std::size_t degree, Bytes& bytes) {
    const std::size_t n = system.alphabet().size();
    Word window(2 * degree - 1);
    for (Symbol& letter : window) {
        const std::size_t index = bytes.below(n + 1);
        letter = index == n ? zero_interval : to_symbol(index);
    }
    if (window[degree - 1] == zero_interval) window[degree - 1] = to_symbol(0);
    const WindowStencils stencils = window_stencils(system, window);
    for (const std::vector<Number>& row : stencils.children) {
        check_row(row);
        for (const Number& weight : row) require(weight.sign() >= 0);
    }
    for (const std::vector<Number>& row : stencils.leading) check_row(row);
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    Bytes bytes(std::span(data, size));
    const std::size_t degree = 1 + bytes.below(4);
    const Verdict verdict = validate(read_grammar(bytes));
    require((verdict.decision == Decision::Valid) == verdict.reasons.empty());
    require((verdict.decision == Decision::Valid) == !verdict.theorems.empty());
    require(verdict.decision != Decision::Undecided);
    if (verdict.decision != Decision::Valid) return 0;
    require(verdict.system.has_value());
    check_lengths(*verdict.system);
    check_window(*verdict.system, degree, bytes);
    return 0;
}
