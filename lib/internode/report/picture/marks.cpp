// SPDX-License-Identifier: MIT

#include "internode/report/picture/marks.h"

#include "internode/report/markup.h"

#include <cassert>

namespace internode {

std::string dots(std::span<const Point2> pixels, std::string_view colour, double diameter) {
    assert(diameter > 0);
    std::string text = "<path fill=\"none\" stroke=\"" + std::string(colour) + "\" stroke-linecap=\"round\"" +
                       attribute("stroke-width", diameter) + " d=\"";
    for (const Point2& pixel : pixels) {
        text += 'M';
        append_point(text, pixel);
        text += "h0";
    }
    return text + "\"/>\n";
}

std::string title_text(std::string_view title, Point2 at) {
    return "<text" + attribute("x", at.x) + attribute("y", at.y) +
           " font-size=\"18\" font-weight=\"bold\" text-anchor=\"middle\" fill=\"currentColor\">" + markup(title) +
           "</text>\n";
}

std::string caption(std::string_view text, Point2 at) {
    return "<text" + attribute("x", at.x) + attribute("y", at.y) +
           " font-size=\"12\" text-anchor=\"middle\" fill=\"currentColor\">" + markup(text) + "</text>\n";
}

} // namespace internode
