// SPDX-License-Identifier: MIT

#include "internode/point/module_word.h"

#include "internode/text/number.h"

#include <cassert>

namespace internode {

namespace {

/// A number, or a point in parentheses; what is left of the values.
std::span<const double> append_parameter(std::string& text, std::span<const double> values, Extent extent) {
    const std::size_t width = extent == 0 ? 1 : extent;
    assert(width <= values.size() && "a module has the values of its layout");
    if (extent > 0) text += '(';
    for (std::size_t i = 0; i < width; ++i) {
        if (i > 0) text += ", ";
        append(text, values[i]);
    }
    if (extent > 0) text += ')';
    return values.subspan(width);
}

void append_module(std::string& text, std::string_view name, std::span<const double> values,
                   std::span<const Extent> extents) {
    if (!text.empty()) text += ' ';
    text += name;
    if (values.empty()) return;
    text += '(';
    for (std::size_t k = 0; !values.empty(); ++k) {
        if (k > 0) text += ", ";
        values = append_parameter(text, values, k < extents.size() ? extents[k] : 0);
    }
    text += ')';
}

} // namespace

void ModuleWord::push_back(Symbol letter, std::span<const double> values) {
    letters_.push_back(letter);
    first_.push_back(values_.size());
    values_.insert(values_.end(), values.begin(), values.end());
}

void ModuleWord::reserve(std::size_t modules, std::size_t values) {
    letters_.reserve(modules);
    first_.reserve(modules);
    values_.reserve(values);
}

std::string to_string(const ModuleWord& word, const PointGrammar& grammar, const Layout& layout) {
    std::string text;
    for (std::size_t i = 0; i < word.size(); ++i) {
        const auto& parameters = layout[to_index(word.letter(i))];
        append_module(text, letter_text(grammar, word.letter(i)), word.values(i),
                      parameters ? std::span<const Extent>(*parameters) : std::span<const Extent>());
    }
    return text;
}

} // namespace internode
