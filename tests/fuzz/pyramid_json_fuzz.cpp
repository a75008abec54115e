// SPDX-License-Identifier: MIT
//
// Any text as a pyramid: refused with a place, or read; and a small one is refused with a sentence or put together to
// as many points as it says.

#include "internode/input/settled_pyramid.h"
#include "internode/io/json/pyramid_json.h"
#include "internode/text/diagnostic.h"
#include "tests/fuzz/require.h"

#include <cstdint>

namespace {

using namespace internode;
using fuzz::require;

/// Small enough that validity and synthesis take no time to speak of; both have fuzz targets and tests of their own.
bool is_small(const InputPyramid& pyramid) {
    std::size_t letters = pyramid.axiom ? pyramid.axiom->letters.size() : 0;
    for (const InputRule& rule : pyramid.rules) letters += 1 + rule.word.size();
    for (const InputLength& length : pyramid.lengths)
        for (const Rational& coefficient : length.coefficients)
            if (to_string(coefficient).size() > 20) return false;
    return letters <= 16 && pyramid.degree <= 4 && pyramid.word.letters.size() <= 60 && pyramid.levels.size() <= 8;
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::string_view text(reinterpret_cast<const char*>(data), size);
    const ParsedPyramid parsed = read_pyramid(text, "fuzz.json");
    require(parsed.pyramid.has_value() == parsed.errors.empty());
    if (!parsed.pyramid) require(!to_string(parsed.errors).empty());
    if (!parsed.pyramid || !is_small(*parsed.pyramid)) return 0;
    const Settled<Pyramid> settled = settle_pyramid(*parsed.pyramid);
    require(settled.value.has_value() == settled.refusal.errors.empty());
    if (!settled.value || (!settled.value->levels.empty() && settled.value->levels.back().points > 500)) return 0;
    const std::size_t points =
        settled.value->levels.empty() ? settled.value->coarse.size() : settled.value->levels.back().points;
    require(synthesise(*settled.value).back().size() == points * settled.value->coarse.dimension());
    return 0;
}
