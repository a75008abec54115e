// SPDX-License-Identifier: MIT
//
// CLI11 keeps its own opinion of errors and exit codes; here both become ours: every mistake is exit 2 with one line
// and a hint. Words that no option takes are collected by CLI11 and judged at the end, so that a misspelt option can
// be compared with the ones that exist.

#include "cli/arguments/command_line.h"

#include "cli/arguments/command_reader.h"
#include "cli/shell/exit_code.h"
#include "cli/grids/grid.h"
#include "cli/arguments/option_checks.h"
#include "cli/arguments/places.h"
#include "cli/arguments/public_command_line.h"
#include "internode/text/diagnostic.h"

#include <fmt/format.h>

#include <algorithm>

namespace internode::cli {

CommandReader::CommandReader() {
    app_.require_subcommand(0, 1);
    app_.allow_extras();
    app_.set_help_flag("-h,--help", "This text");
    app_.add_flag("--version", version_, "Version, compiler, instruction set, libraries");
    add_common(&app_);
    add_grammar_commands();
    add_curve_commands();
    add_pyramid_commands();
    add_infer();
    add_small_commands();
}

std::vector<std::string> CommandReader::known_words(const CLI::App& app) const {
    std::vector<std::string> words;
    for (const CLI::Option* option : app.get_options()) {
        for (const std::string& name : option->get_lnames()) words.push_back("--" + name);
        for (const std::string& name : option->get_snames()) words.push_back("-" + name);
    }
    if (&app == &app_)
        for (const Command& command : commands_) words.push_back(command.app->get_name());
    return words;
}

void CommandReader::refuse_leftovers(const CLI::App& app) const {
    const std::vector<std::string> left = app.remaining();
    if (left.empty()) return;
    const std::string& word = left.front();
    const bool option = word.size() > 1 && word[0] == '-';
    const std::string kind = option ? "option" : (&app == &app_ ? "command" : "argument");
    const std::string meant = did_you_mean(word, known_words(app));
    const std::string where = &app == &app_ ? "internode --help" : fmt::format("internode {} --help", app.get_name());
    throw failure(ExitCode::Usage, fmt::format("unknown {} `{}`", kind, word),
                  meant.empty() ? fmt::format("see `{}`", where) : fmt::format("did you mean `{}`?", meant));
}

/// More threads than this are as many.
constexpr std::uint64_t max_threads = 1024;

CommandLine CommandReader::read(int argc, const char* const* argv) {
    try {
        app_.parse(argc, argv);
    } catch (const CLI::CallForHelp&) {
        const auto chosen = app_.get_subcommands();
        return {common_, HelpRequest{chosen.empty() ? app_.help() : chosen.front()->help("internode")}};
    } catch (const CLI::ParseError& error) {
        throw failure(ExitCode::Usage, error.what());
    }
    if (color_ != "auto") common_.color = color_ == "always" ? Color::Always : Color::Never;
    common_.threads = static_cast<int>(std::min<std::uint64_t>(threads_, max_threads));
    common_.isa = isa_of_environment();
    refuse_leftovers(app_);
    if (version_) return {common_, VersionOptions{}};
    for (const Command& command : commands_) {
        if (!command.app->parsed()) continue;
        refuse_leftovers(*command.app);
        return {common_, command.finish()};
    }
    return {common_, HelpRequest{app_.help()}};
}

CommandLine read_command_line(int argc, const char* const* argv) {
    CommandLine line = CommandReader().read(argc, argv);
    line.common.command_line = public_command_line(argc, argv);
    std::visit(
        [](auto& options) {
            if constexpr (requires { options.sides; }) {
                settle_grid_options(options);
                if (options.is_grid()) return;
            }
            if constexpr (requires { options.polygon; }) settle_places(options.grammar, options.polygon);
            if constexpr (requires { options.grammar; }) check_grammar(options.grammar);
            if constexpr (
                requires { options.polygon; } && !requires { options.point; } && !requires { options.rules; })
                require_polygon(options.polygon); // a point grammar may have an axiom, or be asked for its rules
        },
        line.request);
    return line;
}

} // namespace internode::cli
