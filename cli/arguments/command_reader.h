// SPDX-License-Identifier: MIT
//
// The commands and their options, as CLI11 sees them: a part of command_line.cpp in several files.
//
// command_options.cpp has the options that commands share, command_line_*.cpp the commands of one kind. Only these
// files know CLI11.

#pragma once

#include "cli/arguments/command_line.h"

#include <CLI/CLI.hpp>

#include <array>
#include <functional>
#include <string>
#include <vector>

namespace internode::cli {

/// A description, and the two examples that every command's help ends with.
[[nodiscard]] std::string with_examples(const std::string& what, const std::string& first, const std::string& second);

/// A command while it is being read: the parser's view, and how to make the request of it.
struct Command {
    CLI::App* app = nullptr;
    std::function<Request()> finish;
};

class CommandReader {
public:
    CommandReader();
    CommandLine read(int argc, const char* const* argv);

private:
    CLI::App* add(const std::string& name, const std::string& description);
    void add_grammar(CLI::App* app, GrammarSource& grammar, bool with_polygon);
    void add_output(CLI::App* app, OutputTarget& output, const std::vector<std::string>& formats);
    void add_polygon(CLI::App* app, PolygonOptions& polygon, std::array<GridSideOptions, 2>* sides);
    void add_grid(CLI::App* app, SubdivideOptions& subdivide);
    void add_settings(CLI::App* app, std::vector<std::string>& settings);
    void add_point(CLI::App* app, PointOptions& point);
    static CLI::Option* add_count(CLI::App* app, const std::string& name, std::uint64_t& count,
                                  const std::string& what);
    static void add_steps(CLI::App* app, std::uint64_t& steps, const std::string& what);
    void add_common(CLI::App* app);
    void add_grammar_commands();
    void add_curve_commands();
    void add_pyramid_commands();
    void add_reverse_command();
    void add_reverse_rules(CLI::App* reverse);
    void add_details(CLI::App* reverse);
    void add_compose_command();
    void add_infer();
    void add_small_commands();
    void refuse_leftovers(const CLI::App& app) const;
    [[nodiscard]] std::vector<std::string> known_words(const CLI::App& app) const;

    CLI::App app_{
        with_examples("internode: subdivision described by grammars.", "validate @fibonacci", "masks @fibonacci -d 2"),
        "internode"};
    CommonOptions common_;
    ValidateOptions validate_;
    MasksOptions masks_;
    SubdivideOptions subdivide_;
    ConvergeOptions converge_;
    ReverseOptions reverse_;
    InferOptions infer_;
    ComposeOptions compose_;
    WordOptions word_;
    FormatOptions format_;
    GrammarsOptions grammars_;
    std::string color_ = "auto";
    std::uint64_t threads_ = 0;
    bool version_ = false;
    std::vector<Command> commands_;
};

} // namespace internode::cli
