// SPDX-License-Identifier: MIT
//
// Sines and cosines come from their series in an eighth of a turn and from reflections, not from libm.

#include "internode/report/picture/svg.h"

#include "internode/report/markup.h"

#include <array>
#include <cassert>
#include <charconv>
#include <cmath>
#include <numbers>

namespace internode {

namespace {

/// sin and cos of 0 <= angle <= π/4: their series, far beyond what a pixel can show.
Point2 small_rotation(double angle) {
    const double square = angle * angle;
    double sine = 0;
    double cosine = 0;
    for (int term = 10; term >= 1; --term) {
        sine = square / (2.0 * term * (2.0 * term + 1)) * (1 - sine);
        cosine = square / ((2.0 * term - 1) * (2.0 * term)) * (1 - cosine);
    }
    return {.x = 1 - cosine, .y = angle * (1 - sine)};
}

Point2 unit_vector(double eighths) {
    assert(0 <= eighths && eighths <= 8);
    // eighths of a turn, 0 … 8: the angle within the octant, then reflections
    const auto octant = static_cast<int>(eighths);
    const double rest = eighths - octant;
    const bool mirrored = octant % 2 == 1;
    Point2 vector = small_rotation((mirrored ? 1 - rest : rest) * std::numbers::pi / 4);
    if (mirrored) vector = {.x = vector.y, .y = vector.x};
    for (int quarter = 0; quarter < octant / 2; ++quarter) vector = {.x = -vector.y, .y = vector.x};
    return vector;
}

} // namespace

void append_fixed(std::string& text, double value, int decimals) {
    assert(std::isfinite(value));
    std::array<char, 400> buffer; // 309 digits of the largest double, sign, point and decimals
    const auto [end, error] =
        std::to_chars(buffer.data(), buffer.data() + buffer.size(), value, std::chars_format::fixed, decimals);
    std::string_view digits(buffer.data(), static_cast<std::size_t>(end - buffer.data()));
    if (digits.find('.') != std::string_view::npos) {
        while (digits.back() == '0') digits.remove_suffix(1);
        if (digits.back() == '.') digits.remove_suffix(1);
    }
    text += digits == "-0" ? std::string_view("0") : digits;
}

std::string fixed(double value, int decimals) {
    std::string text;
    append_fixed(text, value, decimals);
    return text;
}

std::string attribute(std::string_view name, double value) {
    std::string text = " ";
    text += name;
    text += "=\"";
    append_fixed(text, value);
    text += '"';
    return text;
}

void append_point(std::string& path, Point2 point, int decimals) {
    append_fixed(path, point.x, decimals);
    path += ' ';
    append_fixed(path, point.y, decimals);
}

std::string svg_open(const SvgHead& head, SvgPlace place) {
    assert(head.width > 0 && head.height > 0);
    const std::string width = fixed(head.width);
    const std::string height = fixed(head.height);
    const bool is_file = place == SvgPlace::File;
    std::string text;
    if (is_file) text += "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n";
    text += "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 " + width + " " + height + "\"";
    if (is_file) {
        text += " width=\"" + width + "\" height=\"" + height + "\" color=\"#222222\"";
        text += " font-family=\"'Helvetica Neue', Helvetica, Arial, 'DejaVu Sans', sans-serif\"";
    }
    text += " role=\"img\">\n<title>" + markup(head.title) + "</title>\n";
    if (!head.description.empty()) text += "<desc>" + markup(head.description) + "</desc>\n";
    if (!is_file) return text;
    text += "<metadata>internode " + markup(head.generator.version) + ": " + markup(head.generator.command) +
            "</metadata>\n";
    text += "<rect width=\"" + width + "\" height=\"" + height + "\" fill=\"#ffffff\"/>\n";
    return text;
}

std::vector<Point2> points_on_circle(std::size_t count) {
    std::vector<Point2> points;
    points.reserve(count);
    for (std::size_t k = 0; k < count; ++k) {
        const Point2 turned = unit_vector(8.0 * static_cast<double>(k) / static_cast<double>(count));
        points.push_back({.x = turned.y, .y = -turned.x});
    }
    return points;
}

} // namespace internode
