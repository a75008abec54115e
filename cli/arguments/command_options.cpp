// SPDX-License-Identifier: MIT

#include "cli/arguments/command_reader.h"

#include "cli/arguments/option_checks.h"
#include "cli/requests/formats.h"

#include <fmt/format.h>

namespace internode::cli {

std::string with_examples(const std::string& what, const std::string& first, const std::string& second) {
    return fmt::format("{}\n\nExamples:\n  internode {}\n  internode {}\n", what, first, second);
}

CLI::App* CommandReader::add(const std::string& name, const std::string& description) {
    CLI::App* command = app_.add_subcommand(name, description);
    command->allow_extras();
    command->set_help_flag("-h,--help", "This text");
    command->get_formatter()->column_width(34);
    add_color(command);
    return command;
}

CLI::Option* CommandReader::put(CLI::Option* option, Belonging belonging) {
    const std::string group = heading(belonging);
    if (!group.empty()) option->group(group);
    belongings_[option] = std::move(belonging);
    return option;
}

void CommandReader::add_color(CLI::App* app) {
    app->add_option("--color", color_, "auto, always or never (NO_COLOR counts)")
        ->check(CLI::IsMember({"auto", "always", "never"}));
}

CLI::Option* CommandReader::add_quiet(CLI::App* app) {
    return app->add_flag("-q,--quiet", common_.quiet, "Only errors on stderr");
}

CLI::Option* CommandReader::add_verbose(CLI::App* app) {
    return app->add_flag("-v,--verbose", common_.verbose, "Say more on stderr");
}

CLI::Option* CommandReader::add_grammar(CLI::App* app, GrammarSource& grammar, bool with_polygon) {
    app->add_option("GRAMMAR", grammar.place,
                    with_polygon ? "Grammar file, @name of a bundled one, or - (left out with -e)"
                                 : "Grammar file, @name of a bundled one, or -");
    CLI::Option* text = app->add_option("-e,--expression", grammar.expression, "The grammar itself: -e 'L->SL, S->L'");
    belongings_[text].called = "-e";
    return text;
}

void CommandReader::add_output(CLI::App* app, OutputTarget& output) {
    const std::vector<std::string> names = formats_of(app->get_name());
    app->add_option("-o,--output", output.file, "Output file, - for stdout (default); the extension names the format");
    CLI::Option* format = app->add_option("--format", output.format, fmt::format("{}", fmt::join(names, ", ")))
                              ->check(CLI::IsMember(names));
    format_options_[app].push_back(format);
    for (const std::string& name : names)
        if (name == "json") add_format_flag(app, output, "--json", name, "Same as --format json");
}

void CommandReader::add_format_flag(CLI::App* app, OutputTarget& output, const std::string& name,
                                    const std::string& format, const std::string& what) {
    CLI::Option* flag = app->add_flag_callback(
        name, [&output, format] { output.format = format; }, what);
    for (CLI::Option* other : format_options_[app]) flag->excludes(other);
    format_options_[app].push_back(flag);
}

CLI::Option* CommandReader::add_count(CLI::App* app, const std::string& name, std::uint64_t& count,
                                      const std::string& what) {
    const auto read = [&count](const std::string& text) { count = whole_number(text).value_or(0); };
    return app->add_option_function<std::string>(name, read, what)
        ->type_name("N")
        ->check(CLI::Validator(whole_number_problem, ""));
}

CLI::Option* CommandReader::add_number(CLI::App* app, const std::string& name, std::optional<std::uint64_t>& number,
                                       const std::string& what) {
    const auto read = [&number](const std::string& text) { number = whole_number(text); };
    return app->add_option_function<std::string>(name, read, what)
        ->type_name("N")
        ->check(CLI::Validator(whole_number_problem, ""));
}

void CommandReader::add_steps(CLI::App* app, std::uint64_t& steps, const std::string& what) {
    add_count(app, "-n,--steps", steps, what)->required();
}

} // namespace internode::cli
