// SPDX-License-Identifier: MIT
//
// What was inferred from a matrix, as a grammar file: the report stands in its comments, so that the file can be used
// as it is.

#pragma once

#include "internode/point/infer/inference.h"
#include "internode/report/generator.h"

#include <optional>
#include <string>

namespace internode {

struct InferenceTextOptions {
    std::string name; ///< the grammar's
    Generator generator;
    std::optional<std::ptrdiff_t> shift; ///< none: the recommended one, and all others in the comments
    OpenForm form = OpenForm::Ordered;   ///< the form of an open curve; the other one stands in the comments
};

/// The grammar of a closed curve.
[[nodiscard]] std::string inference_text(const RowPattern& pattern, const InferenceTextOptions& options);

/// The grammar of an open curve. \throw std::invalid_argument for a shift without productions
[[nodiscard]] std::string inference_text(const OpenPattern& pattern, const InferenceTextOptions& options);

/// The irregular rows of a problem, a line each; the first 20, and how many more there are.
[[nodiscard]] std::string irregular_rows_text(const InferenceProblem& problem);

} // namespace internode
