// SPDX-License-Identifier: MIT

#include "cli/requests/formats.h"
#include "cli/commands/commands.h"
#include "cli/shell/generator.h"
#include "cli/shell/output.h"
#include "internode/io/json/json_writer.h"
#include "internode/report/json/json_parts.h"

#include <fmt/format.h>

#include <algorithm>

namespace internode::cli {
namespace {

bool writes(const FormatUse& use, const Format& format) {
    return std::ranges::find(use.formats, format.name) != use.formats.end();
}

/// "reverse --picture, interval grammars".
std::string told(const FormatUse& use) {
    std::string text(use.command);
    if (!use.option.empty()) text += fmt::format(" {}", use.option);
    if (use.kind) text += fmt::format(", {}", name_of(*use.kind));
    return text;
}

std::string formats_text() {
    std::string text;
    for (const Format& format : formats()) {
        std::string extensions = fmt::format(".{}", format.extensions[0]);
        if (!format.extensions[1].empty()) extensions += fmt::format(" .{}", format.extensions[1]);
        text += fmt::format("{:<6}{:<13}{}\n", format.name, extensions, format.what);
        for (const FormatUse& use : format_uses())
            if (writes(use, format)) text += fmt::format("      {}\n", told(use));
    }
    return text;
}

void write_use(JsonWriter& json, const FormatUse& use) {
    json.begin_object(JsonWriter::Layout::Line).key("command").string(use.command).key("kind");
    if (use.kind)
        json.string(name_of(*use.kind));
    else
        json.null();
    json.key("option");
    if (use.option.empty())
        json.null();
    else
        json.string(use.option);
    json.end_object();
}

void write_json(Sink& sink, const Context& context) {
    JsonWriter json(sink);
    json.begin_object();
    write_heading(json, "internode-formats", generator(context));
    json.key("formats").begin_array();
    for (const Format& format : formats()) {
        json.begin_object().key("name").string(format.name).key("extensions").begin_array(JsonWriter::Layout::Line);
        for (const std::string_view extension : format.extensions)
            if (!extension.empty()) json.string(extension);
        json.end_array().key("what").string(format.what).key("written_by").begin_array();
        for (const FormatUse& use : format_uses())
            if (writes(use, format)) write_use(json, use);
        json.end_array().end_object();
    }
    json.end_array().end_object().finish();
}

} // namespace

ExitCode run(const FormatsOptions& options, const Context& context) {
    const std::string format = settled_format(context, options.output, {"formats", {}, ""});
    Output output(options.output.file);
    if (format == "json")
        write_json(output.sink(), context);
    else
        output.sink().write(formats_text());
    output.commit();
    return ExitCode::Success;
}

} // namespace internode::cli
