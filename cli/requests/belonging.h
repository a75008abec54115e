// SPDX-License-Identifier: MIT
//
// Where an option does something. It is said once, where the option is registered; everywhere else the option is
// refused by one function, so that no option is accepted which changes nothing.

#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace internode::cli {

/// What a command works on; each kind has a folder of handlers.
enum class Kind : std::uint8_t { Intervals, Points, Grids };

/// "interval grammars".
[[nodiscard]] std::string_view name_of(Kind kind);

/// One circumstance in which an option does something; an empty list asks for nothing.
struct Place {
    std::vector<Kind> kinds{};          ///< one of these kinds of grammar
    std::vector<std::string> formats{}; ///< one of these formats of the output
    std::vector<std::string> with{};    ///< one of these options beside it
    std::vector<std::string> without{}; ///< none of these options beside it
};

/// A text of an option's own, instead of the usual one.
struct Refusal {
    std::vector<Kind> kinds{}; ///< the kinds that meet the option with this text; empty: all
    std::string format{};      ///< the format that meets it so; empty where the format is not what is wrong
    std::string message{};     ///< empty: the usual message, with this hint
    std::string hint{};
};

/// Where an option belongs: to any of its places; without places, everywhere.
struct Belonging {
    std::vector<Place> places{};
    std::vector<Refusal> refusals{};
    std::string called{}; ///< the name of the option in messages; empty: its long name
};

/// An option that stands on the command line.
struct GivenOption {
    std::string name; ///< the name as registered: "--axes"
    Belonging belonging;
};

/// What is known about a command once its grammar has been read and its format chosen.
struct Situation {
    Kind kind = Kind::Intervals;
    std::string format;
};

/// The kinds that an option belongs to, as a heading: "Interval grammars and grids"; empty for all of them.
[[nodiscard]] std::string heading(const Belonging& belonging);

/// The one refusal of options that belong to another kind of grammar. \throw Failure (Usage) for the first of them
void refuse_foreign_options(std::span<const GivenOption> given, Kind kind);

/// The one refusal of options that would do nothing here, those of other kinds included.
/// \throw Failure (Usage) for the first of them
void refuse_idle_options(std::span<const GivenOption> given, const Situation& here);

} // namespace internode::cli
