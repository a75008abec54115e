// SPDX-License-Identifier: MIT
//
// The picture of a refined curve: every knot interval a piece of the limit curve, coloured and dashed by its symbol
// (Nivoliers et al. 2012, Fig. 2), over the thin grey control polygon. It has knots, a legend and a title. Several
// curves stand in one frame, layer by layer; a symbol of one name has one look in all of them.
//
// Up to degree 3 a piece is one exact `L`, `Q` or `C` of SVG, in the layer <g id="limit">; above, and with weights, a
// polyline through points of the curve. All pieces of a symbol are one path, so 20,000 of them stay a small file.
//
// The picture goes to its sink as it is drawn. Since the curve is the same after any number of steps, a picture of many
// steps is drawn after fewer (picture/drawn_steps.h), which `remark` says.

#pragma once

#include "internode/io/file/sink.h"
#include "internode/report/generator.h"
#include "internode/report/picture/planar_curve.h"
#include "internode/report/picture/svg.h"

#include <span>
#include <string>

namespace internode {

struct CurvePictureOptions {
    std::string title; ///< drawn in a file; a page has its own headings
    Generator generator;
    SvgPlace place = SvgPlace::File;
    std::string remark{}; ///< plain text below the legend; empty: none
};

/// An SVG text, 960 pixels wide, on its way to a sink, whole if the sink is. \throw std::invalid_argument for no curve,
/// a curve without segments, and functions beside curves of the plane
void write_curve_picture(Sink& sink, std::span<const PlanarCurve> curves, const CurvePictureOptions& options);

/// The same of one curve, as a text. \throw std::invalid_argument for a curve without segments
[[nodiscard]] std::string curve_picture(const PlanarCurve& curve, const CurvePictureOptions& options);

} // namespace internode
