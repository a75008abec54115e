// SPDX-License-Identifier: MIT

#include "cli/intervals/free_form.h"

#include "cli/shell/exit_code.h"

#include <fmt/format.h>

namespace internode::cli {

bool is_obj(const LoadedText& input) {
    return input.source.ends_with(".obj") || input.source.ends_with(".OBJ") || looks_like_obj(input.text);
}

FreeFormFile load_free_forms(const LoadedText& input) {
    ParsedFreeForms parsed = read_obj_freeform(input.text, input.source);
    if (!parsed.file) throw Failure(ExitCode::Refused, to_string(parsed.errors));
    return *std::move(parsed.file);
}

const FreeForm& chosen_element(const FreeFormFile& file, const std::optional<std::uint64_t>& element) {
    const std::size_t count = file.elements.size();
    if (!element && count == 1) return file.elements.front();
    if (!element)
        throw failure(ExitCode::Refused, fmt::format("{} has {} curves and surfaces", file.source, count),
                      fmt::format("say which: --element 1 … {}", count));
    if (*element < 1 || *element > count)
        throw failure(ExitCode::Refused,
                      fmt::format("no element {}: {} has {}, counted from 1", *element, file.source, count));
    return file.elements[*element - 1];
}

std::string element_name(const FreeFormFile& file, const FreeForm& element) {
    return fmt::format("element {} of {} (line {})", &element - file.elements.data() + 1, file.source,
                       element.place.line);
}

void refuse_element(const std::optional<std::uint64_t>& element, const LoadedText& input) {
    if (element)
        throw failure(ExitCode::Refused, fmt::format("{} is no OBJ file: --element means nothing in it", input.source));
}

} // namespace internode::cli
