// SPDX-License-Identifier: MIT

#include "internode/expression/known_number.h"

#include "internode/expression/limits.h"

#include <algorithm>
#include <cassert>

namespace internode {

namespace {

std::optional<Rational> exact_result(Operation operation, std::span<const KnownNumber> arguments) {
    if (!std::ranges::all_of(arguments, [](const KnownNumber& one) { return one.exact.has_value(); }))
        return std::nullopt;
    std::optional<Rational> value = apply_exactly(operation, *arguments.front().exact, *arguments.back().exact);
    if (value && bit_size(*value) > max_known_bits) return std::nullopt;
    return value;
}

} // namespace

double nearest(const KnownNumber& number) {
    return number.exact ? to_double(*number.exact) : number.value;
}

KnownNumber apply_operation(Operation operation, std::span<const KnownNumber> arguments) {
    assert(arguments.size() == operand_count({operation, 0}, 0));
    if (std::optional<Rational> exact = exact_result(operation, arguments)) return {std::move(exact), 0};
    const double first = nearest(arguments.front());
    return {std::nullopt, apply_operation(operation, first, nearest(arguments.back()))};
}

} // namespace internode
