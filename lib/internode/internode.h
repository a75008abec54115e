// SPDX-License-Identifier: MIT
//
// The public face: what a program needs. These headers are installed, and no others; each can be included alone.
// docs/library.md shows them at work, by task.

#pragma once

// In one call.
#include "internode/refine.h"
#include "internode/version.h"

// Text, and what is wrong in it.
#include "internode/text/diagnostic.h"
#include "internode/text/limits.h"
#include "internode/text/place.h"

// Words and exact numbers.
#include "internode/algebra/number.h"
#include "internode/algebra/perron.h"
#include "internode/algebra/rational.h"
#include "internode/word/morphism.h"
#include "internode/word/symbol.h"

// Grammars: read, bundled, decided.
#include "internode/expression/definition.h"
#include "internode/expression/expression.h"
#include "internode/expression/known_number.h"
#include "internode/expression/limits.h"
#include "internode/expression/operation.h"
#include "internode/expression/problem.h"
#include "internode/expression/type.h"
#include "internode/grammar/bundled.h"
#include "internode/grammar/grammar.h"
#include "internode/grammar/intervals/interval_grammar.h"
#include "internode/grammar/intervals/parse.h"
#include "internode/grammar/lexing/grammar_kind.h"
#include "internode/grammar/lexing/parsed.h"
#include "internode/grammar/parse.h"
#include "internode/grammar/points/parse_points.h"
#include "internode/grammar/points/point_grammar.h"
#include "internode/interval/interval_system.h"
#include "internode/interval/quantity.h"
#include "internode/interval/validity.h"

// Masks, automata, plans.
#include "internode/spline/exact_work.h"
#include "internode/spline/mask.h"
#include "internode/stencil/automaton.h"
#include "internode/stencil/cell_automaton.h"
#include "internode/stencil/isa.h"
#include "internode/stencil/plan.h"
#include "internode/stencil/stores.h"

// Curves and grids: refined, in the limit, backwards.
#include "internode/curve/curve.h"
#include "internode/curve/knots.h"
#include "internode/curve/limit.h"
#include "internode/curve/refinement.h"
#include "internode/curve/reverse/details.h"
#include "internode/curve/reverse/pyramid.h"
#include "internode/surface/grid.h"
#include "internode/surface/limit.h"
#include "internode/surface/refinement.h"
#include "internode/surface/sheet.h"

// Point grammars.
#include "internode/point/derivation.h"
#include "internode/point/interpreter.h"
#include "internode/point/layout.h"
#include "internode/point/limits.h"
#include "internode/point/module_word.h"
#include "internode/point/point_settings.h"
#include "internode/point/point_system.h"
#include "internode/point/start_word.h"
#include "internode/point/strands.h"

// Files.
#include "internode/io/csv.h"
#include "internode/io/file/file_error.h"
#include "internode/io/file/input_file.h"
#include "internode/io/file/limits.h"
#include "internode/io/file/output_file.h"
#include "internode/io/file/sink.h"
#include "internode/io/json/curve_json.h"
#include "internode/io/points_view.h"
#include "internode/io/polygon.h"
#include "internode/io/sheet_files.h"
