// SPDX-License-Identifier: MIT

#include "internode/grammar/points/point_input_reader.h"

#include "internode/grammar/lexing/token_split.h"
#include "internode/grammar/points/template_reader.h"

#include <algorithm>

#include <fmt/format.h>

namespace internode {

namespace {

using Tokens = std::span<const Token>;

constexpr std::string_view input_hint = "write `input P(v) E`, or `input P(v, 2) E | P(v, 0) E | P(v, 2)` for the "
                                        "first, each inner and the last point";

class PointInputReader {
public:
    PointInputReader(const Statement& statement, PointContext& context)
        : head_(statement.tokens.front())
        , body_(statement.tokens.subspan(1))
        , context_(context)
        , scope_(context.definitions, UnknownNames::FirstIsFormal) {
        const Complaints::Place place = place_of(statement.tokens);
        input_.place = SourcePlace{place.offset, place.bytes};
    }

    PointInput read() {
        const std::vector<Tokens> parts = split_at(body_, find_outside(body_, context_.text, '|'));
        if (body_.empty())
            refuse("input.empty", place_of(head_), "an empty input", input_hint);
        else if (parts.size() != 1 && parts.size() != 3)
            refuse("input.parts", place_of(body_), fmt::format("an input of {} parts", parts.size()), input_hint);
        else
            read_parts(parts);
        if (!scope_.formals().empty()) input_.formal = scope_.formals().front();
        return std::move(input_);
    }

private:
    void refuse(std::string_view code, Complaints::Place place, std::string message, std::string_view hint = {}) {
        context_.complaints.add(code, place, std::move(message), std::string(hint));
    }

    void read_parts(const std::vector<Tokens>& parts) {
        const bool has_markers =
            parts.size() == 1 && parts[0].size() > 2 && is_marker(parts[0].front()) && is_marker(parts[0].back());
        if (has_markers) {
            input_.first = read_templates(parts[0].first(1), scope_, context_);
            input_.last = input_.first;
            input_.each = read_part(parts[0].subspan(1, parts[0].size() - 2), MayMark::No);
            input_.first.insert(input_.first.end(), input_.each.begin(), input_.each.end());
            input_.last.insert(input_.last.begin(), input_.each.begin(), input_.each.end());
        } else if (parts.size() == 3) {
            input_.first = read_part(parts[0], MayMark::Yes);
            input_.each = read_part(parts[1], MayMark::No);
            input_.last = read_part(parts[2], MayMark::Yes);
        } else {
            input_.each = read_part(parts[0], MayMark::No);
        }
        input_.has_ends = has_markers || parts.size() == 3;
    }

    [[nodiscard]] bool is_marker(const Token& token) const { return is_mark(token, context_.text, '#'); }

    enum class MayMark { No, Yes };

    std::vector<ModuleTemplate> read_part(Tokens tokens, MayMark may_mark) {
        if (tokens.empty()) {
            refuse("input.empty-part", place_of(body_), "an empty part of the input", input_hint);
            return {};
        }
        const auto marker = std::ranges::find_if(tokens, [this](const Token& token) { return is_marker(token); });
        if (may_mark == MayMark::No && marker != tokens.end())
            refuse("input.inner-marker", place_of(*marker), "an end marker beside each point",
                   "write `input # P(v) #`: one marker at each end of the word");
        std::vector<ModuleTemplate> modules = read_templates(tokens, scope_, context_);
        if (context_.complaints.empty() && !uses_point(modules))
            refuse("input.point-unused", place_of(tokens), "the input does not use its point",
                   "the point is a name that is no constant: `input P(v)`");
        return modules;
    }

    static bool uses_point(const std::vector<ModuleTemplate>& modules) {
        const auto is_formal = [](Instruction instruction) { return instruction.operation == Operation::Formal; };
        for (const ModuleTemplate& module : modules)
            for (const Expression& argument : module.arguments)
                if (std::ranges::any_of(argument.code, is_formal)) return true;
        return false;
    }

    Token head_;
    Tokens body_;
    PointContext& context_;
    NameScope scope_;
    PointInput input_;
};

} // namespace

PointInput read_point_input(const Statement& statement, PointContext& context) {
    return PointInputReader(statement, context).read();
}

} // namespace internode
