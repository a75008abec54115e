// SPDX-License-Identifier: MIT
//
// What the options of one command say together, settled where the request is made.

#pragma once

#include "cli/requests/options.h"

namespace internode::cli {

/// \throw Failure (Usage) unless there is one grammar, by place or as a text
void settle(ValidateOptions& options);
void settle(MasksOptions& options);
void settle(WordOptions& options);
void settle(FormatOptions& options);

/// With --u and --v the place after the command is the grid's; else grammar and polygon stand there, and a point
/// grammar may have an axiom instead of a polygon. \throw Failure (Usage) as above, and for grids that are half said
void settle(SubdivideOptions& options);

/// \throw Failure (Usage) as above, and without a polygon
void settle(ConvergeOptions& options);

/// A point grammar may be asked for its rules, without a polygon. \throw Failure (Usage) as above
void settle(ReverseOptions& options);

} // namespace internode::cli
