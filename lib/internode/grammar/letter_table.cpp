// SPDX-License-Identifier: MIT

#include "internode/grammar/letter_table.h"

#include "internode/grammar/limits.h"

#include <fmt/format.h>

namespace internode {

namespace {

std::string parameters_of(std::size_t count) {
    return count == 0 ? "no parameter" : fmt::format("{} parameter{}", count, count == 1 ? "" : "s");
}

} // namespace

Symbol LetterTable::use(std::string_view name, std::size_t parameters, Complaints::Place place) {
    if (const auto known = letters_.find(name)) {
        const std::size_t arity = arity_[to_index(*known)];
        if (arity != parameters)
            complaints_.add(place,
                            fmt::format("{} has {} here and {} in line {}", quoted(name), parameters_of(parameters),
                                        parameters_of(arity), complaints_.line_of(offset_[to_index(*known)])),
                            "a letter has as many parameters everywhere; give the other module another letter");
        return *known;
    }
    if (letters_.size() >= max_point_letters) {
        if (!full_) complaints_.add(place, fmt::format("more than {} letters", max_point_letters));
        full_ = true;
        return to_symbol(0);
    }
    arity_.push_back(static_cast<std::uint32_t>(parameters));
    offset_.push_back(place.offset);
    return letters_.add(name);
}

} // namespace internode
