// SPDX-License-Identifier: MIT

#include "internode/io/mesh/ply_header.h"

#include "internode/io/mesh/number_pieces.h"

#include <array>

namespace internode {
namespace {

struct TypeName {
    std::string_view name;
    PlyType type;
};

constexpr std::array<TypeName, 16> type_names{{
    {"char", PlyType::Int8},
    {"int8", PlyType::Int8},
    {"uchar", PlyType::Uint8},
    {"uint8", PlyType::Uint8},
    {"short", PlyType::Int16},
    {"int16", PlyType::Int16},
    {"ushort", PlyType::Uint16},
    {"uint16", PlyType::Uint16},
    {"int", PlyType::Int32},
    {"int32", PlyType::Int32},
    {"uint", PlyType::Uint32},
    {"uint32", PlyType::Uint32},
    {"float", PlyType::Float32},
    {"float32", PlyType::Float32},
    {"double", PlyType::Float64},
    {"float64", PlyType::Float64},
}};

/// The text up to the end of the line `end_header`; all of it where there is none.
std::string_view head_of(std::string_view bytes) {
    for (std::size_t at = 0; at < bytes.size();) {
        const std::size_t end = bytes.find('\n', at);
        std::string_view line = bytes.substr(at, end == std::string_view::npos ? end : end - at);
        if (line.ends_with('\r')) line.remove_suffix(1);
        if (end == std::string_view::npos) break;
        at = end + 1;
        if (line == "end_header") return bytes.substr(0, at);
    }
    return bytes;
}

class HeaderReader {
public:
    HeaderReader(std::string_view bytes, std::string_view source)
        : head_(head_of(bytes))
        , lines_(head_, source, {}) {}

    ParsedPlyHeader read() && {
        (void)lines_.next(); // `ply`
        while (lines_.errors().size() < max_polygon_errors) {
            if (!lines_.next()) {
                lines_.refuse_text("the header has no end", "`end_header` ends it");
                break;
            }
            const std::vector<LinePiece> pieces = pieces_of(lines_);
            if (pieces.empty()) continue;
            if (pieces.front().text == "end_header") break;
            read_line(pieces);
        }
        if (lines_.errors().empty() && !has_format_) lines_.refuse_text("the header says no format");
        if (!lines_.errors().empty()) return {std::nullopt, std::move(lines_.errors())};
        header_.bytes = head_.size();
        header_.lines = lines_.number();
        return {std::move(header_), {}};
    }

private:
    void read_line(const std::vector<LinePiece>& pieces) {
        const std::string_view keyword = pieces.front().text;
        if (keyword == "comment" || keyword == "obj_info") return;
        if (keyword == "format") return read_format(pieces);
        if (keyword == "element") return read_element(pieces);
        if (keyword == "property") return read_property(pieces);
        lines_.refuse(pieces.front(), piece_quoted(keyword) + " is no line of a PLY header");
    }

    void read_format(const std::vector<LinePiece>& pieces) {
        const std::string_view name = pieces.size() > 1 ? pieces[1].text : std::string_view();
        has_format_ = true;
        if (name == "ascii")
            header_.encoding = PlyEncoding::Ascii;
        else if (name == "binary_little_endian")
            header_.encoding = PlyEncoding::LittleEndian;
        else if (name == "binary_big_endian")
            header_.encoding = PlyEncoding::BigEndian;
        else
            lines_.refuse(pieces.back(), "the format is ascii, binary_little_endian or binary_big_endian");
    }

    void read_element(const std::vector<LinePiece>& pieces) {
        if (pieces.size() != 3) return lines_.refuse(pieces.front(), "an element has a name and a number");
        const auto count = count_of(pieces[2], lines_);
        if (count) header_.elements.push_back({std::string(pieces[1].text), *count, {}});
    }

    void read_property(const std::vector<LinePiece>& pieces) {
        if (header_.elements.empty()) return lines_.refuse(pieces.front(), "a property belongs to an element");
        const bool is_list = pieces.size() > 1 && pieces[1].text == "list";
        if (pieces.size() != (is_list ? 5U : 3U))
            return lines_.refuse(pieces.front(), "a property has a type and a name: `float x`, `list uchar int …`");
        PlyProperty property;
        property.name = pieces.back().text;
        const auto type = type_of(pieces[is_list ? 3 : 1]);
        if (!type) return;
        property.type = *type;
        if (is_list) {
            property.count = type_of(pieces[2]);
            if (!property.count) return;
            if (*property.count == PlyType::Float32 || *property.count == PlyType::Float64)
                return lines_.refuse(pieces[2], "the number of entries of a list is whole");
        }
        header_.elements.back().properties.push_back(std::move(property));
    }

    std::optional<PlyType> type_of(const LinePiece& piece) {
        for (const TypeName& known : type_names)
            if (known.name == piece.text) return known.type;
        lines_.refuse(piece, piece_quoted(piece.text) + " is no type of PLY");
        return std::nullopt;
    }

    std::string_view head_;
    TextLines lines_;
    PlyHeader header_;
    bool has_format_ = false;
};

} // namespace

std::size_t size_of(PlyType type) {
    switch (type) {
    case PlyType::Int8:
    case PlyType::Uint8:
        return 1;
    case PlyType::Int16:
    case PlyType::Uint16:
        return 2;
    case PlyType::Int32:
    case PlyType::Uint32:
    case PlyType::Float32:
        return 4;
    case PlyType::Float64:
        break;
    }
    return 8;
}

ParsedPlyHeader read_ply_header(std::string_view bytes, std::string_view source) {
    return HeaderReader(bytes, source).read();
}

} // namespace internode
