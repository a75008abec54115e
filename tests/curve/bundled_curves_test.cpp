// SPDX-License-Identifier: MIT
//
// The curves of data/curves: each can be read, and becomes a curve over the letters of Fibonacci, or over its own
// knots; damage to any of them gets a clear answer (P2).

#include "internode/curve/homogeneous.h"
#include "internode/curve/knot_vector.h"
#include "internode/curve/refinement.h"
#include "internode/io/file/input_file.h"
#include "internode/io/obj/free_form_input.h"
#include "tests/fixtures/random_curve.h"
#include "tests/fixtures/source_folder.h"

#include <algorithm>
#include <filesystem>
#include <gmock/gmock.h>

namespace internode {
namespace {

struct BundledCurve {
    std::string name;
    std::string text;
};

std::vector<BundledCurve> bundled_curves() {
    std::vector<BundledCurve> curves;
    for (const auto& entry : std::filesystem::directory_iterator(tests::in_source_folder("data/curves"))) {
        InputText input = read_input(entry.path().string());
        EXPECT_FALSE(input.error) << entry.path();
        curves.push_back({entry.path().filename().string(), std::move(input.text)});
    }
    std::ranges::sort(curves, {}, [](const BundledCurve& curve) { return curve.text.size(); });
    return curves;
}

bool is_obj(const BundledCurve& curve) {
    return curve.name.ends_with(".obj");
}

ParsedPolygon read(const BundledCurve& curve) {
    if (!is_obj(curve)) return read_polygon(curve.text, curve.name);
    const ParsedFreeForms parsed = read_obj_freeform(curve.text, curve.name);
    if (!parsed.file) return {{}, parsed.errors};
    return {free_form_polygon(*parsed.file, parsed.file->elements.front()), {}};
}

/// The letters L and S are the first and second symbol of the test system.
Word word_of(const std::vector<PlacedText>& letters) {
    Word word;
    for (const PlacedText& letter : letters) {
        EXPECT_THAT(letter.text, testing::AnyOf("L", "S", "0"));
        word.push_back(letter.text == "0" ? zero_interval : to_symbol(letter.text == "L" ? 0 : 1));
    }
    return word;
}

CurveData data_of(const InputPolygon& polygon) {
    CurveData data;
    data.degree = static_cast<int>(polygon.degree.value_or(std::min<std::size_t>(3, polygon.size() - 1)));
    data.ends = polygon.closed.value_or(false) ? Ends::Circular : Ends::Open;
    data.dimension = polygon.dimension;
    data.points = polygon.points;
    const std::size_t letters = polygon.size() + (data.ends == Ends::Open ? static_cast<std::size_t>(data.degree) : 0);
    data.word = polygon.word_letters ? word_of(*polygon.word_letters) : repeated(Word{to_symbol(0)}, letters);
    return data;
}

/// Curves with knots say their own lengths: any rule that only splits serves.
CheckedCurve curve_with_knots(const InputPolygon& polygon) {
    const int degree = static_cast<int>(polygon.degree.value());
    KnotVector vector{.degree = degree, .ends = Ends::Open, .points = polygon.size(), .knots = {}};
    for (const InputNumber& knot : *polygon.knots) vector.knots.emplace_back(knot.front());
    const FittedKnots fitted = fit_knots(tests::system_with({"AA"}), vector);
    if (!fitted.fitted) return {{}, fitted.problems};
    std::vector<double> points = homogeneous(polygon.points, polygon.dimension, polygon.weights);
    return make_curve(fitted.fitted->system,
                      {degree, Ends::Open, fitted.fitted->word, polygon.dimension + 1, std::move(points)});
}

void expect_clear_answer(std::string_view text) {
    const ParsedPolygon parsed = read_polygon(text, "p");
    ASSERT_EQ(parsed.polygon.has_value(), parsed.errors.empty()) << text;
    for (const Diagnostic& error : parsed.errors) {
        ASSERT_FALSE(error.message.empty()) << text;
        ASSERT_TRUE(error.message == "no point" || (error.line >= 1 && error.column >= 1)) << text;
    }
}

TEST(BundledCurves, AreReadAndCanBeRefined) {
    const IntervalSystem fibonacci = tests::fibonacci();
    std::size_t with_word = 0;
    for (const BundledCurve& curve : bundled_curves()) {
        SCOPED_TRACE(curve.name);
        const ParsedPolygon parsed = read(curve);
        ASSERT_TRUE(parsed.polygon);
        const bool is_json = curve.name.ends_with(".json") || is_obj(curve);
        const bool has_knots = parsed.polygon->knots.has_value();
        EXPECT_EQ(parsed.polygon->degree && parsed.polygon->closed && (has_knots || parsed.polygon->word_letters),
                  is_json);
        with_word += is_json ? 1 : 0;
        const CheckedCurve checked =
            has_knots ? curve_with_knots(*parsed.polygon) : make_curve(fibonacci, data_of(*parsed.polygon));
        ASSERT_TRUE(checked.curve) << checked.problems.front();
        EXPECT_EQ(refine(*checked.curve, 3).size(), refined_size(*checked.curve, 3, 100'000).points);
    }
    EXPECT_GE(with_word, 4U);
}

TEST(BundledCurves, GetAClearAnswerWhenTheyAreDamaged) {
    constexpr std::size_t small = 2000; // bytes; the coastline is the only larger one
    for (const BundledCurve& curve : bundled_curves()) {
        if (curve.text.size() > small || is_obj(curve)) continue; // tests/io/obj_freeform_test.cpp damages those
        SCOPED_TRACE(curve.name);
        for (std::size_t i = 0; i < curve.text.size(); ++i) {
            expect_clear_answer(std::string_view(curve.text).substr(0, i));
            for (const char damage : {'\0', '\xFF', '\n', '"'}) {
                std::string damaged = curve.text;
                damaged[i] = damage;
                expect_clear_answer(damaged);
            }
        }
    }
}

} // namespace
} // namespace internode
