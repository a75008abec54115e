// SPDX-License-Identifier: MIT
//
// Small point grammars drawn at random: contexts up to two modules each side, conditions, empty successors, tables,
// rings and open words with end markers; strict predecessors of two modules, branches and coordinates where all is
// drawn.

#pragma once

#include <random>
#include <string>
#include <vector>

namespace internode::reference {

/// Everything, or only what may be decided by the modules near a point.
enum class Drawn { Everything, Local };

/// A text drawn letter by letter. Letters: P(point), A(number), E, and # in open words.
class RandomPointGrammar {
public:
    explicit RandomPointGrammar(unsigned seed, Drawn drawn = Drawn::Everything)
        : random_(seed)
        , local_(drawn == Drawn::Local) {}

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
            word +=
                one_of(local_ ? std::vector<std::string>{"P((1/2, 3))", "P((-2, 5/4))", "P((7, t))", "A(1)", "E"}
                              : std::vector<std::string>{"P((1/2, 3))", "P((-2, 5/4))", "P((7, t))", "A(1)", "A(-3/2)",
                                                         "A(f(2, 0))", "E", "[ A(2) E ]", "[ E [ P((1, 1)) ] ]"}) +
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
        if (local_) return one_of({a, "min(" + a + " + 1, 2)", "abs(" + a + ")", "1", "floor(" + b + "/2)"});
        return one_of({a, "1/2 " + a + " - " + b, "f(" + a + ", " + b + ")", "abs(" + a + ") + 1", "floor(" + a + ")",
                       "-" + a, a + "*(t + " + b + ")"});
    }

    std::string point() {
        if (points_.empty()) return "(" + number() + ", " + number() + ")";
        const std::string u = one_of(points_);
        const std::string v = one_of(points_);
        if (local_)
            return one_of({u, "1/4 " + u + " + 3/4 " + v, "(1 - t) " + u + " + t " + v, "3/2 " + u + " - 1/2 " + v});
        return one_of({u, "1/4 " + u + " + 3/4 " + v, "(1 - t) " + u + " + t " + v,
                       "(" + number() + ")*" + u + " - " + v, "(" + u + ".y, " + v + ".x)",
                       "-1/16 " + u + " + 9/16 " + v + " + 1/2 " + u, u + "/2 + " + v + "/2"});
    }

    std::string condition() {
        if (local_) return number() + one_of({" == ", " < ", " >= "}) + number();
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
        text += modules(!local_ && below(5) == 0 ? 2 : 1, ring);
        if (const unsigned right = below(3); right > 0) text += "> " + modules(right, ring);
        text = "r" + std::to_string(rules_++) + ": " + text;
        if (below(3) == 0) text += ": " + condition();
        text += " ->";
        const unsigned count = below(4);
        if (count == 0) return text + " .\n";
        for (unsigned i = 0; i < count; ++i) {
            const std::string made = local_ && points_.empty() ? "E" : "P(" + point() + ")";
            text += " " + one_of({"E", local_ ? "E" : "[ E ]", "A(" + number() + ")", made, made});
        }
        return text + "\n";
    }

    std::mt19937 random_;
    bool local_;
    std::vector<std::string> points_;
    std::vector<std::string> numbers_;
    unsigned rules_ = 0;
};

} // namespace internode::reference
