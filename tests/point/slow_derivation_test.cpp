// SPDX-License-Identifier: MIT
//
// The interpreter against the definition, over small grammars drawn at random: contexts up to two modules each side,
// conditions, empty successors, strict predecessors of two modules, tables, branches, rings and open words with end
// markers.

#include "tests/point/systems.h"
#include "tests/reference/slow_derivation.h"

#include <gtest/gtest.h>

#include <random>
#include <string>
#include <vector>

namespace internode {
namespace {

#ifdef INTERNODE_SANITIZED
constexpr unsigned grammars = 300;
#else
constexpr unsigned grammars = 3000;
#endif

/// A text drawn letter by letter. Letters: P(point), A(number), E, and # in open words.
class RandomGrammar {
public:
    explicit RandomGrammar(unsigned seed)
        : random_(seed) {}

    std::string text() {
        const bool ring = below(2) == 0;
        const bool tables = below(3) == 0;
        std::string text = "points\nt = 1/4\nf(s, u) = min(s, 1) + max(u, 1/2)\n";
        if (ring) text += "ring\n";
        text += "axiom " + axiom(!ring) + "\n";
        for (unsigned i = below(3); i > 0; --i) text += rule(ring);
        if (tables) text += "table p\n";
        for (unsigned i = 1 + below(3); i > 0; --i) text += rule(ring);
        if (tables) text += "table q\n" + rule(ring) + rule(ring) + "cycle p q^2\n";
        return text;
    }

private:
    unsigned below(unsigned bound) { return static_cast<unsigned>(random_() % bound); }
    std::string one_of(const std::vector<std::string>& texts) {
        return texts[below(static_cast<unsigned>(texts.size()))];
    }

    std::string axiom(bool ends) {
        std::string word;
        for (unsigned i = 1 + below(6); i > 0; --i)
            word += one_of({"P((1/2, 3))", "P((-2, 5/4))", "P((7, t))", "A(1)", "A(-3/2)", "A(f(2, 0))", "E",
                            "[ A(2) E ]", "[ E [ P((1, 1)) ] ]"}) +
                    " ";
        return ends && below(2) == 0 ? "# " + word + "#" : word;
    }

    /// A module before the arrow; its formal is known from then on.
    std::string module(bool ring) {
        const unsigned kind = below(ring ? 7 : 8);
        if (kind < 3) {
            points_.push_back("p" + std::to_string(points_.size()));
            return "P(" + points_.back() + ")";
        }
        if (kind < 5) {
            numbers_.push_back("s" + std::to_string(numbers_.size()));
            return "A(" + numbers_.back() + ")";
        }
        return kind < 7 ? "E" : "#";
    }

    std::string modules(unsigned count, bool ring) {
        std::string text;
        for (; count > 0; --count) text += module(ring) + " ";
        return text;
    }

    std::string number() {
        if (numbers_.empty()) return one_of({"1/2", "t", "3"});
        const std::string a = one_of(numbers_);
        const std::string b = one_of(numbers_);
        return one_of({a, "1/2 " + a + " - " + b, "f(" + a + ", " + b + ")", "abs(" + a + ") + 1", "floor(" + a + ")",
                       "-" + a, a + "*(t + " + b + ")"});
    }

    std::string point() {
        if (points_.empty()) return "(" + number() + ", " + number() + ")";
        const std::string u = one_of(points_);
        const std::string v = one_of(points_);
        return one_of({u, "1/4 " + u + " + 3/4 " + v, "(1 - t) " + u + " + t " + v,
                       "(" + number() + ")*" + u + " - " + v, "(" + u + ".y, " + v + ".x)",
                       "-1/16 " + u + " + 9/16 " + v + " + 1/2 " + u, u + "/2 + " + v + "/2"});
    }

    std::string condition() {
        const std::string a = points_.empty() ? number() : one_of(points_) + ".x";
        return one_of({a + " > " + number(), a + " <= 1 and " + number() + " != 3", "not " + a + " < 0 or 1 == t",
                       a + " >= " + a});
    }

    std::string rule(bool ring) {
        points_.clear();
        numbers_.clear();
        std::string text;
        const unsigned left = below(3);
        if (left > 0) text += modules(left, ring) + "< ";
        text += modules(below(5) == 0 ? 2 : 1, ring);
        if (const unsigned right = below(3); right > 0) text += "> " + modules(right, ring);
        text = "r" + std::to_string(rules_++) + ": " + text;
        if (below(3) == 0) text += ": " + condition();
        text += " ->";
        const unsigned count = below(4);
        if (count == 0) return text + " .\n";
        for (unsigned i = 0; i < count; ++i)
            text += " " + one_of({"E", "[ E ]", "A(" + number() + ")", "P(" + point() + ")", "P(" + point() + ")"});
        return text + "\n";
    }

    std::mt19937 random_;
    std::vector<std::string> points_;
    std::vector<std::string> numbers_;
    unsigned rules_ = 0;
};

ModuleWord as_word(const reference::Sentence& sentence) {
    ModuleWord word;
    for (const reference::SlowModule& one : sentence) {
        std::vector<double> values;
        for (const reference::SlowValue& parameter : one.parameters)
            values.insert(values.end(), parameter.coordinates.begin(), parameter.coordinates.end());
        word.push_back(one.letter, values);
    }
    return word;
}

TEST(Interpreter, AgreesWithTheDefinitionForRandomGrammars) {
    unsigned compared = 0;
    for (unsigned seed = 0; seed < grammars; ++seed) {
        const std::string text = RandomGrammar(seed).text();
        const PointSystem system = system_of(text);
        reference::Sentence sentence = reference::axiom_sentence(system.grammar());
        ModuleWord word = axiom_word(system);
        for (std::uint64_t step = 0; step < 4 && sentence.size() < 500; ++step) {
            const Derivation next = derive_step(system, word, step);
            // What is left over by pairs is refused; the definition says nothing about it.
            if (next.problem) {
                ASSERT_NE(next.problem->message.find("left over"), std::string::npos) << text << next.problem->message;
                break;
            }
            sentence =
                reference::derive_from(0, sentence, system.grammar(), system.cycle()[step % system.cycle().size()]);
            word = next.word;
            ASSERT_EQ(word, as_word(sentence)) << text << "step " << step << ": " << shown(system, word);
            ++compared;
        }
    }
    EXPECT_GT(compared, 2 * grammars);
}

} // namespace
} // namespace internode
