// SPDX-License-Identifier: MIT
//
// The letters of a point grammar with their numbers of parameters, as its statements use them.

#pragma once

#include "internode/grammar/complaints.h"
#include "internode/word/symbol.h"

#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

namespace internode {

class LetterTable {
public:
    explicit LetterTable(Complaints& complaints)
        : complaints_(complaints) {}

    /// The letter of that name; complains when it had another number of parameters before.
    Symbol use(std::string_view name, std::size_t parameters, Complaints::Place place);

    [[nodiscard]] Alphabet letters() && { return std::move(letters_); }
    [[nodiscard]] const std::vector<std::uint32_t>& arity() const { return arity_; }

private:
    Complaints& complaints_;
    Alphabet letters_;
    std::vector<std::uint32_t> arity_;
    std::vector<std::size_t> offset_; ///< of the first use
    bool full_ = false;               ///< a complaint about too many letters was made
};

} // namespace internode
