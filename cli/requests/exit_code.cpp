// SPDX-License-Identifier: MIT

#include "cli/requests/exit_code.h"

#include "internode/text/diagnostic.h"
#include "internode/text/printable.h"

namespace internode::cli {

Failure failure(ExitCode code, const std::string& message, const std::string& hint) {
    std::string text = "error: ";
    text += printable(message) + '\n';
    if (!hint.empty()) text += "hint: " + printable(hint) + '\n';
    return {code, text};
}

} // namespace internode::cli
