// SPDX-License-Identifier: MIT

#include "internode/algebra/fraction.h"

#include "tests/fixtures/source_folder.h"

#include <gtest/gtest.h>

#include <cctype>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <numeric>
#include <string>
#include <string_view>
#include <vector>

namespace internode {

namespace {

/// The arguments of a call whose `(` stands at text[open], split at the commas outside parentheses.
std::vector<std::string> arguments_at(std::string_view text, std::size_t open) {
    std::vector<std::string> arguments(1);
    std::size_t depth = 0;
    for (std::size_t i = open; i < text.size(); ++i) {
        const char c = text[i];
        if ((c == ')' || c == '}') && --depth == 0) break;
        if (depth == 1 && c == ',')
            arguments.emplace_back();
        else if (depth > 0 && c != '\'')
            arguments.back() += c;
        if (c == '(' || c == '{') ++depth;
    }
    return arguments;
}

bool is_integer(const std::string& text) {
    const std::size_t first = text.find_first_not_of(" -");
    return first != std::string::npos && text.find_first_not_of("0123456789", first) == std::string::npos;
}

/// `Rational(3, 4)` is in lowest terms as it stands; of `Rational(a, b)` and `Rational(15, 100)` nobody says so.
bool is_in_lowest_terms(const std::vector<std::string>& arguments) {
    if (arguments.size() != 2) return arguments.size() < 2;
    if (!is_integer(arguments[0]) || !is_integer(arguments[1])) return false;
    const long long denominator = std::stoll(arguments[1]);
    return denominator > 0 && std::gcd(std::stoll(arguments[0]), denominator) == 1;
}

/// The parameters of a function begin with a type: two words, or a reference.
bool is_declaration(const std::string& argument) {
    const std::size_t first = argument.find_first_not_of(" \n");
    if (first == std::string::npos) return false;
    const std::size_t blank = argument.find(' ', first);
    return std::isalpha(static_cast<unsigned char>(argument[first])) != 0 && blank != std::string::npos &&
           argument.find_first_of("+-*/(") > blank;
}

/// Where a source makes a Rational of two integers: the places, as a line of text each.
std::vector<std::string> doubtful(const std::string& text) {
    std::vector<std::string> found;
    for (std::size_t at = text.find("Rational"); at != std::string::npos; at = text.find("Rational", at + 1)) {
        const auto is_word = [&](std::size_t i) {
            return i < text.size() && (std::isalnum(static_cast<unsigned char>(text[i])) != 0 || text[i] == '_');
        };
        std::size_t open = at + std::string_view("Rational").size();
        if (is_word(open) || (at > 0 && is_word(at - 1))) continue;
        while (is_word(open) || (open < text.size() && text[open] == ' ')) ++open;
        if (open >= text.size() || (text[open] != '(' && text[open] != '{')) continue;
        const std::vector<std::string> arguments = arguments_at(text, open);
        if (!is_in_lowest_terms(arguments) && !is_declaration(arguments.front())) found.push_back(text.substr(at, 60));
    }
    return found;
}

} // namespace

TEST(Fraction, IsInLowestTermsWithAPositiveDenominator) {
    for (int numerator = -30; numerator <= 30; ++numerator)
        for (int denominator = -30; denominator <= 30; ++denominator) {
            if (denominator == 0) continue;
            const Rational value = fraction(numerator, denominator);
            ASSERT_TRUE(is_canonical(value)) << numerator << '/' << denominator;
            ASSERT_EQ(Rational(value * denominator), numerator);
            ASSERT_EQ(fraction(7 * numerator, 7 * denominator), value);
        }
}

TEST(Fraction, AConstructorLeavesItAsItIs) {
    EXPECT_FALSE(is_canonical(mpq_class(15, 100)));
    EXPECT_FALSE(is_canonical(mpq_class(0, 2)));
    EXPECT_FALSE(is_canonical(mpq_class(1, -2)));
    EXPECT_TRUE(is_canonical(mpq_class(3, 20)));
    EXPECT_TRUE(is_canonical(Rational(0)));
}

TEST(Fraction, NoSourceMakesOneInAnotherWay) {
    std::size_t sources = 0;
    for (const char* folder : {"lib", "cli", "tests", "bench"})
        for (const auto& entry : std::filesystem::recursive_directory_iterator(tests::in_source_folder(folder))) {
            const std::string name = entry.path().filename();
            if (!name.ends_with(".cpp") && !name.ends_with(".h")) continue;
            if (name == "fraction.cpp" || name == "fraction_test.cpp") continue;
            ++sources;
            std::ifstream file(entry.path());
            const std::string text{std::istreambuf_iterator<char>(file), {}};
            EXPECT_EQ(text.find("canonicalize"), std::string::npos) << entry.path();
            for (const std::string& place : doubtful(text)) ADD_FAILURE() << entry.path() << ": " << place;
        }
    EXPECT_GT(sources, 300u);
}

TEST(Fraction, ADoubtfulOneIsFound) {
    EXPECT_EQ(doubtful("= Rational(15, 100);").size(), 1u);
    EXPECT_EQ(doubtful(" Rational x(a, b);").size(), 1u);
    EXPECT_EQ(doubtful(" Rational(a.get_num(), f(b, c));").size(), 1u);
    EXPECT_EQ(doubtful(" Rational(3, 4) + Rational(x) + Rational(f(a, b)); Rational f(long a, long b) {").size(), 0u);
}

} // namespace internode
