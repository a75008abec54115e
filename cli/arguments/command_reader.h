// SPDX-License-Identifier: MIT
//
// The commands and their options, as CLI11 sees them: a part of command_line.cpp in several files.
//
// command_options.cpp has the options that commands share, polygon_options.cpp those of a polygon's file, and
// command_line_*.cpp the commands. Only these files know CLI11. Each option says at its registration where it does
// something (requests/belonging.h).

#pragma once

#include "cli/arguments/belongings.h"
#include "cli/arguments/command_line.h"

#include <CLI/CLI.hpp>

#include <functional>
#include <map>
#include <optional>
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
    /// Says where an option does something, to the one function that refuses it elsewhere and to --help.
    CLI::Option* put(CLI::Option* option, Belonging belonging);
    /// The option -e of it.
    CLI::Option* add_grammar(CLI::App* app, GrammarSource& grammar, bool with_polygon);
    void add_output(CLI::App* app, OutputTarget& output);
    void add_format_flag(CLI::App* app, OutputTarget& output, const std::string& name, const std::string& format,
                         const std::string& what);
    void add_color(CLI::App* app);
    CLI::Option* add_quiet(CLI::App* app);
    CLI::Option* add_verbose(CLI::App* app);
    CLI::Option* add_count(CLI::App* app, const std::string& name, std::uint64_t& count, const std::string& what);
    CLI::Option* add_number(CLI::App* app, const std::string& name, std::optional<std::uint64_t>& number,
                            const std::string& what);
    CLI::Option* add_settings(CLI::App* app, std::vector<std::string>& settings);
    CLI::Option* add_word(CLI::App* app, const std::string& name, std::string& word, const std::string& what);
    void add_steps(CLI::App* app, std::uint64_t& steps, const std::string& what);
    void add_polygon(CLI::App* app, PolygonOptions& polygon, const PolygonBelongings& belongings);
    void add_ends(CLI::App* app, PolygonOptions& polygon, const Belonging& belonging);
    CLI::Option* add_degree(CLI::App* app, std::size_t most, const std::function<void(const std::vector<int>&)>& take);
    void add_validate();
    void add_masks();
    void add_mask_pictures(CLI::App* masks);
    void add_subdivide();
    void add_limit(CLI::App* subdivide);
    void add_drawing(CLI::App* subdivide);
    void add_grid(CLI::App* subdivide);
    void add_point(CLI::App* subdivide);
    void add_converge();
    void add_reverse();
    void add_reverse_rules(CLI::App* reverse);
    void add_details(CLI::App* reverse);
    void add_compose();
    void add_infer();
    void add_mesh();
    void add_small_commands();
    void add_lists();
    void refuse_leftovers(const CLI::App& app) const;
    [[nodiscard]] std::vector<std::string> known_words(const CLI::App& app) const;
    [[nodiscard]] std::vector<GivenOption> given_options(const CLI::App& app) const;
    void refuse_early_options(const CLI::App& command) const;

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
    MeshOptions mesh_;
    FormatOptions format_;
    FormatsOptions formats_;
    GrammarsOptions grammars_;
    std::string color_ = "auto";
    std::uint64_t threads_ = 0;
    bool version_ = false;
    std::vector<Command> commands_;
    std::map<const CLI::Option*, Belonging> belongings_;
    std::map<const CLI::App*, std::vector<CLI::Option*>> format_options_; ///< each says the format: one at a time
};

} // namespace internode::cli
