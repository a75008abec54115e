// SPDX-License-Identifier: MIT
//
// What the names in the expressions of a point grammar stand for: a formal parameter first, then a constant or a
// function that an earlier statement defines.

#pragma once

#include "internode/expression/definition.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

namespace internode {

struct NameMeaning {
    enum class Kind { Unknown, Formal, Constant, Function };
    Kind kind = Kind::Unknown;
    std::uint32_t index = 0; ///< number of the formal or the definition
};

/// The constants and functions read so far, and the names of those to come.
class DefinitionTable {
public:
    /// Says that a statement at that place defines the name. The first place of a name is kept.
    void announce(std::string_view name, std::size_t offset);
    [[nodiscard]] std::optional<std::size_t> announced(std::string_view name) const;

    /// The name must not be there yet.
    void add(Definition definition);
    [[nodiscard]] NameMeaning find(std::string_view name) const;
    [[nodiscard]] const Definition& operator[](std::uint32_t index) const { return definitions_[index]; }
    [[nodiscard]] std::size_t size() const { return definitions_.size(); }
    [[nodiscard]] std::vector<Definition> definitions() && { return std::move(definitions_); }
    [[nodiscard]] std::vector<std::string> names() const;

private:
    std::vector<Definition> definitions_;
    std::unordered_map<std::string, std::uint32_t> index_;
    std::unordered_map<std::string, std::size_t> announced_;
};

enum class UnknownNames {
    Refused,
    FirstIsFormal, ///< Reads an input: its point is the first name that means nothing else.
    AreFormals,    ///< Reads a rule or a function whose formals could not all be read.
};

class NameScope {
public:
    /// The table must outlive the scope.
    explicit NameScope(const DefinitionTable& table, UnknownNames unknown = UnknownNames::Refused)
        : table_(&table)
        , unknown_(unknown) {}

    /// False if there is one of that name already.
    bool add_formal(std::string_view name);
    void accept(UnknownNames unknown) { unknown_ = unknown; }

    /// May add a formal, as UnknownNames says.
    [[nodiscard]] NameMeaning find(std::string_view name);
    [[nodiscard]] const std::vector<std::string>& formals() const { return formals_; }
    [[nodiscard]] const DefinitionTable& table() const { return *table_; }

private:
    const DefinitionTable* table_;
    UnknownNames unknown_;
    std::vector<std::string> formals_;
    std::unordered_map<std::string, std::uint32_t> index_;
};

/// Whether a run is a name: a letter, then letters, digits, `_` or `'`.
[[nodiscard]] bool is_name(std::string_view run);

/// Words of expressions, which name nothing else: and, or, not, min, max, floor, abs, sqrt.
[[nodiscard]] const std::vector<std::string>& expression_words();
[[nodiscard]] bool is_expression_word(std::string_view name);

} // namespace internode
