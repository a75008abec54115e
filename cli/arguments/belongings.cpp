// SPDX-License-Identifier: MIT

#include "cli/arguments/belongings.h"

#include <fmt/format.h>

namespace internode::cli {

std::string rules_say_everything() {
    return "the rules of a point grammar say everything";
}

Belonging for_intervals(const std::string& hint) {
    return {.places = {{.kinds = {Kind::Intervals}}}, .refusals = {{.kinds = {Kind::Points}, .hint = hint}}};
}

Belonging for_points(std::vector<std::string> without) {
    return {.places = {{.kinds = {Kind::Points}, .without = std::move(without)}}};
}

Belonging for_curves(const std::string& hint, const std::string& name) {
    Belonging belonging = for_intervals(hint);
    belonging.refusals.push_back(
        {.kinds = {Kind::Grids},
         .message = fmt::format("{} cannot stand beside --u and --v", name),
         .hint = "words are --word-u and --word-v, ends and weights stand in the grid's JSON"});
    return belonging;
}

Belonging for_grids(const std::string& what) {
    return {
        .places = {{.kinds = {Kind::Grids}}},
        .refusals = {{.message = fmt::format("only a grid has {}", what), .hint = "give their grammars: --u G --v G"}}};
}

} // namespace internode::cli
