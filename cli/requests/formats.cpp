// SPDX-License-Identifier: MIT

#include "cli/requests/formats.h"

#include "cli/requests/contains.h"
#include "cli/requests/exit_code.h"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>

namespace internode::cli {
namespace {

constexpr std::array<Format, 15> all_formats{{
    {"text", {"txt", "text"}, "text", "for people to read"},
    {"json", {"json", ""}, "JSON", "for programs; docs/json.md describes every key"},
    {"csv", {"csv", ""}, "CSV", "a point, or a row of a matrix, a line"},
    {"npy", {"npy", ""}, "NPY", "points as an array of NumPy"},
    {"obj", {"obj", ""}, "OBJ", "polylines or a mesh of Wavefront"},
    {"off", {"off", ""}, "OFF", "a mesh of Geomview"},
    {"ply", {"ply", ""}, "PLY", "a mesh, binary"},
    {"stl", {"stl", ""}, "STL", "triangles, binary"},
    {"svg", {"svg", ""}, "SVG", "a picture"},
    {"dot", {"dot", ""}, "DOT", "a graph for Graphviz"},
    {"html", {"html", ""}, "HTML", "a page that needs no other file"},
    {"mtx", {"mtx", ""}, "MatrixMarket", "a sparse matrix"},
    {"lsys", {"lsys", ""}, "lsys", "a grammar"},
    {"c", {"h", "c"}, "c", "tables and a kernel as a header of C"},
    {"glsl", {"glsl", "comp"}, "glsl", "tables and a kernel as a compute shader"},
}};

constexpr auto intervals = Kind::Intervals;
constexpr auto points = Kind::Points;
constexpr auto grids = Kind::Grids;

/// What each command writes; a command or a kind more is some rows more.
std::vector<FormatUse> all_uses() {
    constexpr auto own = Destination::OwnFile;
    return {
        {"validate", intervals, "", {"text", "json"}},
        {"validate", points, "", {"text", "json"}},
        {"masks", intervals, "", {"text", "json", "mtx", "dot", "svg", "c", "glsl"}},
        {"masks", intervals, "--automaton", {"json", "c", "glsl"}},
        {"masks", points, "", {"text", "json", "mtx", "csv", "c", "glsl"}},
        {"masks", points, "--automaton", {"json", "c", "glsl"}},
        {"subdivide", intervals, "", {"csv", "json", "npy", "obj", "svg"}},
        {"subdivide", grids, "", {"json", "obj", "ply", "stl"}},
        {"subdivide", grids, "--limit", {"obj", "ply", "stl"}},
        {"subdivide", points, "", {"csv", "json", "npy", "obj", "svg", "text"}},
        {"subdivide", points, "--trace", {"text"}},
        {"subdivide", points, "--tree", {"svg"}},
        {"converge", intervals, "", {"text", "json"}},
        {"converge", intervals, "--html", {"html"}, own},
        {"reverse", intervals, "", {"text", "json"}},
        {"reverse", intervals, "--coarse", {"csv", "json"}, own},
        {"reverse", intervals, "--picture", {"svg"}, own},
        {"reverse", points, "", {"text", "json", "csv", "svg"}},
        {"reverse", points, "--rules", {"lsys"}},
        {"reverse", points, "--coarse", {"csv", "json"}, own},
        {"reverse", points, "--picture", {"svg"}, own},
        {"compose", {}, "", {"csv", "json", "npy", "obj"}},
        {"infer", {}, "", {"lsys"}},
        {"word", intervals, "", {"text", "json"}},
        {"format", intervals, "", {"text"}},
        {"format", points, "", {"text"}},
        {"mesh", {}, "", {"text", "json"}},
        {"mesh", {}, "--repair", {"obj", "off", "ply"}},
        {"formats", {}, "", {"text", "json"}},
    };
}

/// "svg" of "out/coast.svg"; empty without an extension.
std::string extension(const std::string& path) {
    const auto slash = path.find_last_of('/');
    const std::string name = slash == std::string::npos ? path : path.substr(slash + 1);
    const auto dot = name.find_last_of('.');
    if (dot == std::string::npos || dot == 0) return {};
    std::string text = name.substr(dot + 1);
    std::ranges::transform(text, text.begin(), [](char c) { return c >= 'A' && c <= 'Z' ? char(c - 'A' + 'a') : c; });
    return text;
}

/// A name whose dots mean nothing. What stands in memory by way of /dev/shm is a file like any other.
bool is_device(const std::string& path) {
    return path.rfind("/dev/", 0) == 0 && path.rfind("/dev/shm/", 0) != 0;
}

/// The format that an extension stands for; the extension itself where none does.
std::string format_of(const std::string& written) {
    for (const Format& format : all_formats)
        if (!written.empty() && std::ranges::find(format.extensions, written) != format.extensions.end())
            return std::string(format.name);
    return written;
}

const FormatUse& row_of(const OutputOf& output) {
    const auto uses = format_uses();
    const auto row = std::ranges::find_if(uses, [&output](const FormatUse& use) {
        return use.command == output.command && use.kind == output.kind && use.option == output.option;
    });
    assert(row != uses.end());
    return *row;
}

/// ".txt, .json": the extensions that a message proposes.
std::string proposed_extensions(const std::vector<std::string>& names) {
    std::vector<std::string> extensions;
    for (const std::string& name : names) {
        assert(find_format(name) != nullptr);
        extensions.push_back(fmt::format(".{}", find_format(name)->extensions[0]));
    }
    return fmt::format("{}", fmt::join(extensions, ", "));
}

} // namespace

std::span<const Format> formats() {
    return all_formats;
}

std::span<const FormatUse> format_uses() {
    static const std::vector<FormatUse> uses = all_uses();
    return uses;
}

const Format* find_format(std::string_view name) {
    const auto found = std::ranges::find(all_formats, name, &Format::name);
    return found == all_formats.end() ? nullptr : &*found;
}

std::vector<std::string> formats_of(std::string_view command) {
    std::vector<std::string> names;
    for (const FormatUse& use : format_uses())
        if (use.command == command && use.destination == Destination::Output)
            for (const std::string& name : use.formats)
                if (!contains(names, name)) names.push_back(name);
    assert(!names.empty());
    return names;
}

std::string chosen_format(const OutputTarget& target, const OutputOf& output, std::string_view usual) {
    const std::vector<std::string>& names = row_of(output).formats;
    assert(usual.empty() || contains(names, usual));
    const std::string written = extension(target.file);
    std::string name = format_of(written);
    const bool known = contains(names, name);
    if (!target.format.empty() && known && name != target.format)
        throw failure(ExitCode::Usage,
                      fmt::format("the format {} and the extension `.{}` of -o disagree", target.format, written));
    if (!target.format.empty() && !contains(names, target.format))
        throw failure(ExitCode::Usage, fmt::format("no format {} for this output", target.format),
                      fmt::format("use one of {}", fmt::join(names, ", ")));
    if (!target.format.empty()) return target.format;
    if (known) return name;
    if (target.file == "-" || is_device(target.file) || name.empty())
        return usual.empty() ? names.front() : std::string(usual);
    throw failure(ExitCode::Usage, fmt::format("no format for the extension `.{}`", written),
                  fmt::format("use one of {}, or --format", proposed_extensions(names)));
}

std::string settled_format(const Context& context, const OutputTarget& target, const OutputOf& output,
                           std::string_view usual) {
    const Kind kind = output.kind.value_or(Kind::Intervals);
    refuse_foreign_options(context.given, kind);
    std::string format = chosen_format(target, output, usual);
    refuse_idle_options(context.given, {kind, format});
    return format;
}

} // namespace internode::cli
