// SPDX-License-Identifier: MIT

#include "cli/arguments/command_line.h"
#include "cli/commands/commands.h"
#include "cli/shell/output.h"
#include "cli/shell/signals.h"
#include "internode/text/limits.h"

#include <exception>
#include <new>

namespace {

using namespace internode;
using cli::ExitCode;

/// What went wrong, as an exit code and a text; called while an exception is in flight.
ExitCode explain(const cli::CommonOptions& common) {
    try {
        throw;
    } catch (const cli::Failure& failure) {
        cli::say(common, failure.what());
        return failure.code();
    } catch (const LimitExceeded& error) {
        cli::say(common, std::string("error: ") + error.what() + '\n');
        return ExitCode::Refused;
    } catch (const std::bad_alloc&) {
        cli::say(common, "error: out of memory\n");
        return ExitCode::Refused;
    } catch (const std::exception& error) {
        cli::say(common, std::string("error: internal: ") + error.what() +
                             "\nhint: this is a bug of internode; please report it with the command line\n");
        return ExitCode::Bug;
    }
}

} // namespace

int main(int argc, char** argv) {
    cli::install_signal_handlers();
    cli::CommonOptions common;
    try {
        const cli::CommandLine line = cli::read_command_line(argc, argv);
        common = line.common;
        return static_cast<int>(
            std::visit([&common](const auto& options) { return cli::run(options, common); }, line.request));
    } catch (...) {
        return static_cast<int>(explain(common));
    }
}
