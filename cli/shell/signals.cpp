// SPDX-License-Identifier: MIT
//
// The handler may only touch what is safe in a handler: a fixed buffer, unlink and _exit. The buffer is written while
// SIGINT is blocked, so the handler never sees half a path.

#include "cli/shell/signals.h"

#include "cli/requests/exit_code.h"

#include <algorithm>
#include <array>
#include <climits>
#include <csignal>
#include <unistd.h>

namespace internode::cli {
namespace {

using Path = std::array<char, PATH_MAX>;
std::array<Path, 4> temporary_paths{};

extern "C" void on_interrupt(int) {
    for (const Path& path : temporary_paths)
        if (path[0] != '\0') ::unlink(path.data());
    ::_exit(static_cast<int>(ExitCode::Interrupted));
}

/// Changes the first slot that holds `from` to `to` while no interrupt can come in between.
void exchange(std::string_view from, std::string_view to) {
    if (to.size() >= sizeof(Path)) return;
    sigset_t interrupt;
    sigset_t before;
    sigemptyset(&interrupt);
    sigaddset(&interrupt, SIGINT);
    ::sigprocmask(SIG_BLOCK, &interrupt, &before);
    const auto slot = std::ranges::find_if(temporary_paths, [from](const Path& path) { return path.data() == from; });
    if (slot != temporary_paths.end()) {
        std::ranges::copy(to, slot->begin());
        (*slot)[to.size()] = '\0';
    }
    ::sigprocmask(SIG_SETMASK, &before, nullptr);
}

} // namespace

void install_signal_handlers() {
    struct sigaction action {};
    action.sa_handler = on_interrupt;
    sigemptyset(&action.sa_mask);
    ::sigaction(SIGINT, &action, nullptr);
    action.sa_handler = SIG_IGN;
    ::sigaction(SIGPIPE, &action, nullptr);
    ::sigaction(SIGXFSZ, &action, nullptr);
}

void remove_on_interrupt(std::string_view path) {
    exchange({}, path);
}

void forget(std::string_view path) {
    exchange(path, {});
}

} // namespace internode::cli
