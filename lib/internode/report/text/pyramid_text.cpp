// SPDX-License-Identifier: MIT

#include "internode/report/text/pyramid_text.h"

#include "internode/report/text/text_table.h"
#include "internode/text/diagnostic.h"
#include "internode/text/printable.h"

#include <algorithm>
#include <cassert>
#include <fmt/format.h>

namespace internode {

namespace {

/// G from which a warning is worth a line: clamped and closed polygons stay below.
constexpr double large_gain = 10;

std::string heading(const PyramidReport& report) {
    const Curve& coarse = report.analysis.pyramid.coarse;
    const std::string& name = coarse.system().grammar().name;
    const auto& [method, window] = report.analysis.pyramid.options;
    const std::size_t levels = report.analysis.pyramid.levels.size();
    return fmt::format("{}, degree {}: {} {} down, {}\n", name.empty() ? "The system" : printable(name),
                       coarse.degree(), levels, levels == 1 ? "level" : "levels",
                       method == ReverseMethod::Local ? fmt::format("local filters on {} intervals", window)
                                                      : std::string("least squares"));
}

/// The first letters of the coarse word.
std::string coarse_word(const Curve& coarse) {
    constexpr std::size_t shown = 24;
    const WordView word(coarse.word());
    std::string text = printable(to_string(word.first(std::min(shown, word.size())), coarse.system().alphabet()));
    if (word.size() > shown) text += "…";
    return fmt::format("{} ({} {}, {})", text, word.size(), word.size() == 1 ? "letter" : "letters",
                       coarse.ends() == Ends::Circular  ? "closed"
                       : has_loose_ends(coarse.knots()) ? "open"
                                                        : "clamped");
}

/// Finest level first, as the polygon is taken apart.
std::string levels_table(const PyramidReport& report) {
    const Pyramid& pyramid = report.analysis.pyramid;
    assert(report.errors.approximations.size() == pyramid.levels.size() + 1);
    assert(report.errors.round_trips.size() == report.errors.approximations.size());
    TextTable table(std::vector<Align>(9, Align::Right), 2, 2);
    table.row({"level", "points", "details", "kept", "longest", "G", "max error", "rms error", "round trip"});
    for (std::size_t level = pyramid.levels.size() + 1; level-- > 0;) {
        std::vector<std::string> cells{
            std::to_string(level), std::to_string(report.analysis.polygons[level].size() / pyramid.coarse.dimension()),
            "-", "-", "-"};
        if (level > 0) {
            const std::vector<double> lengths =
                lengths_of(pyramid.levels[level - 1].details, pyramid.coarse.dimension());
            cells[2] = std::to_string(lengths.size());
            cells[3] = std::to_string(report.kept.levels[level - 1].details.points.size());
            if (!lengths.empty()) cells[4] = rounded(*std::ranges::max_element(lengths));
        }
        cells.push_back(rounded(report.analysis.gains[level]));
        cells.push_back(rounded(report.errors.approximations[level].largest));
        cells.push_back(rounded(report.errors.approximations[level].root_mean_square));
        cells.push_back(rounded(report.errors.round_trips[level].largest));
        table.row(std::move(cells));
    }
    return table.text();
}

std::string kept_sentence(const PyramidReport& report) {
    const std::size_t all = detail_count(report.analysis.pyramid);
    const std::size_t kept = detail_count(report.kept);
    return fmt::format("{} of {} details kept, {} of {} vectors with the coarse points: largest error {}, root mean "
                       "square {}",
                       kept, all, kept + report.kept.coarse.size(), all + report.kept.coarse.size(),
                       rounded(report.errors.kept.largest), rounded(report.errors.kept.root_mean_square));
}

} // namespace

std::string pyramid_text(const PyramidReport& report) {
    std::string text = heading(report);
    text += fmt::format("\n  polygon      {}\n", to_string(report.fitting));
    text += fmt::format("  coarse word  {}\n\n", coarse_word(report.analysis.pyramid.coarse));
    text += levels_table(report);
    text += "\n  details   one vector per inserted knot; longest: of those of the step to this level\n";
    text += "  errors    of this level alone, refined without details, from the fine polygon\n";
    text += "  G         noise gain: the size of this level over that of the fine polygon\n";
    text += fmt::format("\n  {}\n", wrapped(kept_sentence(report), 2));
    return text;
}

std::string loose_ends_warning(const PyramidReport& report) {
    if (!has_loose_ends(report.kept.coarse.knots()) || report.analysis.gains.front() < large_gain) return {};
    return fmt::format("open ends are ill-conditioned: the noise gain is G = {}; clamped ends keep it near 1",
                       rounded(report.analysis.gains.front()));
}

} // namespace internode
