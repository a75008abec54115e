// SPDX-License-Identifier: MIT

#include "internode/grammar/points/letter_table.h"

#include "internode/grammar/lexing/limits.h"

#include <cassert>
#include <optional>
#include <unordered_map>

#include <fmt/format.h>

namespace internode {

namespace {

std::string parameters_of(std::size_t count) {
    return count == 0 ? "no parameter" : fmt::format("{} parameter{}", count, count == 1 ? "" : "s");
}

} // namespace

std::string LetterTable::key(std::string_view name, std::size_t parameters) const {
    const std::optional<Symbol> plain = letters_.find(name);
    const bool is_other = plain && arity_[to_index(*plain)] != parameters;
    return is_other ? fmt::format("{}/{}", name, parameters) : std::string(name);
}

Symbol LetterTable::use(std::string_view name, std::size_t parameters, Use use, Complaints::Place place) {
    const std::string full = key(name, parameters);
    std::optional<Symbol> symbol = letters_.find(full);
    if (!symbol && letters_.size() >= max_point_letters) {
        if (!full_)
            complaints_.add("module.too-many-letters", place, fmt::format("more than {} letters", max_point_letters));
        full_ = true;
        return to_symbol(0);
    }
    if (!symbol) {
        symbol = letters_.add(full);
        arity_.push_back(static_cast<std::uint32_t>(parameters));
        origins_.push_back({place, false, name});
    }
    assert(arity_.size() == letters_.size() && origins_.size() == letters_.size());
    Origin& origin = origins_[to_index(*symbol)];
    origin.made = origin.made || use == Use::Made;
    return *symbol;
}

void LetterTable::note_made(std::string_view name, std::size_t parameters) {
    if (const auto symbol = letters_.find(key(name, parameters))) origins_[to_index(*symbol)].made = true;
}

void LetterTable::finish() {
    std::unordered_map<std::string_view, std::size_t> made; // by letter, the first symbol of it
    for (std::size_t i = 0; i < origins_.size(); ++i)
        if (origins_[i].made) made.try_emplace(origins_[i].name, i);
    for (std::size_t i = 0; i < origins_.size(); ++i) {
        const auto other = made.find(origins_[i].name);
        if (origins_[i].made || other == made.end()) continue;
        const Origin& maker = origins_[other->second];
        complaints_.add("module.other-parameters", origins_[i].place,
                        fmt::format("{} has {} here, but {} where it is made, as in line {}", quoted(maker.name),
                                    parameters_of(arity_[i]), parameters_of(arity_[other->second]),
                                    complaints_.line_of(maker.place.offset)),
                        "a module matches one with the same letter and as many parameters");
    }
}

} // namespace internode
