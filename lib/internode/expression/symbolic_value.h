// SPDX-License-Identifier: MIT
//
// The meaning of an expression before its formals have values: a quotient of polynomials, or a combination of points
// Σ c_i v_i with such quotients for coefficients.
//
// Constants that are given as plain numbers stay symbols, constants made of others are written out, functions are
// written out. What is not a quotient of polynomials (min, max, floor, abs, sqrt of terms that vary; coordinates of
// points) becomes a variable named by its text. Literal points and coordinates are remembered as such: with them an
// expression is no combination of points alone.

#pragma once

#include "internode/algebra/symbolic.h"
#include "internode/expression/definition_scope.h"
#include "internode/expression/type.h"

#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace internode {

struct SymbolicValue {
    bool is_point = false;
    Symbolic number; ///< the value, when it is a number
    /// Of a point: formals, ascending, and their coefficients; zero coefficients may stand.
    std::vector<std::pair<std::uint32_t, Symbolic>> coefficients;
    bool has_coordinates = false; ///< a literal point or a coordinate takes part
};

/// What a constant is worth: itself, or its value.
enum class ConstantReading { Symbols, Values };

/// Reads expressions over the same definitions, one after the other.
class SymbolicReader {
public:
    /// What the scope views must outlive the reader.
    explicit SymbolicReader(const DefinitionScope& scope);

    /// The value of an expression whose formals have these extents and names; none when it is not decided:
    /// `undecided` says why. Cost: bounded by the limits of algebra/symbolic.h times at most 20,000 instructions, and
    /// for all expressions of one reader together by a fixed amount of work.
    [[nodiscard]] std::optional<SymbolicValue> read(const Expression& expression, std::span<const Extent> extents,
                                                    std::span<const std::string> formals,
                                                    ConstantReading constants = ConstantReading::Symbols);
    [[nodiscard]] const std::string& undecided() const { return undecided_; }

    /// The names of the variables in the value that was read last, numbered as they were met.
    [[nodiscard]] std::span<const std::string> names() const { return names_; }
    /// Whether the variable stands for min, max, floor, abs or sqrt of others: identities among those are not known.
    [[nodiscard]] bool is_opaque(SymbolicVariable variable) const { return recipes_[variable].has_value(); }
    /// A value for every variable: free ones differ with `sample`, opaque ones follow from them.
    [[nodiscard]] std::vector<double> sample(std::uint32_t sample) const;

private:
    /// How an opaque variable follows from earlier ones.
    struct Recipe {
        Operation operation{};
        std::vector<Symbolic> arguments;
    };
    class Operations;

    [[nodiscard]] bool stays_symbol(std::uint32_t definition);
    [[nodiscard]] SymbolicVariable variable(const std::string& key, const std::string& name);
    [[nodiscard]] Symbolic opaque(Operation operation, std::vector<Symbolic> arguments);

    DefinitionScope scope_;
    std::vector<std::string> names_;                    ///< the names of the variables
    std::vector<std::optional<Recipe>> recipes_;        ///< how each opaque variable follows
    std::map<std::string, SymbolicVariable> variables_; ///< the variables by their keys
    std::vector<std::optional<bool>> stays_;            ///< whether each definition stays a symbol, once asked
    std::size_t work_ = 0;                              ///< products of terms, of all expressions
    std::string undecided_;
};

} // namespace internode
