// SPDX-License-Identifier: MIT

#include "internode/grammar/expressions/unknown_name.h"

#include "internode/grammar/lexing/limits.h"
#include "internode/text/diagnostic.h"
#include "internode/text/did_you_mean.h"

#include <cassert>

#include <fmt/format.h>

namespace internode {

namespace {

/// Edit distance is slow: it is computed in scopes up to this size only, and not for names so short that every other
/// name is near.
constexpr std::size_t searched_names = 1000;
constexpr std::size_t searched_bytes = 2;

std::string near_name(std::string_view name, const NameScope& scope, std::size_t& searches) {
    const bool is_small = scope.formals().size() + scope.table().size() <= searched_names;
    const bool is_long_enough = name.size() >= searched_bytes && name.size() <= max_name_bytes;
    if (!is_long_enough || !is_small || searches == shown_errors) return {};
    ++searches;
    std::vector<std::string> candidates = scope.formals();
    for (std::string& defined : scope.table().names()) candidates.push_back(std::move(defined));
    candidates.insert(candidates.end(), expression_words().begin(), expression_words().end());
    return did_you_mean(name, candidates);
}

/// How the name could be given a meaning; a long one is not repeated.
std::string how_to_define(const UnknownName& unknown) {
    constexpr std::size_t repeated_bytes = 20;
    const std::string_view name = unknown.name.size() > repeated_bytes ? "a" : unknown.name;
    if (unknown.is_call) return fmt::format("a function is defined: `{}(x) = x/2`", name);
    return fmt::format("a parameter stands before the arrow, as in `P({0})`; a constant is defined: `{0} = 1/2`", name);
}

/// `e` of `1e-3`, `e5` of `2e5`.
bool is_exponent(const UnknownName& unknown) {
    constexpr std::size_t longest = 5;
    const char first = unknown.name.front();
    return unknown.touches_number && (first == 'e' || first == 'E') && unknown.name.size() <= longest;
}

} // namespace

void complain_of(const UnknownName& unknown, const NameScope& scope, std::size_t& searches, Complaints& complaints) {
    assert(!unknown.name.empty());
    const std::string name = quoted(unknown.name);
    const std::optional<std::size_t> defined = scope.table().announced(unknown.name);
    if (defined && *defined <= unknown.place.offset) {
        complaints.add("name.uses-itself", unknown.place, fmt::format("the definition of {} uses itself", name),
                       "definitions use earlier ones only: what repeats is the work of rules");
    } else if (defined) {
        complaints.add("name.defined-later", unknown.place,
                       fmt::format("{} is defined later, in line {}", name, complaints.line_of(*defined)),
                       "definitions use earlier ones only: move it up");
    } else if (is_exponent(unknown)) {
        complaints.add("expression.exponent", unknown.place, fmt::format("{} is no name here", name),
                       "numbers have no exponents: write `0.001`");
    } else {
        const std::string near = near_name(unknown.name, scope, searches);
        complaints.add("name.unknown", unknown.place,
                       fmt::format("{} is no {}", name, unknown.is_call ? "function" : "parameter and no constant"),
                       near.empty() ? how_to_define(unknown) : fmt::format("did you mean `{}`?", near));
    }
}

} // namespace internode
