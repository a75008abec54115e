// SPDX-License-Identifier: MIT

#include "cli/shell/generator.h"

#include "internode/version.h"

namespace internode::cli {

Generator generator(const Context& context) {
    return {std::string(version()), context.command_line};
}

} // namespace internode::cli
