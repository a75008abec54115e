// SPDX-License-Identifier: MIT
//
// CLI11 keeps its own opinion of errors and exit codes; here both become ours: every mistake is exit 2 with one line
// and a hint. Words that no option takes are collected by CLI11 and judged at the end, so that a misspelt option can
// be compared with the ones that exist.

#include "cli/arguments/command_line.h"

#include "cli/arguments/command_reader.h"
#include "cli/arguments/option_checks.h"
#include "cli/arguments/public_command_line.h"
#include "cli/requests/exit_code.h"
#include "internode/text/diagnostic.h"
#include "internode/text/did_you_mean.h"

#include <fmt/format.h>

#include <algorithm>

namespace internode::cli {

CommandReader::CommandReader() {
    app_.require_subcommand(0, 1);
    app_.allow_extras();
    app_.set_help_flag("-h,--help", "This text");
    app_.add_flag("--version", version_, "Version, compiler, instruction set, libraries");
    for (CLI::Option* early : {add_quiet(&app_), add_verbose(&app_)}) early->group("Before commands that have them");
    add_color(&app_);
    add_validate();
    add_masks();
    add_subdivide();
    add_converge();
    add_reverse();
    add_compose();
    add_infer();
    add_mesh();
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

namespace {

/// "--degree" of -d,--degree; of a place its name.
std::string name_of_option(const CLI::Option& option) {
    if (!option.get_lnames().empty()) return "--" + option.get_lnames().front();
    return option.get_snames().empty() ? option.get_name() : "-" + option.get_snames().front();
}

} // namespace

/// What stands before the command counts for it.
std::vector<GivenOption> CommandReader::given_options(const CLI::App& app) const {
    std::vector<GivenOption> given;
    for (const CLI::Option* option : app.get_options()) {
        const CLI::Option* const early = app_.get_option_no_throw(name_of_option(*option));
        if (option->count() == 0 && (early == nullptr || early->count() == 0)) continue;
        const auto belonging = belongings_.find(option);
        given.push_back({name_of_option(*option), belonging == belongings_.end() ? Belonging{} : belonging->second});
    }
    return given;
}

/// Refuses what stands before a command that has no such option.
void CommandReader::refuse_early_options(const CLI::App& command) const {
    for (const CLI::Option* option : app_.get_options()) {
        const std::string name = name_of_option(*option);
        if (option->count() == 0 || command.get_option_no_throw(name) != nullptr) continue;
        throw failure(ExitCode::Usage, fmt::format("{} does nothing before `{}`", name, command.get_name()),
                      fmt::format("see `internode {} --help`", command.get_name()));
    }
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
    common_.apply.threads = static_cast<int>(std::min<std::uint64_t>(threads_, max_threads));
    subdivide_.polygon.threads = common_.apply.threads;
    common_.apply.isa = isa_of_environment();
    common_.apply.stores = stores_of_environment();
    common_.command_line = public_command_line(argc, argv);
    refuse_leftovers(app_);
    if (version_) return {common_, VersionOptions{}};
    for (const Command& command : commands_) {
        if (!command.app->parsed()) continue;
        refuse_leftovers(*command.app);
        refuse_early_options(*command.app);
        common_.given = given_options(*command.app);
        Request request = command.finish();
        return {common_, std::move(request)};
    }
    return {common_, HelpRequest{app_.help()}};
}

CommandLine read_command_line(int argc, const char* const* argv) {
    return CommandReader().read(argc, argv);
}

} // namespace internode::cli
