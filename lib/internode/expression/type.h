// SPDX-License-Identifier: MIT
//
// What an expression is, a number, a point or a truth, when it is known what its formals are.

#pragma once

#include "internode/expression/definition.h"
#include "internode/expression/problem.h"

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace internode {

/// 0: a number; k >= 1: a point of k coordinates.
using Extent = std::uint32_t;

struct ExpressionType {
    bool truth = false;
    Extent extent = 0; ///< the extent of a number or a point
    friend bool operator==(const ExpressionType&, const ExpressionType&) = default;
};

/// "a number", "a point of 2 coordinates", "a truth".
[[nodiscard]] std::string describe(ExpressionType type);

/// Names and extents of the formals of a rule, a definition or an input; equally many.
struct Formals {
    std::span<const std::string> names;
    std::span<const Extent> extents;
};

/// The type of an expression; none, and one more problem, when its operands do not fit. Cost: linear.
[[nodiscard]] std::optional<ExpressionType> type_of(const Expression& expression, const Formals& formals,
                                                    std::span<const Definition> definitions,
                                                    std::vector<ExpressionProblem>& problems);

/// The same where only one type will do: a number, or a truth. `what`: "the condition", "the weight".
bool expect_type(ExpressionType expected, const std::string& what, const Expression& expression, const Formals& formals,
                 std::span<const Definition> definitions, std::vector<ExpressionProblem>& problems);

} // namespace internode
