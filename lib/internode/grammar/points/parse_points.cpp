// SPDX-License-Identifier: MIT

#include "internode/grammar/points/parse_points.h"

#include "internode/grammar/points/point_reader.h"

#include <algorithm>

namespace internode {

ParsedPointGrammar parse_point_grammar(std::string_view text, std::string_view source) {
    return parse_opened<PointGrammar>(text, source, GrammarKind::Points, read_point_grammar);
}

Diagnostic diagnostic_at(std::string_view text, std::string_view source, const SourcePlace& place, std::string message,
                         std::string hint, std::string_view code) {
    if (place.bytes == 0) {
        Diagnostic whole;
        whole.source = source;
        whole.message = std::move(message);
        whole.hint = std::move(hint);
        whole.code = code;
        return whole;
    }
    Complaints complaints(text, source);
    complaints.add(code, {std::min(place.offset, text.size()), place.bytes}, std::move(message), std::move(hint));
    return std::move(complaints).diagnostics().front();
}

} // namespace internode
