// SPDX-License-Identifier: MIT

#include "internode/version.h"
#include "cli/commands/commands.h"
#include "cli/shell/output.h"

#include <fmt/format.h>

namespace internode::cli {
namespace {

std::string compiler() {
#if defined(__clang__)
    return fmt::format("clang {}.{}.{}", __clang_major__, __clang_minor__, __clang_patchlevel__);
#else
    return fmt::format("g++ {}.{}.{}", __GNUC__, __GNUC_MINOR__, __GNUC_PATCHLEVEL__);
#endif
}

} // namespace

ExitCode run(const VersionOptions&, const Context& context) {
    std::string text = fmt::format("internode {}\ncompiler {}\ninstruction set {}, kernels {}\n", version(), compiler(),
                                   instruction_set(), usable(context.apply.isa) == Isa::Avx2 ? "avx2" : "plain");
    for (const LibraryVersion& library : library_versions())
        text += fmt::format("{} {}\n", library.name, library.version);
    write_output("-", text);
    return ExitCode::Success;
}

} // namespace internode::cli
