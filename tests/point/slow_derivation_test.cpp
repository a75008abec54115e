// SPDX-License-Identifier: MIT
//
// The interpreter against the definition, over small grammars drawn at random: contexts up to two modules each side,
// conditions, empty successors, strict predecessors of two modules, tables, branches, rings and open words with end
// markers.

#include "internode/point/start_word.h"
#include "tests/fixtures/random_point_grammar.h"
#include "tests/fixtures/stride.h"
#include "tests/point/systems.h"
#include "tests/reference/slow_derivation.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace internode {
namespace {

const auto grammars = static_cast<unsigned>(tests::times(3000, 50));

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
        const std::string text = tests::RandomPointGrammar(seed).text();
        const PointSystem system = point_system(text);
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
