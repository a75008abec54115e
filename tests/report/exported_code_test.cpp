// SPDX-License-Identifier: MIT
//
// Promise P11: exported code, compiled by somebody else, does what the library does. The same curves are refined by the
// library, by the C header as C and as C++, and by the GLSL snippet as C++; GLSL is also given to its own compiler.

#include "internode/curve/refinement.h"
#include "internode/report/code/automaton_code.h"
#include "internode/word/factors.h"
#include "tests/fixtures/interval_systems.h"
#include "tests/fixtures/random_curve.h"
#include "tests/fixtures/source_folder.h"
#include "tests/report/systems.h"

#include <gmock/gmock.h>

#include <bit>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>

namespace internode {
namespace {

namespace fs = std::filesystem;

constexpr std::uint32_t steps = 3;
const Generator exporter{"0.1.0", "internode masks"};

/// An export and the curves that are refined by it.
struct Case {
    AutomatonExport exported;
    std::string name; ///< of its identifiers
    std::vector<Curve> curves;
};

/// A factor of a far image: words that persist.
Word far_word(const IntervalSystem& system, std::size_t letters) {
    Word word{to_symbol(0)};
    while (word.size() < 40 * letters) word = system.rules()(word);
    const auto middle = word.begin() + static_cast<std::ptrdiff_t>(word.size() / 2);
    return {middle, middle + static_cast<std::ptrdiff_t>(letters)};
}

Curve curve_over(tests::Random& random, const IntervalSystem& system, int degree, Ends ends, const Word& word,
                 std::size_t dimension) {
    CurveData data{degree, ends, word, dimension, {}};
    const std::size_t points = ends == Ends::Open ? word.size() - static_cast<std::size_t>(degree) : word.size();
    // Zeros of both signs among them: a sum that left out a weight of 0 would show by the sign of a zero.
    for (std::size_t i = 0; i < points * dimension; ++i)
        data.points.push_back(i % 7 == 3 ? (i % 2 == 0 ? 0.0 : -0.0) : 100 * random.coordinate());
    return tests::curve_of(system, std::move(data));
}

/// Open and clamped curves by the tables of the words that persist; closed ones, wrapping more than once and with empty
/// intervals, by tables of their own.
void add_cases(std::vector<Case>& cases, const std::string& name, const IntervalSystem& system, int degree) {
    tests::Random random(static_cast<std::uint32_t>(cases.size()) + 7);
    const auto d = static_cast<std::size_t>(degree);
    Case open{export_automaton(name, system, degree, WordChoice::Persistent, max_states), {}, {}};
    Case closed{{name + " closed", system, "word", make_automaton(system, degree, {}, max_states), 1}, {}, {}};
    std::vector<CellState> cells;
    for (std::size_t dimension = 1; dimension <= 4; ++dimension) {
        const Word word = far_word(system, 2 * d + 5 + dimension);
        open.curves.push_back(curve_over(random, system, degree, Ends::Open, word, dimension));
        open.curves.push_back(curve_over(random, system, degree, Ends::Open, clamped(word, degree), dimension));
        Word ring = far_word(system, 2 * dimension - 1);
        if (dimension == 4) ring.insert(ring.begin() + 2, d, zero_interval);
        if (dimension == 3 && degree > 1) ring.push_back(zero_interval);
        closed.curves.push_back(curve_over(random, system, degree, Ends::Circular, ring, dimension));
        const std::vector<CellState> more = cell_states(ring, degree, Ends::Circular);
        cells.insert(cells.end(), more.begin(), more.end());
    }
    closed.exported.automaton = make_automaton(system, degree, cells, max_states);
    for (Case* one : {&open, &closed}) {
        one->name = code_identifier(one->exported.name) + "_" + std::to_string(degree);
        cases.push_back(std::move(*one));
    }
}

const std::vector<Case>& all_cases() {
    static const std::vector<Case> cases = [] {
        std::vector<Case> made;
        const std::multimap<std::string, int> degrees{{"fibonacci", 1},   {"fibonacci", 2},     {"fibonacci", 3},
                                                      {"fibonacci", 5},   {"bisection", 3},     {"tribonacci", 2},
                                                      {"silver-mean", 4}, {"slow-growth-4", 3}, {"period-doubling", 6}};
        for (const auto& [name, system] : tests::bundled_systems())
            for (auto [one, end] = degrees.equal_range(name); one != end; ++one)
                add_cases(made, name, system, one->second);
        return made;
    }();
    return cases;
}

template<typename T>
void put(std::string& bytes, const std::vector<T>& values) {
    bytes.append(reinterpret_cast<const char*>(values.data()), values.size() * sizeof(T));
}

std::string jobs() {
    std::string bytes;
    for (std::uint32_t which = 0; which < all_cases().size(); ++which) {
        const Case& one = all_cases()[which];
        for (const Curve& curve : one.curves) {
            std::vector<std::uint32_t> letters;
            for (const Symbol letter : curve.word())
                letters.push_back(letter == zero_interval ? 0 : static_cast<std::uint32_t>(to_index(letter)) + 1);
            std::vector<std::uint32_t> states;
            for (const CellState& cell : cell_states(curve.word(), curve.degree(), curve.ends()))
                states.push_back(one.exported.automaton.find(cell));
            put<std::uint32_t>(bytes,
                               {which, curve.ends() == Ends::Circular ? 1U : 0U,
                                static_cast<std::uint32_t>(letters.size()), static_cast<std::uint32_t>(states.size()),
                                static_cast<std::uint32_t>(curve.dimension()), steps});
            put(bytes, letters);
            put(bytes, states);
            put(bytes, curve.points());
        }
    }
    return bytes;
}

/// A folder that goes away.
class Folder {
public:
    Folder() {
        std::string pattern = (fs::temp_directory_path() / "internode-exported-XXXXXX").string();
        path_ = ::mkdtemp(pattern.data());
    }
    Folder(const Folder&) = delete;
    Folder& operator=(const Folder&) = delete;
    ~Folder() { fs::remove_all(path_); }
    [[nodiscard]] std::string file(const std::string& name, const std::string& text = {}) const {
        if (!text.empty()) std::ofstream(path_ / name, std::ios::binary) << text;
        return (path_ / name).string();
    }
    [[nodiscard]] std::string read(const std::string& name) const {
        std::ifstream in(path_ / name, std::ios::binary);
        return {std::istreambuf_iterator<char>(in), {}};
    }

private:
    fs::path path_;
};

/// Runs a line of shell; what it says is what a failing test shows.
void expect_success(const Folder& here, const std::string& line) {
    const int code = std::system((line + " >" + here.file("said") + " 2>&1").c_str());
    EXPECT_EQ(code, 0) << line << '\n' << here.read("said");
    if (code == 0) {
        EXPECT_EQ(here.read("said").find("warning"), std::string::npos) << here.read("said");
    }
}

/// Where the machine can run it: promise P11 names -march=haswell, whose fused multiply-adds must not be used.
std::string flags() {
    std::string text = " -O3 -ffp-contract=off -Wall -Wextra -Wshadow -Wconversion -pedantic -Werror";
#if defined(__x86_64__)
    if (__builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma")) text += " -march=haswell";
#endif
    return text;
}

/// Reads what a driver wrote, curve by curve and step by step, and has each number compared.
template<typename Compare>
void expect_output(const std::string& bytes, Compare compare) {
    std::size_t place = 0;
    const auto take = [&]<typename T>(std::vector<T>& values, std::size_t count) {
        ASSERT_LE(place + count * sizeof(T), bytes.size());
        values.resize(count);
        std::memcpy(values.data(), bytes.data() + place, count * sizeof(T));
        place += count * sizeof(T);
    };
    for (const Case& one : all_cases()) {
        for (const Curve& curve : one.curves) {
            SCOPED_TRACE(one.name + ", dimension " + std::to_string(curve.dimension()));
            Refinement refinement(curve);
            for (std::uint32_t step = 0; step <= steps; ++step) {
                std::vector<std::uint32_t> count;
                std::vector<std::uint32_t> states;
                std::vector<double> points;
                take(count, 1);
                ASSERT_FALSE(count.empty());
                ASSERT_EQ(count.front(), refinement.curve().size());
                take(states, count.front());
                take(points, count.front() * curve.dimension());
                const std::vector<CellState> cells =
                    cell_states(refinement.curve().word(), curve.degree(), curve.ends());
                for (std::size_t i = 0; i < states.size(); ++i)
                    ASSERT_EQ(one.exported.automaton.state(states[i]), cells[i]);
                for (std::size_t i = 0; i < points.size(); ++i)
                    ASSERT_TRUE(compare(points[i], refinement.curve().points()[i])) << "step " << step << ", " << i;
                if (step < steps) refinement.step();
            }
        }
    }
    EXPECT_EQ(place, bytes.size());
}

void expect_library_bytes(const std::string& bytes) {
    expect_output(bytes, [](double found, double expected) {
        return std::bit_cast<std::uint64_t>(found) == std::bit_cast<std::uint64_t>(expected);
    });
}

std::string exports_macro() {
    std::string text = "#define EXPORTS(RUN)";
    for (const Case& one : all_cases()) text += " RUN(" + one.name + ")";
    return text + "\n";
}

void expect_the_header_to_agree(const std::string& compiler) {
    const Folder here;
    std::string list;
    for (const Case& one : all_cases()) {
        (void)here.file(one.name + ".h", automaton_c(one.exported, exporter));
        list += "#include \"" + one.name + ".h\"\n";
    }
    (void)here.file("exported.h", list + exports_macro());
    (void)here.file("jobs", jobs());
    const std::string source = tests::in_source_folder("tests/report/exported/run_c.c");
    for (const std::string language : {"-x c -std=c99", "-x c++ -std=c++11"}) {
        SCOPED_TRACE(language);
        const std::string program = here.file("program");
        expect_success(here,
                       compiler + flags() + " -I" + here.file("") + " " + language + " " + source + " -o " + program);
        expect_success(here, program + " " + here.file("jobs") + " " + here.file("out"));
        expect_library_bytes(here.read("out"));
    }
}

TEST(ExportedC, GivesTheLibrarysBytesWithTheCompilerOfTheSystem) {
    expect_the_header_to_agree(INTERNODE_CC);
}

TEST(ExportedC, GivesTheLibrarysBytesWithClang) {
    const std::string clang = INTERNODE_CLANG;
    if (clang.empty()) GTEST_SKIP() << "NO clang HERE: the header was not compiled with it";
    expect_the_header_to_agree(clang);
}

TEST(ExportedC, RefusesWordsThatItsTablesDoNotKnow) {
    const Folder here;
    const IntervalSystem fibonacci = tests::system_of("L->SL, S->L");
    (void)here.file("f.h",
                    automaton_c(export_automaton("f", fibonacci, 2, WordChoice::Persistent, max_states), exporter));
    const std::string source = here.file("main.c", R"(#include "f.h"
static int cells(const char *text, int closed)
{
    f_2_symbol word[32];
    f_2_state states[32];
    size_t letters = 0;
    for (; text[letters]; ++letters) word[letters] = (f_2_symbol)(text[letters] - '0');
    return (int)f_2_cells(word, letters, closed, states);
}
int main(void)
{
    if (cells("11212", 1) != 5 || cells("1121121", 0) != 5 || cells("00112100", 0) != 6) return 1;
    if (cells("222", 1) || cells("", 1) || cells("000", 1) || cells("10002", 1)) return 2; /* not among the words */
    if (cells("1121", 0) || cells("", 0) || cells("1", 0)) return 3;                       /* no domain */
    if (cells("1101211", 0) || cells("1121011", 0)) return 4; /* an empty interval in the domain, or at its ends */
    return 0;
}
)");
    expect_success(here, std::string(INTERNODE_CC) + flags() + " -std=c99 " + source + " -o " + here.file("program"));
    expect_success(here, here.file("program"));
}

TEST(ExportedC, IsCodeWhateverTheNamesAre) {
    const Folder here;
    const IntervalSystem system = validate(testing_report::hostile_grammar()).system.value();
    const AutomatonExport hostile =
        export_automaton(testing_report::hostile, system, 2, WordChoice::Persistent, max_states);
    const Generator bad{"0", testing_report::hostile + " \?\?/ \\"};
    (void)here.file("hostile.h", automaton_c(hostile, bad));
    const std::string source = here.file("main.c", "#include \"hostile.h\"\nint main(void) { return 0; }\n");
    expect_success(here, std::string(INTERNODE_CC) + flags() + " -std=c99 " + source + " -o " + here.file("program"));
    const std::string glslang = INTERNODE_GLSLANG;
    if (glslang.empty()) GTEST_SKIP() << "NO glslangValidator HERE: GLSL was not given to its compiler";
    expect_success(here,
                   glslang + " -S comp " + here.file("hostile.comp", "#version 430\n" + automaton_glsl(hostile, bad)));
}

/// The snippet as C++ of one kind of number; double literals lose the suffix that C++ does not have.
std::string glsl_output(const Folder& here, bool is_double) {
    std::string list;
    for (const Case& one : all_cases()) {
        std::string text = automaton_glsl(one.exported, exporter);
        for (auto at = text.find("lf"); at != std::string::npos; at = text.find("lf", at))
            text.replace(at, 2, text[at - 1] >= '0' && text[at - 1] <= '9' ? "" : "LF");
        (void)here.file(one.name + ".glsl", text);
        list += "DECLARE(" + one.name + ")\n#include \"" + one.name + ".glsl\"\n";
    }
    (void)here.file("exported.h", list + exports_macro());
    (void)here.file("jobs", jobs());
    const std::string source = tests::in_source_folder("tests/report/exported/run_glsl.cpp");
    const std::string program = here.file("program");
    expect_success(here, std::string(INTERNODE_CC) + " -O2 -ffp-contract=off -std=c++17 -I" + here.file("") +
                             (is_double ? " -DINTERNODE_DOUBLE " : " ") + source + " -o " + program + " -lstdc++");
    expect_success(here, program + " " + here.file("jobs") + " " + here.file("out"));
    return here.read("out");
}

TEST(ExportedGlsl, ComputesTheSamePointsToTheAccuracyOfFloat) {
    const Folder here;
    // Coordinates are below 100; a step of convex sums adds less than width + 1 half units of 2^-24 of that.
    constexpr double tolerance = 100 * 0x1p-24 * 8 * (steps + 1);
    expect_output(glsl_output(here, false),
                  [](double found, double expected) { return std::abs(found - expected) <= tolerance; });
}

TEST(ExportedGlsl, ComputesTheSameBytesInDouble) {
    const Folder here;
    expect_library_bytes(glsl_output(here, true));
}

TEST(ExportedGlsl, IsAcceptedByTheReferenceCompiler) {
    const std::string glslang = INTERNODE_GLSLANG;
    if (glslang.empty()) GTEST_SKIP() << "NO glslangValidator HERE: GLSL was not given to its compiler";
    const Folder here;
    for (const Case& one : all_cases()) {
        const std::string text = automaton_glsl(one.exported, exporter);
        expect_success(here, glslang + " -S comp " + here.file("float.comp", "#version 430\n" + text));
        expect_success(here, glslang + " -S comp " +
                                 here.file("double.comp", "#version 430\n#define INTERNODE_DOUBLE\n" + text));
    }
}

} // namespace
} // namespace internode
