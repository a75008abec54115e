// SPDX-License-Identifier: MIT

#include "internode/point/check/symbolic_expression.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace internode {

namespace {

// A rule of the papers takes some twenty instructions and products of a few terms; these bounds keep the reading of a
// hostile grammar below a few seconds.
constexpr std::size_t max_instructions = 20'000; // of one expression, its functions written out
constexpr std::size_t max_work = 20'000'000;     // products of terms, of all expressions
constexpr std::size_t max_calls = 200;           // within each other
constexpr std::size_t max_name = 200;            // bytes of a variable

constexpr const char* beyond_limits = "its coefficients are larger than the check goes";
constexpr const char* too_long = "it is longer than the check goes, its functions written out";

SymbolicValue number_value(Symbolic number, bool has_coordinates = false) {
    return SymbolicValue{
        .is_point = false, .number = std::move(number), .coefficients = {}, .has_coordinates = has_coordinates};
}

std::optional<Rational> exact_square_root(const Rational& value) {
    if (value < 0 || mpz_perfect_square_p(value.get_num_mpz_t()) == 0 ||
        mpz_perfect_square_p(value.get_den_mpz_t()) == 0)
        return std::nullopt;
    return Rational(Integer(sqrt(value.get_num())), Integer(sqrt(value.get_den())));
}

Rational floor_of(const Rational& value) {
    Integer quotient;
    mpz_fdiv_q(quotient.get_mpz_t(), value.get_num_mpz_t(), value.get_den_mpz_t());
    return quotient;
}

/// The function of constants, where its value is rational.
std::optional<Rational> fold(Operation operation, const std::vector<Rational>& values) {
    switch (operation) {
    case Operation::Minimum:
        return std::min(values[0], values[1]);
    case Operation::Maximum:
        return std::max(values[0], values[1]);
    case Operation::Floor:
        return floor_of(values[0]);
    case Operation::Absolute:
        return Rational(abs(values[0]));
    default:
        return exact_square_root(values[0]);
    }
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

double evaluate_function(Operation operation, const std::vector<double>& values) {
    switch (operation) {
    case Operation::Minimum:
        return std::min(values[0], values[1]);
    case Operation::Maximum:
        return std::max(values[0], values[1]);
    case Operation::Floor:
        return std::floor(values[0]);
    case Operation::Absolute:
        return std::fabs(values[0]);
    default:
        return std::sqrt(values[0]);
    }
}

bool uses_definitions(const Expression& expression) {
    return std::ranges::any_of(expression.code, [](Instruction instruction) {
        return instruction.operation == Operation::Constant || instruction.operation == Operation::Call;
    });
}

} // namespace

SymbolicReader::SymbolicReader(const PointGrammar& grammar, std::span<const ConstantValue> constants)
    : grammar_(&grammar)
    , constants_(constants)
    , stays_(grammar.definitions.size()) {}

std::optional<SymbolicValue> SymbolicReader::read(const Expression& expression, std::span<const Extent> extents,
                                                  std::span<const std::string> formals, ConstantReading constants) {
    reading_ = constants;
    undecided_.clear();
    instructions_ = 0;
    names_.clear();
    recipes_.clear();
    variables_.clear();
    stack_.clear();
    frames_.clear();
    frames_.push_back(Frame{.expression = &expression, .next = 0, .arguments = {}});
    if (!run(extents, formals)) return std::nullopt;
    return std::move(stack_.back());
}

SymbolicReader::Value SymbolicReader::fail(const char* reason) {
    undecided_ = reason;
    return std::nullopt;
}

bool SymbolicReader::stop(const char* reason) {
    undecided_ = reason;
    return false;
}

bool SymbolicReader::run(std::span<const Extent> extents, std::span<const std::string> formals) {
    while (!frames_.empty()) {
        Frame& frame = frames_.back();
        if (frame.next == frame.expression->code.size()) {
            frames_.pop_back();
            continue;
        }
        if (++instructions_ > max_instructions) return stop(too_long);
        const Instruction instruction = frame.expression->code[frame.next++];
        if (instruction.operation != Operation::Formal) {
            if (!step(instruction, frame.expression->numbers)) return false;
        } else if (frames_.size() > 1) {
            stack_.push_back(frame.arguments[instruction.operand]);
        } else {
            auto value = formal(instruction.operand, extents, formals);
            if (!value) return false;
            stack_.push_back(std::move(*value));
        }
    }
    return true;
}

bool SymbolicReader::step(Instruction instruction, const std::vector<Rational>& numbers) {
    switch (instruction.operation) {
    case Operation::Number:
        stack_.push_back(number_value(Symbolic(numbers[instruction.operand])));
        return true;
    case Operation::Constant:
        return push_constant(instruction.operand);
    case Operation::Call:
        return push_call(instruction.operand);
    default:
        break;
    }
    const std::size_t count = operand_count(instruction, 0);
    auto value = apply(instruction, std::span(stack_).last(count));
    if (!value) return false;
    stack_.resize(stack_.size() - count);
    stack_.push_back(std::move(*value));
    return true;
}

bool SymbolicReader::push_call(std::uint32_t definition) {
    if (frames_.size() >= max_calls) return stop(too_long);
    const Definition& called = grammar_->definitions[definition];
    const auto first = stack_.end() - static_cast<std::ptrdiff_t>(called.formals.size());
    Frame frame{.expression = &called.value, .next = 0, .arguments = {}};
    std::move(first, stack_.end(), std::back_inserter(frame.arguments));
    stack_.erase(first, stack_.end());
    frames_.push_back(std::move(frame));
    return true;
}

/// A constant made of other constants is written out, unless it was given another value from outside.
bool SymbolicReader::stays_symbol(std::uint32_t definition) {
    if (stays_[definition]) return *stays_[definition];
    const Expression& value = grammar_->definitions[definition].value;
    bool stays = true;
    if (uses_definitions(value)) {
        SymbolicReader reader(*grammar_, constants_);
        const auto read = reader.read(value, {}, {}, ConstantReading::Values);
        stays = !read || read->is_point || read->number.constant() != constants_[definition].exact;
        work_ += reader.work_;
    }
    stays_[definition] = stays;
    return stays;
}

bool SymbolicReader::push_constant(std::uint32_t definition) {
    const std::string& name = grammar_->definitions[definition].name;
    if (reading_ == ConstantReading::Values && constants_[definition].exact) {
        stack_.push_back(number_value(Symbolic(*constants_[definition].exact)));
        return true;
    }
    if (reading_ == ConstantReading::Symbols && !stays_symbol(definition)) return push_call(definition);
    stack_.push_back(number_value(Symbolic::variable(variable("constant " + name, name))));
    return true;
}

SymbolicReader::Value SymbolicReader::formal(std::uint32_t index, std::span<const Extent> extents,
                                             std::span<const std::string> formals) {
    if (extents[index] == 0)
        return number_value(Symbolic::variable(variable("formal " + formals[index], formals[index])));
    SymbolicValue point;
    point.is_point = true;
    point.coefficients.emplace_back(index, Symbolic(Rational(1)));
    return point;
}

SymbolicReader::Value SymbolicReader::apply(Instruction instruction, std::span<const SymbolicValue> operands) {
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
        const std::string key = "coordinate " + std::to_string(names_.size());
        const std::string name(1, "xyzw"[instruction.operand % 4]);
        return number_value(Symbolic::variable(variable(key, name)), true);
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

bool SymbolicReader::spend(const Symbolic& a, const Symbolic& b) {
    work_ += (a.numerator().size() + a.denominator().size()) * (b.numerator().size() + b.denominator().size());
    return work_ <= max_work;
}

SymbolicReader::Value SymbolicReader::sum(const SymbolicValue& a, const SymbolicValue& b) {
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
    work_ += a.coefficients.size() + b.coefficients.size();
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

SymbolicReader::Value SymbolicReader::product(const SymbolicValue& a, const SymbolicValue& b) {
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

SymbolicReader::Value SymbolicReader::quotient(const SymbolicValue& a, const SymbolicValue& b) {
    if (b.is_point) return fail("it divides by a point");
    if (b.number.is_zero()) return fail("it divides by zero");
    const auto inverse = divide(Symbolic(Rational(1)), b.number);
    if (!inverse) return fail(beyond_limits);
    return product(number_value(*inverse, b.has_coordinates), a);
}

SymbolicReader::Value SymbolicReader::function(Operation operation, std::span<const SymbolicValue> operands) {
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
        if (const auto folded = fold(operation, constants)) return number_value(Symbolic(*folded), has_coordinates);
    return number_value(opaque(operation, std::move(arguments)), has_coordinates);
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
            std::vector<double> arguments;
            for (const Symbolic& argument : recipe->arguments) arguments.push_back(argument.evaluate(values));
            values.push_back(evaluate_function(recipe->operation, arguments));
        } else {
            // Multiples of the golden ratio, modulo 1, are spread evenly.
            const double turn = 0.6180339887498949 * (static_cast<double>(variable) + 1 + 7.0 * sample);
            values.push_back(centres[sample % centres.size()] + 0.5 * (turn - std::floor(turn)));
        }
    }
    return values;
}

} // namespace internode
