// SPDX-License-Identifier: MIT

#include "internode/report/json/masks_json.h"

#include "tests/report/systems.h"

#include <nlohmann/json.hpp>

namespace internode {
namespace {

using nlohmann::json;
using testing_report::system_of;

json document_of(const std::string& grammar, int degree) {
    const MaskTable table = make_mask_table(system_of(grammar), degree, WordChoice::Default, 1000);
    return json::parse(masks_json(table, {"0.1.0", "internode masks"}));
}

TEST(MasksJson, HasThePrintedMaskOfThePaper) {
    const json document = document_of(testing_report::fibonacci, 2);
    EXPECT_EQ(document["format"], "internode-masks");
    EXPECT_EQ(document["words"], "persistent");
    for (const json& entry : document["decompositions"]) {
        EXPECT_EQ(entry["persistent"], true);
        if (entry["word"] != json{"L", "S", "L"}) continue;
        EXPECT_EQ(entry["mask"][0]["word"], (json{"S", "L", "L"}));
        EXPECT_EQ(entry["mask"][0]["weight"], (json{{"value", 0.2360679774997897}, {"exact", {"-3", "2"}}}));
        EXPECT_EQ(entry["mask"][1]["weight"]["exact"], (json{"1", "0"}));
        EXPECT_EQ(entry["mask"][2]["weight"]["exact"], (json{"2", "-1"}));
        return;
    }
    ADD_FAILURE() << "LSL is missing";
}

TEST(MasksJson, ARationalFieldHasOneCoefficient) {
    const json document = document_of("A -> A A", 2);
    EXPECT_EQ(document["field"]["minimal_polynomial"], (json{"-2", "1"}));
    EXPECT_EQ(document["decompositions"][0]["mask"][0]["weight"], (json{{"value", 0.25}, {"exact", {"1/4"}}}));
}

TEST(MasksJson, WindowsReferToWindowsAndHaveLeadingRows) {
    const json document = document_of("A -> A A\naxiom 0 0 A A A 0 0", 2);
    for (const json& window : document["windows"]) {
        EXPECT_EQ(window["word"].size(), 3U);
        EXPECT_EQ(window["leading"].size(), 2U);
        for (const json& child : window["children"]) {
            EXPECT_LT(child["window"].get<std::size_t>(), document["windows"].size());
            EXPECT_EQ(child["weights"].size(), 3U);
        }
    }
}

TEST(MasksJson, NamesAreInert) {
    const MaskTable table =
        make_mask_table(validate(testing_report::hostile_grammar()).system.value(), 2, WordChoice::Default, 1000);
    testing_report::expect_inert(masks_json(table, {"0", testing_report::hostile}));
}

} // namespace
} // namespace internode
