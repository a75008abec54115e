// SPDX-License-Identifier: MIT
//
// The style sheet of a report page: system fonts, light and dark, screen and print.

#pragma once

#include <string>

namespace internode {

/// The content of the <style> element.
[[nodiscard]] std::string page_style();

} // namespace internode
