// SPDX-License-Identifier: MIT
//
// An option does something where one of its places holds: kind, format and the options beside it. What fails decides
// the message: the kind first, then the options, then the format.

#include "cli/requests/belonging.h"

#include "cli/requests/contains.h"
#include "cli/requests/exit_code.h"
#include "cli/requests/formats.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cassert>

namespace internode::cli {
namespace {

struct KindRow {
    Kind kind;
    std::string_view name;
};

/// A new kind is a row more.
constexpr std::array<KindRow, 3> kinds{{
    {Kind::Intervals, "interval grammars"},
    {Kind::Points, "point grammars"},
    {Kind::Grids, "grids"},
}};

bool holds_for(const Place& place, Kind kind) {
    return place.kinds.empty() || contains(place.kinds, kind);
}

bool has_format(const Place& place, const std::string& format) {
    return place.formats.empty() || contains(place.formats, format);
}

bool any_given(const std::vector<std::string>& names, std::span<const GivenOption> given) {
    return std::ranges::any_of(given, [&names](const GivenOption& option) { return contains(names, option.name); });
}

bool has_company(const Place& place, std::span<const GivenOption> given) {
    return place.with.empty() || any_given(place.with, given);
}

bool holds(const Place& place, std::span<const GivenOption> given, const Situation& here) {
    return holds_for(place, here.kind) && has_company(place, given) && !any_given(place.without, given) &&
           has_format(place, here.format);
}

/// "a", "a and b", "a, b and c".
std::string listed(const std::vector<std::string>& words, std::string_view last) {
    if (words.size() < 2) return words.empty() ? std::string() : words.front();
    const std::vector<std::string> first(words.begin(), words.end() - 1);
    return fmt::format("{} {} {}", fmt::join(first, ", "), last, words.back());
}

const std::string& shown(const GivenOption& option) {
    return option.belonging.called.empty() ? option.name : option.belonging.called;
}

/// The usual message and hint, but where the option has its own.
Failure refusal(const GivenOption& option, Kind kind, const std::string& format, std::string message,
                std::string hint) {
    for (const Refusal& own : option.belonging.refusals) {
        if (!own.kinds.empty() && !contains(own.kinds, kind)) continue;
        if (own.format != format) continue;
        if (!own.message.empty()) message = own.message;
        hint = own.hint;
        break;
    }
    return failure(ExitCode::Usage, message, hint);
}

/// The kinds of all places, in the order of the table; empty where a place takes every kind.
std::vector<std::string> kind_names(const Belonging& belonging) {
    std::vector<std::string> names;
    for (const KindRow& row : kinds)
        if (std::ranges::any_of(belonging.places, [&row](const Place& place) { return holds_for(place, row.kind); }))
            names.emplace_back(row.name);
    if (names.size() == kinds.size()) names.clear();
    return names;
}

Failure foreign(const GivenOption& option, Kind kind) {
    std::vector<std::string> names = kind_names(option.belonging);
    if (contains(names, name_of(Kind::Intervals))) std::erase(names, name_of(Kind::Grids)); // whose grammars they are
    const bool points_only = names == std::vector<std::string>{std::string(name_of(Kind::Points))};
    return refusal(option, kind, {}, fmt::format("{} belongs to {}", shown(option), listed(names, "and")),
                   points_only ? "a text whose first statement is `points NAME`" : "");
}

/// What an option asks for where its kind is right: "--automaton, --format c and --format glsl".
std::vector<std::string> wishes(const GivenOption& option, Kind kind) {
    std::vector<std::string> words;
    for (const Place& place : option.belonging.places) {
        if (!holds_for(place, kind)) continue;
        words.insert(words.end(), place.with.begin(), place.with.end());
        if (!place.with.empty()) continue;
        for (const std::string& format : place.formats) words.push_back("--format " + format);
    }
    return words;
}

std::vector<std::string> called_formats(const std::vector<std::string>& names) {
    std::vector<std::string> called;
    for (const std::string& name : names) {
        assert(find_format(name) != nullptr);
        called.emplace_back(find_format(name)->called);
    }
    return called;
}

Failure idle(const GivenOption& option, std::span<const GivenOption> given, const Situation& here) {
    std::vector<const Place*> near;
    for (const Place& place : option.belonging.places)
        if (holds_for(place, here.kind)) near.push_back(&place);
    assert(!near.empty());
    for (const Place* place : near)
        for (const GivenOption& other : given)
            if (contains(place->without, other.name))
                return refusal(option, here.kind, {},
                               fmt::format("{} does nothing beside {}", shown(option), shown(other)), {});
    const Place& only = *near.front();
    if (near.size() == 1 && has_company(only, given))
        return refusal(option, here.kind, here.format, fmt::format("{} has no {} form", shown(option), here.format),
                       fmt::format("use {}", listed(called_formats(only.formats), "or")));
    const std::vector<std::string> wanted = wishes(option, here.kind);
    return refusal(option, here.kind, {}, fmt::format("{} belongs to {}", shown(option), listed(wanted, "and")),
                   wanted.size() == 1 ? fmt::format("add {}", wanted.front()) : std::string());
}

} // namespace

std::string_view name_of(Kind kind) {
    const auto row = std::ranges::find(kinds, kind, &KindRow::kind);
    assert(row != kinds.end());
    return row->name;
}

std::string heading(const Belonging& belonging) {
    if (belonging.places.empty()) return {};
    std::string text = listed(kind_names(belonging), "and");
    if (!text.empty()) text.front() = static_cast<char>(text.front() - 'a' + 'A');
    return text;
}

void refuse_foreign_options(std::span<const GivenOption> given, Kind kind) {
    for (const GivenOption& option : given) {
        const std::vector<Place>& places = option.belonging.places;
        const auto is_here = [kind](const Place& place) { return holds_for(place, kind); };
        if (!places.empty() && std::ranges::none_of(places, is_here)) throw foreign(option, kind);
    }
}

void refuse_idle_options(std::span<const GivenOption> given, const Situation& here) {
    refuse_foreign_options(given, here.kind);
    for (const GivenOption& option : given) {
        const std::vector<Place>& places = option.belonging.places;
        const auto is_here = [&](const Place& place) { return holds(place, given, here); };
        if (!places.empty() && std::ranges::none_of(places, is_here)) throw idle(option, given, here);
    }
}

} // namespace internode::cli
