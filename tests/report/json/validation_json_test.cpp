// SPDX-License-Identifier: MIT

#include "internode/report/json/validation_json.h"

#include "tests/report/systems.h"

#include <nlohmann/json.hpp>

namespace internode {
namespace {

using nlohmann::json;
using testing_report::grammar_of;

const Generator generator{"0.1.0", "internode validate"};

json document_of(const IntervalGrammar& grammar, const ValidityLimits& limits = {}) {
    return json::parse(validation_json(validate(grammar, limits), grammar, generator));
}

TEST(ValidationJson, HasTheKeysOfFibonacci) {
    const json document = document_of(grammar_of(testing_report::fibonacci));
    EXPECT_EQ(document["format"], "internode-validation");
    EXPECT_EQ(document["generator"], (json{{"version", "0.1.0"}, {"command", "internode validate"}}));
    EXPECT_EQ(document["valid"], true);
    EXPECT_EQ(document["exactness"], "exact");
    EXPECT_EQ(document["field"]["minimal_polynomial"], (json{"-1", "-1", "1"}));
    EXPECT_EQ(document["field"]["root"], 1.618033988749895);
    EXPECT_EQ(document["ratio"]["exact"], (json{"0", "1"}));
    EXPECT_EQ(document["symbols"][1]["frequency"], (json{{"value", 0.38196601125010515}, {"exact", {"2", "-1"}}}));
    EXPECT_EQ(document["grammar"]["rules"]["L"], (json{"S", "L"}));
    EXPECT_EQ(document["grammar"]["axiom"], nullptr);
    EXPECT_EQ(document["theorems"], (json{"3.7", "3.8"}));
    EXPECT_EQ(document["pisot"], true);
    EXPECT_EQ(document["reasons"], json::array());
}

TEST(ValidationJson, AnInvalidSystemHasReasonsAndNoLengths) {
    const json document = document_of(grammar_of("A1 -> A1 A1 A2\nA2 -> A2"));
    EXPECT_EQ(document["valid"], false);
    EXPECT_EQ(document["reasons"][0]["code"], "never-splits");
    EXPECT_EQ(document["reasons"][0]["symbols"], (json{"A2"}));
    for (const json& symbol : document["symbols"]) EXPECT_EQ(symbol["length"], nullptr);
}

TEST(ValidationJson, AClassRatioOfAnotherFieldIsAnEnclosure) {
    const json document = document_of(grammar_of("A -> A A A B\nB -> C B\nC -> B"));
    EXPECT_EQ(document["valid"], false);
    bool has_enclosure = false;
    for (const json& entry : document["classes"]) has_enclosure = has_enclosure || entry["ratio"].contains("lower");
    EXPECT_TRUE(has_enclosure);
}

TEST(ValidationJson, SymbolsThatNeverOccurHaveNoLength) {
    const json document = document_of(grammar_of("A -> A A\nB -> A B\naxiom (A A)"));
    EXPECT_EQ(document["symbols"][1]["length"], nullptr);
    EXPECT_EQ(document["symbols"][1]["frequency"], nullptr);
    EXPECT_EQ(document["grammar"]["axiom"], (json{{"word", {"A", "A"}}, {"closed", true}}));
}

TEST(ValidationJson, FrequenciesThatDependOnAnAxiomAreNull) {
    const json document = document_of(grammar_of("A -> A A\nB -> B B"));
    EXPECT_EQ(document["valid"], true);
    EXPECT_EQ(document["symbols"][0]["frequency"], nullptr);
    EXPECT_EQ(document["free_lengths"], 2);
}

TEST(ValidationJson, KnowsEnclosuresWhereTheFieldIsTooLarge) {
    const json document = document_of(grammar_of(testing_report::slow_growth), {.exact_class = 200, .field_degree = 2});
    EXPECT_EQ(document["exactness"], "enclosure");
    EXPECT_EQ(document["field"], nullptr);
    EXPECT_LE(document["ratio"]["lower"].get<double>(), 1.2599210498948732);
    EXPECT_GE(document["ratio"]["upper"].get<double>(), 1.2599210498948732);
}

TEST(ValidationJson, NamesAreInertWhereverTheDocumentIsPasted) {
    const IntervalGrammar grammar = testing_report::hostile_grammar();
    testing_report::expect_inert(validation_json(validate(grammar), grammar, {"0", testing_report::hostile}));
}

} // namespace
} // namespace internode
