// SPDX-License-Identifier: MIT

#include "internode/io/obj/obj_statement.h"

#include "internode/text/ascii.h"
#include "internode/text/diagnostic.h"
#include "internode/text/did_you_mean.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <string>
#include <vector>

namespace internode {

namespace {

struct Keyword {
    std::string_view name;
    ObjStatement statement;
};

constexpr std::array<Keyword, 45> keywords{{
    {"v", ObjStatement::Vertex},         {"vt", ObjStatement::TextureVertex}, {"vn", ObjStatement::Normal},
    {"cstype", ObjStatement::Type},      {"deg", ObjStatement::Degree},       {"curv", ObjStatement::Curve},
    {"surf", ObjStatement::Surface},     {"curv2", ObjStatement::PlaneCurve}, {"parm", ObjStatement::Parameters},
    {"trim", ObjStatement::Trim},        {"hole", ObjStatement::Trim},        {"end", ObjStatement::End},
    {"call", ObjStatement::Foreign},     {"csh", ObjStatement::Foreign},      {"vp", ObjStatement::Other},
    {"bmat", ObjStatement::Other},       {"step", ObjStatement::Other},       {"p", ObjStatement::Other},
    {"l", ObjStatement::Other},          {"f", ObjStatement::Other},          {"fo", ObjStatement::Other},
    {"scrv", ObjStatement::Other},       {"sp", ObjStatement::Other},         {"con", ObjStatement::Other},
    {"g", ObjStatement::Other},          {"s", ObjStatement::Other},          {"mg", ObjStatement::Other},
    {"o", ObjStatement::Other},          {"bevel", ObjStatement::Other},      {"c_interp", ObjStatement::Other},
    {"d_interp", ObjStatement::Other},   {"lod", ObjStatement::Other},        {"maplib", ObjStatement::Other},
    {"usemap", ObjStatement::Other},     {"usemtl", ObjStatement::Other},     {"mtllib", ObjStatement::Other},
    {"shadow_obj", ObjStatement::Other}, {"trace_obj", ObjStatement::Other},  {"ctech", ObjStatement::Other},
    {"stech", ObjStatement::Other},      {"bsp", ObjStatement::Other},        {"bzp", ObjStatement::Other},
    {"cdc", ObjStatement::Other},        {"cdp", ObjStatement::Other},        {"res", ObjStatement::Other},
}};

bool is_blank(char c) {
    return c == ' ' || c == '\t' || c == '\r';
}

} // namespace

void ObjWords::pass_blanks() {
    while (at_ < text_.size()) {
        if (is_blank(text_[at_])) {
            ++at_;
        } else if (text_.substr(at_).starts_with("\\\n")) {
            at_ += 2;
        } else if (text_.substr(at_).starts_with("\\\r\n")) {
            at_ += 3;
        } else {
            return;
        }
    }
}

std::optional<ObjWord> ObjWords::next() {
    pass_blanks();
    if (at_ == text_.size() || text_[at_] == '\n' || text_[at_] == '#') return std::nullopt;
    const std::size_t begin = at_;
    at_ = std::min(text_.find_first_of(" \t\r\n#\\", begin + 1), text_.size());
    return ObjWord{text_.substr(begin, at_ - begin), begin};
}

std::optional<ObjWord> ObjWords::next_statement() {
    if (!started_) {
        started_ = true;
        if (const auto word = next()) return word;
    }
    while (next()) {
    }
    while (at_ < text_.size()) {
        // Here stands a line's end or a comment.
        assert(text_[at_] == '\n' || text_[at_] == '#');
        at_ = std::min(text_.find('\n', at_), text_.size());
        if (at_ < text_.size()) ++at_;
        if (const auto word = next()) return word;
    }
    return std::nullopt;
}

ObjStatement obj_statement(std::string_view keyword) {
    const auto found = std::ranges::find(keywords, keyword, &Keyword::name);
    return found == keywords.end() ? ObjStatement::Unknown : found->statement;
}

std::string obj_did_you_mean(std::string_view keyword) {
    constexpr std::size_t longest = 40; // no statement is longer, and a longer word is none
    std::vector<std::string> names;
    for (const Keyword& known : keywords) names.emplace_back(known.name);
    return did_you_mean(std::string(keyword.substr(0, longest)), names);
}

std::string obj_quoted(std::string_view word) {
    constexpr std::size_t shown = 40;
    return '`' + std::string(word.substr(0, shown)) + (word.size() > shown ? "...`" : "`");
}

std::optional<Rational> parse_obj_decimal(std::string_view text) {
    if (text.find('/') != std::string_view::npos) return std::nullopt;
    if (text.starts_with('+')) {
        text.remove_prefix(1);
        if (text.starts_with('-')) return std::nullopt;
    }
    const std::size_t point = text.find('.');
    const bool bare = point != std::string_view::npos && point > 0 && is_ascii_digit(text[point - 1]) &&
                      (point + 1 == text.size() || text[point + 1] == 'e' || text[point + 1] == 'E');
    if (!bare) return parse_rational(text);
    return parse_rational(std::string(text.substr(0, point)) + std::string(text.substr(point + 1)));
}

} // namespace internode
