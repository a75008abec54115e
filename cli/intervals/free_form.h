// SPDX-License-Identifier: MIT
//
// Which curve or surface of an OBJ file is meant.

#pragma once

#include "cli/shell/load.h"
#include "internode/io/obj/obj_freeform.h"

#include <cstdint>
#include <optional>
#include <string>

namespace internode::cli {

/// By its name, or by its first statement.
[[nodiscard]] bool is_obj(const LoadedText& input);

/// \throw Failure (Refused) with every error
[[nodiscard]] FreeFormFile load_free_forms(const LoadedText& input);

/// The element of --element, counted from 1, or the only one. \throw Failure (Refused) if there is no such or several
[[nodiscard]] const FreeForm& chosen_element(const FreeFormFile& file, const std::optional<std::uint64_t>& element);

/// "element 2 of body.obj (line 31)".
[[nodiscard]] std::string element_name(const FreeFormFile& file, const FreeForm& element);

/// \throw Failure (Refused) where --element meets a file that has none
void refuse_element(const std::optional<std::uint64_t>& element, const LoadedText& input);

} // namespace internode::cli
