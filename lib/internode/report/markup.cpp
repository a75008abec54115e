// SPDX-License-Identifier: MIT

#include "internode/report/markup.h"

#include "internode/text/diagnostic.h"
#include "internode/text/printable.h"

namespace internode {

std::string markup(std::string_view text) {
    std::string escaped;
    for (const char c : printable(text)) {
        switch (c) {
        case '&':
            escaped += "&amp;";
            break;
        case '<':
            escaped += "&lt;";
            break;
        case '>':
            escaped += "&gt;";
            break;
        case '"':
            escaped += "&quot;";
            break;
        case '\'':
            escaped += "&#39;";
            break;
        default:
            escaped += c;
        }
    }
    return escaped;
}

std::string dot_quoted(std::string_view text) {
    std::string quoted = "\"";
    for (const char c : printable(text)) {
        switch (c) {
        case '"':
            quoted += "&quot;";
            break;
        case '\\':
            quoted += "&#92;";
            break; // \N, \G and \l would be read as escapes of DOT
        case '&':
            quoted += "&amp;";
            break; // labels know the entities of HTML
        case '<':
            quoted += "&lt;";
            break;
        case '>':
            quoted += "&gt;";
            break;
        default:
            quoted += c;
        }
    }
    quoted += '"';
    return quoted;
}

} // namespace internode
