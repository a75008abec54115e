// SPDX-License-Identifier: MIT
//
// One walk whose values are quotients of polynomials, with limits on instructions, products and nesting that all end in
// `undecided`. An opaque variable remembers how it follows from earlier ones, so that sample() can give all variables
// values that agree.

#include "internode/expression/symbolic_value.h"

#include "internode/expression/visitor.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>

namespace internode {

namespace {

// A rule of the papers takes some twenty instructions and products of a few terms; these bounds keep the reading of a
// hostile grammar below a few seconds.
constexpr std::size_t max_instructions = 20'000; // of one expression, its functions written out
constexpr std::size_t max_work = 20'000'000;     // products of terms, of all expressions
constexpr std::size_t max_texts = 200;           // read within each other
constexpr std::size_t max_name = 200;            // bytes of a variable

constexpr const char* beyond_limits = "its coefficients are larger than the check goes";

SymbolicValue number_value(Symbolic number, bool has_coordinates = false) {
    return SymbolicValue{
        .is_point = false, .number = std::move(number), .coefficients = {}, .has_coordinates = has_coordinates};
}

const char* name_of(Operation operation) {
    switch (operation) {
    case Operation::Minimum:
        return "min";
    case Operation::Maximum:
        return "max";
    case Operation::Floor:
        return "floor";
    case Operation::Absolute:
        return "abs";
    default:
        return "sqrt";
    }
}

bool uses_definitions(const Expression& expression) {
    return std::ranges::any_of(expression.code, [](Instruction instruction) {
        return instruction.operation == Operation::Constant || instruction.operation == Operation::Call;
    });
}

} // namespace

/// Sums, products and quotients of polynomials; definitions that stand for what they are made of are written out.
class SymbolicReader::Operations {
public:
    using Value = SymbolicValue;

    Operations(SymbolicReader& reader, std::span<const Extent> extents, std::span<const std::string> formals,
               ConstantReading reading)
        : reader_(reader)
        , extents_(extents)
        , formals_(formals)
        , reading_(reading) {
        assert(extents.size() == formals.size());
    }

    [[nodiscard]] bool admits(std::size_t texts) {
        if (++instructions_ <= max_instructions && texts <= max_texts) return true;
        reader_.undecided_ = "it is longer than the check goes, its functions written out";
        return false;
    }

    [[nodiscard]] const Definition* written_out(Instruction instruction) {
        const bool is_call = instruction.operation == Operation::Call;
        const bool is_made_of_others = !is_call && !is_value(instruction.operand) &&
                                       reading_ == ConstantReading::Symbols &&
                                       !reader_.stays_symbol(instruction.operand);
        return is_call || is_made_of_others ? &reader_.scope_.definitions[instruction.operand] : nullptr;
    }

    static std::optional<SymbolicValue> number(const Rational& number) { return number_value(Symbolic(number)); }

    [[nodiscard]] std::optional<SymbolicValue> formal(std::uint32_t index) {
        assert(index < extents_.size());
        if (extents_[index] == 0)
            return number_value(Symbolic::variable(reader_.variable("formal " + formals_[index], formals_[index])));
        SymbolicValue point;
        point.is_point = true;
        point.coefficients.emplace_back(index, Symbolic(Rational(1)));
        return point;
    }

    [[nodiscard]] std::optional<SymbolicValue> apply(Instruction instruction, std::span<const SymbolicValue> operands) {
        if (instruction.operation == Operation::Constant) return constant(instruction.operand);
        return operate(instruction, operands);
    }

private:
    using Result = std::optional<SymbolicValue>;

    Result fail(const char* reason) {
        reader_.undecided_ = reason;
        return std::nullopt;
    }

    [[nodiscard]] bool is_value(std::uint32_t definition) const {
        return reading_ == ConstantReading::Values && reader_.scope_.constants[definition].exact.has_value();
    }

    Result constant(std::uint32_t definition) {
        if (is_value(definition)) return number_value(Symbolic(*reader_.scope_.constants[definition].exact));
        const std::string& name = reader_.scope_.definitions[definition].name;
        return number_value(Symbolic::variable(reader_.variable("constant " + name, name)));
    }

    Result operate(Instruction instruction, std::span<const SymbolicValue> operands) {
        switch (instruction.operation) {
        case Operation::Negate:
            return product(number_value(Symbolic(Rational(-1))), operands[0]);
        case Operation::Add:
            return sum(operands[0], operands[1]);
        case Operation::Subtract: {
            const auto negated = product(number_value(Symbolic(Rational(-1))), operands[1]);
            return negated ? sum(operands[0], *negated) : std::nullopt;
        }
        case Operation::Multiply:
            return product(operands[0], operands[1]);
        case Operation::Divide:
            return quotient(operands[0], operands[1]);
        case Operation::Point: {
            SymbolicValue literal;
            literal.is_point = true;
            literal.has_coordinates = true;
            return literal;
        }
        case Operation::Coordinate: {
            // Each one a variable of its own: what coordinates cancel is not asked for.
            const std::string key = "coordinate " + std::to_string(reader_.names_.size());
            const std::string name(1, "xyzw"[instruction.operand % 4]);
            return number_value(Symbolic::variable(reader_.variable(key, name)), true);
        }
        case Operation::Minimum:
        case Operation::Maximum:
        case Operation::Floor:
        case Operation::Absolute:
        case Operation::SquareRoot:
            return function(instruction.operation, operands);
        default:
            return fail("it holds a condition");
        }
    }

    bool spend(const Symbolic& a, const Symbolic& b) {
        reader_.work_ +=
            (a.numerator().size() + a.denominator().size()) * (b.numerator().size() + b.denominator().size());
        return reader_.work_ <= max_work;
    }

    Result sum(const SymbolicValue& a, const SymbolicValue& b) {
        if (a.is_point != b.is_point) return fail("it adds a number and a point");
        if (!spend(a.number, b.number)) return fail(beyond_limits);
        SymbolicValue result;
        result.is_point = a.is_point;
        result.has_coordinates = a.has_coordinates || b.has_coordinates;
        const auto number = add(a.number, b.number);
        if (!number) return fail(beyond_limits);
        result.number = *number;
        auto i = a.coefficients.begin();
        auto j = b.coefficients.begin();
        reader_.work_ += a.coefficients.size() + b.coefficients.size();
        while (i != a.coefficients.end() || j != b.coefficients.end()) {
            if (j == b.coefficients.end() || (i != a.coefficients.end() && i->first < j->first))
                result.coefficients.push_back(*i++);
            else if (i == a.coefficients.end() || j->first < i->first)
                result.coefficients.push_back(*j++);
            else {
                const auto together = spend(i->second, j->second) ? add(i->second, j->second) : std::nullopt;
                if (!together) return fail(beyond_limits);
                result.coefficients.emplace_back(i->first, *together);
                ++i;
                ++j;
            }
        }
        return result;
    }

    Result product(const SymbolicValue& a, const SymbolicValue& b) {
        if (a.is_point && b.is_point) return fail("it multiplies two points");
        if (a.is_point) return product(b, a);
        SymbolicValue result = b;
        result.has_coordinates = a.has_coordinates || b.has_coordinates;
        if (!b.is_point) {
            const auto number = spend(a.number, b.number) ? multiply(a.number, b.number) : std::nullopt;
            if (!number) return fail(beyond_limits);
            result.number = *number;
        }
        for (auto& entry : result.coefficients) {
            const auto scaled = spend(a.number, entry.second) ? multiply(a.number, entry.second) : std::nullopt;
            if (!scaled) return fail(beyond_limits);
            entry.second = *scaled;
        }
        return result;
    }

    Result quotient(const SymbolicValue& a, const SymbolicValue& b) {
        if (b.is_point) return fail("it divides by a point");
        if (b.number.is_zero()) return fail("it divides by zero");
        const auto inverse = divide(Symbolic(Rational(1)), b.number);
        if (!inverse) return fail(beyond_limits);
        return product(number_value(*inverse, b.has_coordinates), a);
    }

    Result function(Operation operation, std::span<const SymbolicValue> operands) {
        std::vector<Rational> constants;
        std::vector<Symbolic> arguments;
        bool has_coordinates = false;
        for (const SymbolicValue& operand : operands) {
            if (operand.is_point) return fail("it takes a function of a point");
            has_coordinates = has_coordinates || operand.has_coordinates;
            arguments.push_back(operand.number);
            if (const auto constant = operand.number.constant()) constants.push_back(*constant);
        }
        if (constants.size() == operands.size())
            if (const auto folded = apply_exactly(operation, constants.front(), constants.back()))
                return number_value(Symbolic(*folded), has_coordinates);
        return number_value(reader_.opaque(operation, std::move(arguments)), has_coordinates);
    }

    SymbolicReader& reader_;
    std::span<const Extent> extents_;      ///< the extents of the formals
    std::span<const std::string> formals_; ///< the names of the formals
    ConstantReading reading_;
    std::size_t instructions_ = 0; ///< instructions of this expression so far
};

SymbolicReader::SymbolicReader(const DefinitionScope& scope)
    : scope_(scope)
    , stays_(scope.definitions.size()) {}

std::optional<SymbolicValue> SymbolicReader::read(const Expression& expression, std::span<const Extent> extents,
                                                  std::span<const std::string> formals, ConstantReading constants) {
    undecided_.clear();
    names_.clear();
    recipes_.clear();
    variables_.clear();
    Operations operations(*this, extents, formals, constants);
    return ExpressionVisitor(scope_.definitions, operations).visit(expression);
}

/// A constant made of other constants is written out, unless it was given another value from outside.
bool SymbolicReader::stays_symbol(std::uint32_t definition) {
    if (stays_[definition]) return *stays_[definition];
    const Expression& value = scope_.definitions[definition].value;
    bool stays = true;
    if (uses_definitions(value)) {
        SymbolicReader reader(scope_);
        const auto read = reader.read(value, {}, {}, ConstantReading::Values);
        stays = !read || read->is_point || read->number.constant() != scope_.constants[definition].exact;
        work_ += reader.work_;
    }
    stays_[definition] = stays;
    return stays;
}

Symbolic SymbolicReader::opaque(Operation operation, std::vector<Symbolic> arguments) {
    std::vector<std::string> texts;
    for (const Symbolic& argument : arguments) texts.push_back(to_string(argument, names_));
    // min and max do not care for the order of their arguments.
    if (texts.size() == 2 && texts[1] < texts[0]) std::swap(texts[0], texts[1]);
    std::string text = name_of(operation);
    text += "(" + texts[0] + (texts.size() == 2 ? ", " + texts[1] : "") + ")";
    const std::string name = text.size() <= max_name ? text : std::string(name_of(operation)) + "(…)";
    const auto known = variables_.find(text);
    if (known != variables_.end()) return Symbolic::variable(known->second);
    const SymbolicVariable made = variable(text, name);
    recipes_[made] = Recipe{.operation = operation, .arguments = std::move(arguments)};
    return Symbolic::variable(made);
}

SymbolicVariable SymbolicReader::variable(const std::string& key, const std::string& name) {
    const auto [place, is_new] = variables_.try_emplace(key, static_cast<SymbolicVariable>(names_.size()));
    if (is_new) {
        names_.push_back(name);
        recipes_.emplace_back();
    }
    return place->second;
}

std::vector<double> SymbolicReader::sample(std::uint32_t sample) const {
    constexpr std::array<double, 3> centres{0.4, 1.7, -0.8}; // below one, above one, negative
    std::vector<double> values;
    for (std::size_t variable = 0; variable < names_.size(); ++variable) {
        if (const auto& recipe = recipes_[variable]) {
            const double first = recipe->arguments.front().evaluate(values);
            const double last = recipe->arguments.back().evaluate(values);
            values.push_back(apply_operation(recipe->operation, first, last));
        } else {
            // Multiples of the golden ratio, modulo 1, are spread evenly.
            const double turn = 0.6180339887498949 * (static_cast<double>(variable) + 1 + 7.0 * sample);
            values.push_back(centres[sample % centres.size()] + 0.5 * (turn - std::floor(turn)));
        }
    }
    return values;
}

} // namespace internode
