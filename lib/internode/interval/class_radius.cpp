// SPDX-License-Identifier: MIT
//
// A radius is first had cheaply: exactly from a common row sum, else as bounds. Exact ones are then made where they
// decide: for the largest class and for those whose bounds meet it. Of the others those follow that cost little. Equal
// blocks are worked on once.

#include "internode/interval/class_radius.h"

#include "internode/algebra/polynomial.h"

#include <algorithm>
#include <cassert>
#include <map>
#include <stdexcept>

namespace internode {

namespace {

/// Cubes of class sizes whose exact radii may decide: two classes of 200, some seconds.
constexpr std::size_t decisive_work = 16'000'000;

/// Squares of class sizes whose exact radii are only good to know: a quarter of a second.
constexpr std::size_t idle_work = 2'000;

/// Relative width asked of the bounds: rounding keeps sparse iterations from less.
constexpr double bounds_width = 1e-13;

ClassRadius integer_radius(std::uint64_t value) {
    const Integer radius(static_cast<unsigned long>(value));
    ClassRadius result;
    result.field = NumberField({-radius, 1}, Rational(radius), Rational(radius));
    result.value = exact_quantity(Number(Rational(radius)));
    result.pisot = value > 1;
    return result;
}

std::uint64_t row_sum(const SparseRow& row) {
    std::uint64_t sum = 0;
    for (const auto& entry : row) sum += entry.second;
    return sum;
}

/// Rows of one sum r: the vector of ones is positive with M 1 = r 1, so ρ = r.
std::optional<std::uint64_t> common_row_sum(const SparseMatrix& block) {
    assert(!block.empty());
    const std::uint64_t first = row_sum(block.front());
    const bool same = std::ranges::all_of(block, [&](const SparseRow& row) { return row_sum(row) == first; });
    return same ? std::optional(first) : std::nullopt;
}

ClassRadius exact_radius(const PerronRoot& root, std::size_t field_degree) {
    ClassRadius result;
    result.field = root.field;
    result.pisot = root.pisot;
    result.value = exact_quantity(root.field.generator());
    if (root.field.degree() > field_degree) result.value.exact.reset();
    return result;
}

bool changes_sign(const Polynomial& polynomial, const Enclosure& bounds) {
    const auto sign = [&](const Rational& x) {
        Rational value;
        for (std::size_t i = polynomial.size(); i-- > 0;) value = value * x + polynomial[i];
        return sgn(value);
    };
    return sign(to_rational(bounds.lower)) * sign(to_rational(bounds.upper)) <= 0;
}

/// Whether a factor of low degree may have the radius for its root: isolating the roots of the others would take
/// seconds for nothing. ρ is a simple root of its minimal polynomial, which changes sign there.
bool may_have_degree(const SparseMatrix& block, const Enclosure& bounds, std::size_t degree) {
    if (block.size() <= degree) return true;
    return std::ranges::any_of(factor(characteristic_polynomial(block)), [&](const auto& one) {
        return one.first.size() <= degree + 1 && changes_sign(one.first, bounds);
    });
}

class Radii {
public:
    explicit Radii(const RadiusLimits& limits)
        : limits_(limits) {}

    const ClassRadius& of(const SparseMatrix& block) {
        const auto [place, is_new] = known_.try_emplace(block);
        if (is_new) {
            if (const auto sum = common_row_sum(block))
                place->second = integer_radius(*sum);
            else
                place->second.value = enclosed_quantity(enclose_radius(block, bounds_width).radius);
            place->second.block = known_.size();
        }
        return place->second;
    }

    /// The exact radius, of a degree that a field may have, or of any when classes must be told apart.
    void refine(const SparseMatrix& block, bool any_degree) {
        const std::size_t size = block.size();
        if (of(block).field || size > limits_.exact_class || work_ + size * size * size > decisive_work) return;
        work_ += size * size * size;
        compute(block, any_degree ? std::max(size, limits_.field_degree) : limits_.field_degree);
    }

    /// The exact radius of a class that decides nothing, while it costs little.
    void embellish(const SparseMatrix& block) {
        const std::size_t size = block.size();
        if (of(block).field || size > std::min(limits_.exact_class, limits_.field_degree)) return;
        if (idle_work_ + size * size > idle_work) return;
        idle_work_ += size * size;
        compute(block, limits_.field_degree);
    }

private:
    void compute(const SparseMatrix& block, std::size_t degree) {
        ClassRadius& radius = known_.at(block);
        assert(!radius.field);
        if (!may_have_degree(block, radius.value.bounds, degree)) return;
        const auto root = perron_root(block, degree);
        if (!root) return;
        const std::size_t number = radius.block;
        radius = exact_radius(*root, limits_.field_degree);
        radius.block = number;
    }

    RadiusLimits limits_;
    std::size_t work_ = 0;
    std::size_t idle_work_ = 0;
    std::map<SparseMatrix, ClassRadius> known_;
};

/// Of two different real numbers, by halving an interval that holds both.
std::partial_ordering separate(const Number& a, const Number& b, const Enclosure& bounds) {
    assert(bounds.lower < bounds.upper);
    Rational lower = to_rational(bounds.lower);
    Rational upper = to_rational(bounds.upper);
    for (;;) {
        const Rational middle = (lower + upper) / 2;
        const std::strong_ordering first = a <=> Number(middle);
        const std::strong_ordering second = b <=> Number(middle);
        if (first != second)
            return first < 0 || second > 0 ? std::partial_ordering::less : std::partial_ordering::greater;
        (first < 0 ? upper : lower) = middle;
    }
}

std::partial_ordering compare_bounds(const Enclosure& a, const Enclosure& b) {
    assert(a.lower <= a.upper && b.lower <= b.upper);
    if (a.upper < b.lower) return std::partial_ordering::less;
    if (a.lower > b.upper) return std::partial_ordering::greater;
    return std::partial_ordering::unordered;
}

} // namespace

std::partial_ordering compare(const ClassRadius& a, const ClassRadius& b) {
    if (a.block == b.block && a.block != 0) return std::partial_ordering::equivalent;
    const bool exact = a.field && b.field;
    if (exact && a.field->minimal_polynomial() == b.field->minimal_polynomial())
        return std::partial_ordering::equivalent;
    const std::partial_ordering order = compare_bounds(a.value.bounds, b.value.bounds);
    if (order != std::partial_ordering::unordered || !exact) return order;
    const Enclosure both{std::min(a.value.bounds.lower, b.value.bounds.lower),
                         std::max(a.value.bounds.upper, b.value.bounds.upper)};
    return separate(a.field->generator(), b.field->generator(), both);
}

LargestRadius largest_radius(const std::vector<ClassRadius>& radii) {
    if (radii.empty()) throw std::invalid_argument("a system without classes has no ratio");
    LargestRadius result;
    for (std::size_t i = 1; i < radii.size(); ++i) {
        const std::partial_ordering order = compare(radii[i], radii[result.index]);
        const bool higher = radii[i].value.bounds.lower > radii[result.index].value.bounds.lower;
        if (order > 0 || (order == std::partial_ordering::unordered && higher)) result.index = i;
    }
    for (const ClassRadius& radius : radii) result.order.push_back(compare(radius, radii[result.index]));
    return result;
}

std::vector<ClassRadius> class_radii(const ClassGraph& graph, const RadiusLimits& limits) {
    Radii radii(limits);
    const auto all = [&] {
        std::vector<ClassRadius> result;
        for (const IntervalClass& one : graph.classes) result.push_back(radii.of(one.block));
        return result;
    };
    std::vector<ClassRadius> result = all();
    if (result.empty()) return result;
    const LargestRadius largest = largest_radius(result);
    assert(largest.order.size() == result.size());
    const auto unclear = [](std::partial_ordering order) { return order == std::partial_ordering::unordered; };
    const bool any_degree = std::ranges::any_of(largest.order, unclear);
    for (std::size_t i = 0; i < result.size(); ++i)
        if (i == largest.index || unclear(largest.order[i])) radii.refine(graph.classes[i].block, any_degree);
    for (const IntervalClass& one : graph.classes) radii.embellish(one.block);
    return all();
}

} // namespace internode
