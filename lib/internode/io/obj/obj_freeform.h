// SPDX-License-Identifier: MIT
//
// B-spline curves and surfaces of a Wavefront OBJ file: `v x y z [w]`, `cstype [rat] bspline`, `deg`, `curv`, `surf`,
// `parm`, `end` (Alias|Wavefront, Object Files, "Free-form curve/surface statements").
//
// A curve of degree d with N points has N + d + 1 knots; a surface has the points of N_u × N_v, u running first. Knots
// are exact decimals, coordinates correctly rounded; `\` continues a line, negative indices count back from the last
// vertex. Every index is checked where it stands against the vertices before it. Other statements of the format are
// passed over; refused are unknown ones, other curve types, trimmed surfaces, other files (`call`), and parts: the
// range of `curv` and `surf` must be the whole domain.

#pragma once

#include "internode/algebra/rational.h"
#include "internode/io/file/limits.h"
#include "internode/text/diagnostic.h"
#include "internode/text/place.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace internode {

/// One direction of a curve or a surface: knots.size() = points + degree + 1.
struct FreeFormDirection {
    std::size_t degree = 0;
    std::size_t points = 0;
    std::vector<Rational> knots; ///< knots as they stand: whether they ascend is for curve/knot_vector.h to say
};

/// Doubles of a vertex in FreeFormFile::vertices: x, y, z, w.
inline constexpr std::size_t free_form_row = 4;

struct FreeForm {
    TextPlace place; ///< where its `curv` or `surf` stands
    bool rational = false;
    FreeFormDirection u;
    std::optional<FreeFormDirection> v;  ///< the second direction of a surface
    std::vector<std::uint32_t> vertices; ///< indices from 0; point (i, j) is vertices[i + j · u.points]
};

struct FreeFormFile {
    std::string source;
    std::vector<double> vertices;   ///< rows x, y, z, w
    std::vector<FreeForm> elements; ///< elements in the order of the file, at least one
};

struct ParsedFreeForms {
    std::optional<FreeFormFile> file; ///< present iff errors is empty
    std::vector<Diagnostic> errors;   ///< errors in the order of the text, at most max_polygon_errors
};

struct ObjLimits {
    std::uint64_t vertices = max_obj_vertices; ///< vertices of the file, and the indices of all elements
    std::uint64_t knots = max_knots;           ///< knots of all elements
};

/// Never throws on any text (but std::bad_alloc). Cost: linear in the text. Weights of rational elements are positive,
/// within the bounds of curve/homogeneous.h.
[[nodiscard]] ParsedFreeForms read_obj_freeform(std::string_view text, std::string_view source,
                                                const ObjLimits& limits = {});

/// Whether the first statement of a text is one of OBJ rather than a line of a table.
[[nodiscard]] bool looks_like_obj(std::string_view text);

} // namespace internode
