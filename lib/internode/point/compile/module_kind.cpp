// SPDX-License-Identifier: MIT

#include "internode/point/compile/module_kind.h"

#include <algorithm>
#include <cassert>

namespace internode {

std::size_t points_in(const ExactModule& module) {
    const auto is_point = [](const ExactValue& value) { return std::holds_alternative<PointSum>(value); };
    return static_cast<std::size_t>(std::ranges::count_if(module.values, is_point));
}

KindTable::KindTable(const PointSystem& system) {
    for (const auto& parameters : system.layout()) {
        std::vector<bool>& is_point = is_point_.emplace_back();
        if (!parameters) continue;
        for (const Extent extent : *parameters) is_point.push_back(extent > 0);
    }
}

std::uint32_t KindTable::of(const ExactModule& module) {
    ModuleKind kind{module.letter, {}};
    for (const ExactValue& value : module.values)
        if (const Rational* number = std::get_if<Rational>(&value)) kind.numbers.push_back(*number);
    const auto [place, is_new] =
        numbers_.try_emplace({kind.letter, kind.numbers}, static_cast<std::uint32_t>(kinds_.size()));
    if (is_new) {
        counts_.push_back(module.values.size() - kind.numbers.size());
        kinds_.push_back(std::move(kind));
    }
    return place->second;
}

ExactModule KindTable::module(std::uint32_t kind, std::ptrdiff_t& next) const {
    assert(kind < kinds_.size());
    ExactModule module{kinds_[kind].letter, {}, 0};
    auto number = kinds_[kind].numbers.begin();
    for (const bool is_point : points_of(module.letter)) {
        if (is_point)
            module.values.emplace_back(PointSum{{{next++, Rational(1)}}});
        else
            module.values.emplace_back(*number++);
    }
    return module;
}

} // namespace internode
