// SPDX-License-Identifier: MIT

#include "cli/shell/settled.h"

namespace internode::cli {

Failure failure(const internode::Refusal& refusal) {
    return {refusal.unsaid ? ExitCode::Usage : ExitCode::Refused, to_string(refusal.errors)};
}

} // namespace internode::cli
