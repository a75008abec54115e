// SPDX-License-Identifier: MIT

#include "internode/interval/reasons.h"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <numeric>
#include <optional>

namespace internode {

namespace {

/// Longer classes are named by their first symbols and their number.
constexpr std::size_t named_symbols = 8;

class Writer {
public:
    explicit Writer(const Diagnosis& diagnosis)
        : diagnosis_(diagnosis) {
        assert(diagnosis.radii.size() == diagnosis.graph.classes.size());
        assert(diagnosis.largest.order.size() == diagnosis.radii.size());
    }

    [[nodiscard]] std::string name(std::size_t index) const {
        const auto& members = one(index).members;
        std::string text = "{";
        for (std::size_t i = 0; i < members.size() && i < named_symbols; ++i)
            text += (i > 0 ? ", " : "") + diagnosis_.names.name(to_symbol(members[i]));
        if (members.size() > named_symbols) text += fmt::format(", … ({} symbols)", members.size());
        return text + "}";
    }

    [[nodiscard]] std::string ratio(std::size_t index, int digits = 6) const {
        const ClassRadius& radius = diagnosis_.radii[index];
        const Enclosure& bounds = radius.value.bounds;
        if (radius.field) return fmt::format("{:.{}g}", radius.value.value, digits);
        return fmt::format("between {} and {}", bounds.lower, bounds.upper);
    }

    /// As many digits as it takes to see that the two differ.
    [[nodiscard]] std::pair<std::string, std::string> ratios(std::size_t a, std::size_t b) const {
        int digits = 6;
        while (digits < 17 && ratio(a, digits) == ratio(b, digits)) ++digits;
        return {ratio(a, digits), ratio(b, digits)};
    }

    [[nodiscard]] Reason reason(ReasonCode code, const std::vector<std::size_t>& classes, std::string message) const {
        Reason result{code, {}, std::move(message)};
        for (const std::size_t index : classes)
            for (const std::uint32_t member : one(index).members) result.symbols.push_back(to_symbol(member));
        return result;
    }

    [[nodiscard]] const IntervalClass& one(std::size_t index) const { return diagnosis_.graph.classes[index]; }

private:
    const Diagnosis& diagnosis_;
};

bool is_basic(const Diagnosis& diagnosis, std::size_t index) {
    return diagnosis.largest.order[index] == std::partial_ordering::equivalent;
}

bool is_decided(const Diagnosis& diagnosis) {
    return std::ranges::none_of(diagnosis.largest.order,
                                [](std::partial_ordering order) { return order == std::partial_ordering::unordered; });
}

/// A final class of the largest ratio if there is one.
std::size_t strongest(const Diagnosis& diagnosis) {
    for (std::size_t i = 0; i < diagnosis.radii.size(); ++i)
        if (is_basic(diagnosis, i) && diagnosis.graph.classes[i].final) return i;
    return diagnosis.largest.index;
}

Reason too_small(const Diagnosis& diagnosis, const Writer& writer, std::size_t index) {
    const std::size_t other = strongest(diagnosis);
    const auto [own, largest] = writer.ratios(index, other);
    if (!splits(writer.one(index)))
        return writer.reason(ReasonCode::NeverSplits, {index},
                             fmt::format("class {} never splits (its own ratio is 1) but the system's ratio is {}",
                                         writer.name(index), largest));
    if (writer.one(other).final)
        return writer.reason(ReasonCode::FinalDisagree, {index, other},
                             fmt::format("classes {} (ratio {}) and {} (ratio {}) are both final and cannot share one "
                                         "ratio",
                                         writer.name(index), own, writer.name(other), largest));
    return writer.reason(ReasonCode::FinalTooSmall, {index},
                         fmt::format("class {} (ratio {}) produces only itself but the system's ratio is {}, that of "
                                     "class {}",
                                     writer.name(index), own, largest, writer.name(other)));
}

/// For each class the first basic class that it produces, itself excepted.
std::vector<std::optional<std::size_t>> produced_basic(const Diagnosis& diagnosis) {
    std::vector<std::optional<std::size_t>> result(diagnosis.radii.size());
    for (std::size_t i = 0; i < result.size(); ++i) {
        for (const std::uint32_t successor : diagnosis.graph.classes[i].successors) {
            if (result[i]) break;
            assert(successor < i && "successors come first");
            result[i] = is_basic(diagnosis, successor) ? std::optional<std::size_t>(successor) : result[successor];
        }
    }
    return result;
}

/// Class indices by first symbol.
std::vector<std::size_t> reading_order(const ClassGraph& graph) {
    std::vector<std::size_t> order(graph.classes.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::ranges::sort(order, {}, [&](std::size_t i) { return graph.classes[i].members.front(); });
    return order;
}

} // namespace

std::vector<Reason> refutations(const Diagnosis& diagnosis) {
    const Writer writer(diagnosis);
    const bool decided = is_decided(diagnosis);
    const auto produced = produced_basic(diagnosis);
    std::vector<Reason> reasons;
    for (const std::size_t index : reading_order(diagnosis.graph)) {
        if (writer.one(index).final && diagnosis.largest.order[index] == std::partial_ordering::less)
            reasons.push_back(too_small(diagnosis, writer, index));
        else if (decided && is_basic(diagnosis, index) && produced[index])
            reasons.push_back(writer.reason(
                ReasonCode::BasicNotFinal, {index, *produced[index]},
                fmt::format("class {} (ratio {}) also produces class {} of the same ratio: no finite length fits",
                            writer.name(index), writer.ratio(index), writer.name(*produced[index]))));
    }
    const IntervalClass& largest = writer.one(diagnosis.largest.index);
    if (decided && !splits(largest))
        reasons.push_back(writer.reason(ReasonCode::RatioOne, {diagnosis.largest.index},
                                        "ρ = 1: lengths cannot shrink geometrically"));
    return reasons;
}

std::vector<Reason> overlaps(const Diagnosis& diagnosis) {
    const Writer writer(diagnosis);
    std::vector<Reason> reasons;
    const std::size_t largest = diagnosis.largest.index;
    for (const std::size_t index : reading_order(diagnosis.graph)) {
        if (diagnosis.largest.order[index] != std::partial_ordering::unordered) continue;
        reasons.push_back(writer.reason(ReasonCode::Overlap, {index, largest},
                                        fmt::format("the ratios of classes {} ({}) and {} ({}) could not be told apart",
                                                    writer.name(index), writer.ratio(index, 17), writer.name(largest),
                                                    writer.ratio(largest, 17))));
    }
    return reasons;
}

} // namespace internode
