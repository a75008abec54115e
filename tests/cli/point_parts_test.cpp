// SPDX-License-Identifier: MIT
//
// Several polygons in one file under a point grammar: each is refined as if it stood alone, and all are written in the
// structure that they came in.

#include "tests/cli/command.h"
#include "tests/fixtures/stride.h"

#include "internode/grammar/bundled.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <sstream>

namespace internode::tests {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

std::vector<std::string> lines_of(const std::string& text) {
    std::vector<std::string> lines;
    std::istringstream stream(text);
    for (std::string line; std::getline(stream, line);) lines.push_back(line);
    return lines;
}

std::string after_first_line(const std::string& text) {
    return text.substr(text.find('\n') + 1);
}

/// Vertices of an OBJ and its polylines; indices count from `before` vertices on.
std::string obj_body(const std::string& text, std::size_t before) {
    std::string body;
    for (const std::string& line : lines_of(text)) {
        if (line.starts_with('#')) continue;
        std::istringstream words(line);
        std::string word;
        words >> word;
        body += word;
        while (words >> word) body += ' ' + (line.starts_with('v') ? word : std::to_string(std::stoul(word) + before));
        body += '\n';
    }
    return body;
}

std::size_t vertices_of(const std::string& text) {
    const std::vector<std::string> lines = lines_of(text);
    return static_cast<std::size_t>(
        std::ranges::count_if(lines, [](const std::string& line) { return line.starts_with("v "); }));
}

/// JSON without indentation and without the command that wrote it.
std::string json_body(const std::string& text) {
    std::string body;
    for (const std::string& line : lines_of(text))
        if (line.find("\"generator\"") == std::string::npos) body += line.substr(line.find_first_not_of(' ')) + '\n';
    return body;
}

/// How a format holds several results: from those of each part alone, in order.
using Joined = std::string (*)(const std::vector<std::string>& alone);

std::string joined_csv(const std::vector<std::string>& alone) {
    std::string text = alone[0];
    for (std::size_t i = 1; i < alone.size(); ++i) text += '\n' + after_first_line(alone[i]);
    return text;
}

/// The heads of gmt.csv.
std::string joined_gmt(const std::vector<std::string>& alone) {
    std::string text = alone[0].substr(0, alone[0].find('\n') + 1);
    for (std::size_t i = 0; i < alone.size(); ++i)
        text += "> part " + std::to_string(i + 1) + '\n' + after_first_line(alone[i]);
    return text;
}

std::string joined_obj(const std::vector<std::string>& alone) {
    std::string text;
    std::size_t before = 0;
    for (const std::string& one : alone) {
        text += obj_body(one, before);
        before += vertices_of(one);
    }
    return text;
}

std::string joined_json(const std::vector<std::string>& alone) {
    std::string text = "{\n\"format\": \"internode-parts\",\n\"version\": 1,\n\"parts\": [\n";
    for (std::size_t i = 0; i < alone.size(); ++i) {
        std::string one = json_body(alone[i]);
        one.pop_back();
        text += one + (i + 1 < alone.size() ? ",\n" : "\n");
    }
    return text + "]\n}\n";
}

std::string joined_text(const std::vector<std::string>& alone) {
    std::string text;
    for (const std::string& one : alone) text += one;
    return text;
}

std::string joined_traces(const std::vector<std::string>& alone) {
    std::string text;
    for (std::size_t i = 0; i < alone.size(); ++i) text += (i > 0 ? "\n" : "") + alone[i];
    return text;
}

std::string as_it_is(const std::string& text) {
    return text;
}
std::string obj_itself(const std::string& text) {
    return obj_body(text, 0);
}

class PointParts : public testing::Test {
protected:
    void SetUp() override {
        here.file("three.csv", "x,y\n0,0\n4,0\n4,3\n0,3\n\n9,1\n12,1\n13,4\n12,6\n10,7\n8,3\n\n0,9\n3,8\n6,9\n7,11\n"
                               "6,14\n3,15\n1,14\n-1,11\n");
        here.file("gmt.csv", "> part 1\n0,0\n4,0\n4,3\n0,3\n> part 2\n9,1\n12,1\n13,4\n12,6\n10,7\n8,3\n> part 3\n"
                             "0,9\n3,8\n6,9\n7,11\n6,14\n3,15\n1,14\n-1,11\n");
        here.file("three.obj", "v 0 0 1\nv 4 0 2\nv 4 3 1\nv 0 3 0\nl 1 2 3 4\nv 9 1 0\nv 12 1 0\nv 13 4 5\nv 12 6 0\n"
                               "l 5 6 7 8\nv 0 9 1\nv 3 8 1\nv 6 9 1\nv 7 11 2\nv 6 14 1\nv 3 15 1\nv 1 14 1\n"
                               "v -1 11 1\nl 9 10 11 12 13 14 15 16\n");
        here.file("three.json", R"({"format": "internode-curves", "version": 1, "curves": [)"
                                R"([[0, 0], [4, 0], [4, 3], [0, 3]], [[9, 1], [12, 1], [13, 4], [12, 6]], )"
                                R"([[0, 9], [3, 8], [6, 9], [7, 11], [6, 14], [3, 15]]]})");
    }
    Outcome run(std::vector<std::string> arguments) const {
        arguments.insert(arguments.begin(), "subdivide");
        return here.run(arguments);
    }
    std::string out(const std::vector<std::string>& arguments) const {
        const Outcome outcome = run(arguments);
        EXPECT_EQ(outcome.code, 0) << testing::PrintToString(arguments) << outcome.err;
        return outcome.out;
    }
    void refuses(const std::vector<std::string>& arguments, const std::string& message) const {
        expect_refused(run(arguments), arguments, message);
    }
    /// Whether every part alone gives what all of them together give; false where some part alone is refused, and then
    /// all of them are.
    bool agrees(const std::vector<std::string>& job, Joined joined, std::string (*body)(const std::string&)) const {
        std::vector<std::string> alone;
        bool refused = false;
        for (const char* element : {"1", "2", "3"}) {
            std::vector<std::string> one = job;
            one.insert(one.end(), {"--element", element});
            const Outcome outcome = run(one);
            refused = refused || outcome.code != 0;
            alone.push_back(outcome.out);
        }
        const Outcome all = run(job);
        EXPECT_EQ(all.code != 0, refused) << testing::PrintToString(job) << all.err;
        if (refused) {
            EXPECT_EQ(all.out, "") << testing::PrintToString(job);
            return false;
        }
        EXPECT_EQ(body(all.out), joined(alone)) << testing::PrintToString(job);
        return true;
    }
    Workspace here;
};

TEST_F(PointParts, AreRefinedEachAsIfItStoodAlone) {
    std::size_t rings = 0;
    std::size_t open = 0;
    const auto grammars = bundled_grammars(GrammarKind::Points);
    for (std::size_t i = 0; i < grammars.size(); i += stride()) {
        const BundledGrammar& grammar = grammars[i];
        const std::string name = '@' + std::string(grammar.name);
        if (!agrees({name, "three.csv", "-n", "2", "--format", "csv"}, joined_csv, as_it_is)) continue;
        ++(grammar.text.find("\nring") == std::string_view::npos ? open : rings);
        EXPECT_TRUE(agrees({name, "gmt.csv", "-n", "1", "--format", "csv"}, joined_gmt, as_it_is)) << name;
        EXPECT_TRUE(agrees({name, "three.csv", "-n", "1", "--format", "text"}, joined_text, as_it_is)) << name;
        EXPECT_TRUE(agrees({name, "three.csv", "-n", "2", "--trace"}, joined_traces, as_it_is)) << name;
        EXPECT_TRUE(agrees({name, "three.json", "-n", "2", "--json"}, joined_json, json_body)) << name;
        // Points in space are more than some rules have formals for.
        agrees({name, "three.obj", "-n", "2", "--format", "obj"}, joined_obj, obj_itself);
    }
    EXPECT_GE(rings + open, 1U);
    if (!in_full()) return;
    EXPECT_GE(rings, 12U);
    EXPECT_GE(open, 6U);
}

TEST_F(PointParts, AreTheSameCompiledAndInterpreted) {
    for (const char* name : {"@s0/13", "@four-point", "@s0/34-36"})
        for (const char* way : {"-v", "--interpreter"}) {
            EXPECT_TRUE(agrees({name, "three.csv", "-n", "3", way}, joined_csv, as_it_is)) << name;
            EXPECT_TRUE(agrees({name, "three.obj", "-n", "1", "--format", "obj", way}, joined_obj, obj_itself)) << name;
        }
}

TEST_F(PointParts, DrawTheirNumbersEachFromTheBeginning) {
    for (const char* seed : {"0", "7"})
        EXPECT_TRUE(agrees({"@midpoint-displacement", "three.csv", "-n", "3", "--seed", seed}, joined_csv, as_it_is));
    here.file("twins.csv", "0,0\n4,0\n4,3\n0,3\n\n0,0\n4,0\n4,3\n0,3\n");
    const std::string twins = after_first_line(out({"@midpoint-displacement", "twins.csv", "-n", "3", "--seed", "7"}));
    const auto blank = twins.find("\n\n");
    EXPECT_EQ(twins.substr(0, blank + 1), twins.substr(blank + 2)) << "equal polygons become equal polygons";
    EXPECT_NE(twins, after_first_line(out({"@midpoint-displacement", "twins.csv", "-n", "3", "--seed", "8"})));
}

TEST_F(PointParts, KeepPhasesConstantsAndWeights) {
    EXPECT_TRUE(agrees({"@s0/38", "three.csv", "-n", "1", "--phase", "1"}, joined_csv, as_it_is));
    EXPECT_TRUE(agrees({"@four-point", "three.csv", "-n", "2", "--set", "w=1/10"}, joined_csv, as_it_is));
    here.file("weights.csv", "0,0,1\n4,0,2\n4,3,1\n\n9,1,1\n12,1,1\n13,4,1\n12,6,3\n\n0,9,1\n3,8,2\n6,9,1\n");
    EXPECT_TRUE(agrees({"@s0/13", "weights.csv", "-n", "2", "--rational"}, joined_csv, as_it_is));
    EXPECT_THAT(out({"@s0/13", "weights.csv", "-n", "2", "--rational"}), HasSubstr("x,y,w\n"));
    EXPECT_TRUE(agrees({"@s0/13", "weights.csv", "-n", "2", "--rational", "--json"}, joined_json, json_body));
    EXPECT_TRUE(agrees({"@s0/13", "weights.csv", "-n", "2", "--rational", "--format", "obj"}, joined_obj, obj_itself));
}

TEST_F(PointParts, ThatTheCommandWroteAreReadBack) {
    const std::string once = out({"@s0/13", "three.csv", "-n", "2"});
    ASSERT_EQ(run({"@s0/13", "three.csv", "-n", "1", "-o", "one.csv"}).code, 0);
    EXPECT_EQ(out({"@s0/13", "one.csv", "-n", "1"}), once);
    ASSERT_EQ(run({"@s0/13", "three.csv", "-n", "1", "-o", "one.obj"}).code, 0);
    ASSERT_EQ(run({"@s0/13", "three.csv", "-n", "2", "-o", "two.obj"}).code, 0);
    EXPECT_EQ(obj_body(out({"@s0/13", "one.obj", "-n", "1", "--format", "obj"}), 0), obj_body(here.read("two.obj"), 0));
}

TEST_F(PointParts, OfSeveralDimensionsStandTogetherWhereTheFormatHoldsThem) {
    here.file("mixed.json", R"({"format": "internode-curves", "curves": [[[0], [1], [4]], [[0, 0], [4, 0], [4, 3]],)"
                            R"( {"points": [[0, 0, 1], [4, 0, 1], [4, 3, 1]], "weights": [1, 2, 1]}]})");
    EXPECT_TRUE(agrees({"@s0/13", "mixed.json", "-n", "1", "--json"}, joined_json, json_body));
    EXPECT_TRUE(agrees({"@s0/13", "mixed.json", "-n", "1", "--format", "obj"}, joined_obj, obj_itself));
    EXPECT_TRUE(agrees({"@s0/13", "mixed.json", "-n", "1", "--format", "text"}, joined_text, as_it_is));
    refuses({"@s0/13", "mixed.json", "-n", "1", "--format", "csv"}, "one polygon has 1 columns, another 2");
    refuses({"@s0/13", "mixed.json", "-n", "1", "--svg"}, "polygons of one coordinate and of more");
}

TEST_F(PointParts, AreRefusedWhereOneIsMeant) {
    for (const std::vector<std::string>& job :
         {std::vector<std::string>{"--format", "npy"}, std::vector<std::string>{"--tree"}}) {
        std::vector<std::string> arguments{"@s0/13", "three.csv", "-n", "1"};
        arguments.insert(arguments.end(), job.begin(), job.end());
        refuses(arguments, "holds one polygon, the file has 3");
        refuses(arguments, "--element 1 … 3");
        arguments.insert(arguments.end(), {"--element", "2"});
        EXPECT_EQ(run(arguments).code, 0);
    }
    refuses({"@s0/13", "three.csv", "-n", "1", "--element", "4"}, "no element 4: three.csv has 3");
}

TEST_F(PointParts, ThatDoNotFitAreRefusedWithTheirLine) {
    here.file("twice.csv", "0,0\n4,0\n4,3\n\n9,1\n12,1\n13,4\n9,1\n");
    refuses({"@s0/13", "twice.csv", "-n", "1"}, "twice.csv:5: error: the last of the 4 points");
    here.file("ends.json", "{\"format\": \"internode-curves\", \"curves\": [\n{\"points\": [[0, 0], [1, 0]]},\n"
                           "{\"points\": [[0, 0], [1, 0]], \"closed\": false}]}");
    refuses({"@s0/13", "ends.json", "-n", "1"}, "ends.json:3: error: \"closed\": false");
    here.file("weights.csv", "0,0,1\n4,0,2\n\n9,1,1\n12,1,-1\n");
    refuses({"@s0/13", "weights.csv", "-n", "1", "--rational"}, "weights.csv:4: error: the weight of point 2");
    here.file("zero.csv", "1,1\n2,2\n\n3,3\n0,1\n");
    refuses({"-e", "points; P(v) -> P((1/v.x) v)", "zero.csv", "-n", "1", "-q"}, "this is part 2 of zero.csv");
}

TEST_F(PointParts, CountTogetherForThePlanAndItsLimit) {
    EXPECT_THAT(out({"@s0/13", "three.csv", "-n", "3", "--plan"}),
                AllOf(HasSubstr("modules 144\nsteps 3\n"), HasSubstr("compiled to 3 states, 6 rows")));
    for (const char* way : {"-v", "--interpreter"}) {
        refuses({"@s0/13", "three.csv", "-n", "3", "--max-modules", "143", way},
                "after 3 cycles the words of 3 parts would have 144 modules; 143 are allowed");
        EXPECT_EQ(run({"@s0/13", "three.csv", "-n", "3", "--max-modules", "144", way}).code, 0);
    }
    for (const char* output : {"--svg", "--trace"}) {
        refuses({"@s0/13", "three.csv", "-n", "3", "--max-modules", "143", output}, "144 modules");
        EXPECT_EQ(run({"@s0/13", "three.csv", "-n", "3", "--max-modules", "144", output}).code, 0);
    }
    refuses({"@s0/13", "three.csv", "-n", "3", "--max-modules", "17", "--json"}, "144 modules");
}

/// Of words whose length is known only when they are there, each part takes what those before have left.
TEST_F(PointParts, CountTogetherWhereNoLengthIsKnownBeforehand) {
    const std::string grow = "points; P(v) : v.x > 3 -> P(v) P(v); P(v) -> P(v)"; // 6 + 12 + 11 modules
    EXPECT_THAT(out({"-e", grow, "three.csv", "-n", "1", "--plan"}), HasSubstr("modules not known beforehand"));
    for (const std::vector<std::string>& more :
         {std::vector<std::string>{}, {"--format", "text"}, {"--svg"}, {"--trace"}}) {
        std::vector<std::string> job{"-e", grow, "three.csv", "-n", "1"};
        job.insert(job.end(), more.begin(), more.end());
        job.insert(job.end(), {"--max-modules", "29"});
        EXPECT_EQ(run(job).code, 0) << testing::PrintToString(job);
        job.back() = "28";
        const Outcome outcome = run(job);
        EXPECT_EQ(outcome.code, 3) << testing::PrintToString(job);
        EXPECT_THAT(outcome.err, AllOf(HasSubstr("the word would have 11 modules, more than 10"),
                                       HasSubstr("this is part 3 of three.csv")));
    }
}

TEST_F(PointParts, WithoutAPointAreRefusedByTheirNumber) {
    const std::string some = "points; P(v) : v.x < 8 -> P(v); P(v) -> A(1)"; // the second part keeps no point
    refuses({"-e", some, "three.csv", "-n", "1", "--element", "2"}, "no module of the last word has exactly one point");
    here.file("far.csv", "0,0\n1,0\n\n9,9\n10,9\n");
    refuses({"-e", some, "far.csv", "-n", "1"}, "no module of the last word of part 2 has exactly one point");
    EXPECT_EQ(out({"-e", some, "far.csv", "-n", "1", "--format", "text"}), "P((0, 0)) P((1, 0))\nA(1) A(1)\n");
}

} // namespace
} // namespace internode::tests
