// SPDX-License-Identifier: MIT

#include "internode/grammar/points/point_context.h"

#include "internode/grammar/lexing/limits.h"
#include "internode/grammar/points/module_reader.h"

#include <fmt/format.h>

namespace internode {

bool check_name(std::string_view run, Complaints::Place place, Complaints& complaints) {
    if (!is_name(run))
        complaints.add("name.not-a-name", place, fmt::format("{} is no name", quoted(run)),
                       "a name is a letter, then letters, digits, `_` or `'`");
    else if (run.size() > max_name_bytes)
        complaints.add("name.too-long", place,
                       fmt::format("a name of {} bytes, more than {}", run.size(), max_name_bytes));
    else if (is_expression_word(run) || is_statement_word(run))
        complaints.add("name.reserved", place, fmt::format("{} is a word of the language", quoted(run)),
                       "choose another name");
    else
        return true;
    return false;
}

} // namespace internode
