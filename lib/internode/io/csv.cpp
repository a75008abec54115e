// SPDX-License-Identifier: MIT

#include "internode/io/csv.h"

#include "internode/io/file/text_lines.h"
#include "internode/text/number.h"

#include <cmath>
#include <stdexcept>

namespace internode {

namespace {

/// A name as one field that read_polygon_csv takes for a name: no line breaks, quotes where a separator stands.
std::string csv_field(const std::string& name) {
    std::string field;
    for (const char c : name) {
        if (c == '"') field += '"';
        field += c == '\n' || c == '\r' || c == '\0' ? ' ' : c;
    }
    const bool needs_quotes = field.empty() || field.find_first_of(",;\t\"# ") != std::string::npos;
    return needs_quotes ? '"' + field + '"' : field;
}

void require_matching_sizes(const PointsView& points, const CsvOptions& options) {
    require_whole_rows(points);
    const bool has_parameter = !options.parameter.empty();
    if (has_parameter && options.parameter.size() != points.size())
        throw std::invalid_argument("write_csv: the parameter column has another length than the points");
    if (!options.header.empty() && options.header.size() != points.dimension + (has_parameter ? 1 : 0))
        throw std::invalid_argument("write_csv: the header has another width than the rows");
}

} // namespace

std::vector<std::string> coordinate_names(std::size_t dimension) {
    if (dimension <= 3) {
        std::vector<std::string> names{"x", "y", "z"};
        names.resize(dimension);
        return names;
    }
    std::vector<std::string> names;
    for (std::size_t i = 1; i <= dimension; ++i) names.push_back('x' + std::to_string(i));
    return names;
}

bool write_csv(Sink& sink, const PointsView& points, const CsvOptions& options) {
    require_matching_sizes(points, options);
    std::string header;
    for (const std::string& name : options.header) header += (header.empty() ? "" : ",") + csv_field(name);
    if (!options.header.empty() && !sink.write(header + '\n')) return false;
    return write_lines(sink, points.size(), options.threads, [&](std::size_t row, std::string& text) {
        if (!options.parameter.empty()) {
            append(text, options.parameter[row]);
            text += ',';
        }
        for (std::size_t i = 0; i < points.dimension; ++i) {
            if (i > 0) text += ',';
            const double value = points[row][i];
            if (!options.nan_is_missing || !std::isnan(value)) append(text, value);
        }
        text += '\n';
    });
}

} // namespace internode
