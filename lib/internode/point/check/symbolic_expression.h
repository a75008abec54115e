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
#include "internode/point/point_system.h"

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
    Symbolic number; ///< of a number
    /// Of a point: formals, ascending, and their coefficients; zero coefficients may stand.
    std::vector<std::pair<std::uint32_t, Symbolic>> coefficients;
    bool has_coordinates = false; ///< a literal point or a coordinate takes part
};

/// Where the constants of the grammar come from.
enum class ConstantReading { Symbols, Values };

/// Reads expressions of one grammar, one after the other.
class SymbolicReader {
public:
    /// Both must outlive the reader; `constants` is indexed by definition.
    SymbolicReader(const PointGrammar& grammar, std::span<const ConstantValue> constants);

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
    /// One text that is being read: an expression, or the body of a definition that it calls.
    struct Frame {
        const Expression* expression = nullptr;
        std::size_t next = 0;                 ///< instruction
        std::vector<SymbolicValue> arguments; ///< of a call
    };
    using Value = std::optional<SymbolicValue>;

    [[nodiscard]] Value fail(const char* reason);
    [[nodiscard]] bool stop(const char* reason);
    [[nodiscard]] bool run(std::span<const Extent> extents, std::span<const std::string> formals);
    [[nodiscard]] bool step(Instruction instruction, const std::vector<Rational>& numbers);
    [[nodiscard]] bool push_call(std::uint32_t definition);
    [[nodiscard]] bool push_constant(std::uint32_t definition);
    [[nodiscard]] bool stays_symbol(std::uint32_t definition);
    [[nodiscard]] Value formal(std::uint32_t index, std::span<const Extent> extents,
                               std::span<const std::string> formals);
    [[nodiscard]] Value apply(Instruction instruction, std::span<const SymbolicValue> operands);
    [[nodiscard]] Value sum(const SymbolicValue& a, const SymbolicValue& b);
    [[nodiscard]] Value product(const SymbolicValue& a, const SymbolicValue& b);
    [[nodiscard]] Value quotient(const SymbolicValue& a, const SymbolicValue& b);
    [[nodiscard]] Value function(Operation operation, std::span<const SymbolicValue> operands);
    [[nodiscard]] bool spend(const Symbolic& a, const Symbolic& b);
    [[nodiscard]] SymbolicVariable variable(const std::string& key, const std::string& name);
    [[nodiscard]] Symbolic opaque(Operation operation, std::vector<Symbolic> arguments);

    const PointGrammar* grammar_;
    std::span<const ConstantValue> constants_;
    ConstantReading reading_ = ConstantReading::Symbols;
    std::vector<std::string> names_;
    std::vector<std::optional<Recipe>> recipes_;
    std::map<std::string, SymbolicVariable> variables_; ///< by key
    std::vector<std::optional<bool>> stays_;            ///< by definition, once it was asked for
    std::vector<Frame> frames_;
    std::vector<SymbolicValue> stack_;
    std::size_t instructions_ = 0; ///< of the expression that is being read
    std::size_t work_ = 0;         ///< of all
    std::string undecided_;
};

} // namespace internode
