// SPDX-License-Identifier: MIT
//
// A point grammar as the command line names it: its constants, the words it starts from, its environment.

#pragma once

#include "cli/requests/exit_code.h"
#include "cli/requests/options.h"
#include "cli/shell/load.h"
#include "internode/curve/homogeneous.h"
#include "internode/point/compile/fast_derivation.h"

#include <map>
#include <memory>
#include <string>
#include <vector>

namespace internode::cli {

/// One word to start from, with all that its derivation needs.
struct LoadedPoints {
    const LoadedText& text;                    ///< the text of the grammar: diagnostics quote it
    std::shared_ptr<const PointSystem> system; ///< one for all polygons of a dimension
    ModuleWord word;                           ///< the word of the polygon, or the axiom
    DeriveOptions derive;
    std::string name;                 ///< the name of the grammar, for titles
    std::string start;                ///< base name of the polygon's file, or "the axiom"
    std::size_t polygon_size = 0;     ///< points of the polygon; 0 when the axiom is meant
    std::vector<std::string> columns; ///< names of the polygon's coordinates, when its file gives them
    Coordinates coordinates = Coordinates::Cartesian;
    std::size_t part = 0;     ///< of several polygons the number of this one, from 1
    std::string break_text{}; ///< of CSV: what parts the polygon from the one before
};

/// The words of all polygons of the file, or the axiom alone; the text must outlive them. \throw Failure: Refused with
/// everything that is wrong in the grammar, File and Refused for a polygon, Usage for --set and --query that fit no
/// constant and no query module
[[nodiscard]] std::vector<LoadedPoints> load_points(const PointGrammar& grammar, const LoadedText& text,
                                                    const SubdivideOptions& options);

/// What the polygon is to the compiler: so many points, or the axiom.
[[nodiscard]] StartWord start_of(const LoadedPoints& loaded);

/// What --set says, by name. \throw Failure (Usage) for what is no constant of the grammar or no number
[[nodiscard]] std::map<std::string, Rational> constant_values(const PointGrammar& grammar,
                                                              const std::vector<std::string>& settings);

/// Why a derivation ended, with its place in the grammar, and of which part.
[[nodiscard]] Failure derivation_failure(const LoadedPoints& loaded, const DerivationProblem& problem);

} // namespace internode::cli
