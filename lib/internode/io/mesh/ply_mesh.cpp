// SPDX-License-Identifier: MIT
//
// PLY: `x y z` of the element `vertex`, the list `vertex_indices` or `vertex_index` of the element `face`; all else is
// passed over. An element is a line in an ascii file. Counts are believed only as far as there are data.

#include "internode/io/mesh/mesh_readers.h"
#include "internode/io/mesh/number_pieces.h"
#include "internode/io/mesh/ply_header.h"

#include <array>
#include <bit>
#include <cmath>

namespace internode {
namespace {

std::string number_name(const PlyElement& element, std::uint64_t i) {
    return element.name + ' ' + std::to_string(i);
}

/// The numbers of an element after another, whatever they are for: those of a text, a line an element.
class TextRows {
public:
    TextRows(std::string_view text, std::string_view source, std::size_t lines_before)
        : lines_(text, source, {})
        , lines_before_(lines_before) {}

    /// Goes to the next element; false where there is none.
    bool begin() {
        while (lines_.errors().empty() && lines_.next()) {
            pieces_ = pieces_of(lines_);
            at_ = 0;
            if (!pieces_.empty()) return true;
        }
        return false;
    }
    std::optional<double> number(PlyType /*type*/) {
        if (at_ == pieces_.size()) {
            refuse_row("the line ends too early");
            return std::nullopt;
        }
        return coordinate_of(pieces_[at_++], lines_);
    }
    bool end() {
        if (at_ == pieces_.size()) return true;
        refuse_row("the line has more numbers than its element");
        return false;
    }
    void refuse_row(std::string message) { lines_.refuse(pieces_[at_ < pieces_.size() ? at_ : 0], std::move(message)); }
    void refuse_text(std::string message) {
        if (lines_.errors().empty()) lines_.refuse_text(std::move(message));
    }
    [[nodiscard]] std::size_t line() const { return lines_before_ + lines_.number(); }

    [[nodiscard]] std::vector<Diagnostic> errors() && {
        for (Diagnostic& error : lines_.errors())
            if (error.line > 0) error.line += lines_before_;
        return std::move(lines_.errors());
    }
    [[nodiscard]] bool is_good() { return lines_.errors().empty(); }

private:
    TextLines lines_;
    std::size_t lines_before_;
    std::vector<LinePiece> pieces_;
    std::size_t at_ = 0;
};

/// Those of a binary file, one behind the other.
class BinaryRows {
public:
    BinaryRows(std::string_view bytes, std::string_view source, bool is_big)
        : bytes_(bytes)
        , source_(source)
        , is_big_(is_big) {}

    [[nodiscard]] bool begin() const { return at_ < bytes_.size(); }
    std::optional<double> number(PlyType type) {
        const std::size_t size = size_of(type);
        if (bytes_.size() - at_ < size) {
            refuse_text("the file ends too early");
            return std::nullopt;
        }
        std::uint64_t bits = 0;
        for (std::size_t i = 0; i < size; ++i)
            bits = bits << 8U | static_cast<unsigned char>(bytes_[at_ + (is_big_ ? i : size - 1 - i)]);
        at_ += size;
        return value_of(bits, type);
    }
    [[nodiscard]] static bool end() { return true; }
    void refuse_row(std::string message) { refuse_text(std::move(message)); }
    void refuse_text(std::string message) {
        Diagnostic diagnostic;
        diagnostic.source = source_;
        diagnostic.message = std::move(message);
        errors_.push_back(std::move(diagnostic));
    }
    [[nodiscard]] static std::size_t line() { return 0; }
    [[nodiscard]] std::vector<Diagnostic> errors() && { return std::move(errors_); }
    [[nodiscard]] bool is_good() const { return errors_.empty(); }

private:
    static double value_of(std::uint64_t bits, PlyType type) {
        switch (type) {
        case PlyType::Int8:
            return static_cast<std::int8_t>(bits);
        case PlyType::Int16:
            return static_cast<std::int16_t>(bits);
        case PlyType::Int32:
            return static_cast<std::int32_t>(bits);
        case PlyType::Float32:
            return double{std::bit_cast<float>(static_cast<std::uint32_t>(bits))};
        case PlyType::Float64:
            return std::bit_cast<double>(bits);
        default:
            return static_cast<double>(bits);
        }
    }

    std::string_view bytes_;
    std::string_view source_;
    bool is_big_;
    std::size_t at_ = 0;
    std::vector<Diagnostic> errors_;
};

template<class Rows>
class PlyReader {
public:
    PlyReader(const PlyHeader& header, Rows rows)
        : header_(header)
        , rows_(std::move(rows)) {}

    ParsedMesh read() && {
        bool has_faces = false;
        for (const PlyElement& element : header_.elements) {
            has_faces = has_faces || element.name == "face";
            if (!rows_.is_good() || !read_element(element)) break;
        }
        if (rows_.is_good() && !has_faces) rows_.refuse_text("the file has no element `face`");
        if (!rows_.is_good()) return {std::nullopt, std::move(rows_).errors()};
        return {std::move(file_), {}};
    }

private:
    bool read_element(const PlyElement& element) {
        if (element.properties.empty()) return true; // nothing stands in the file
        const bool is_vertex = element.name == "vertex";
        const bool is_face = element.name == "face";
        if ((is_vertex || is_face) && element.count > max_mesh_vertices) {
            rows_.refuse_text(beyond_mesh_limit("vertices or faces"));
            return false;
        }
        if (is_vertex && !find_coordinates(element)) return false;
        if (is_face && !find_indices(element)) return false;
        for (std::uint64_t i = 0; i < element.count; ++i) {
            if (!rows_.begin()) {
                rows_.refuse_text("the file ends before " + number_name(element, i) + " of " +
                                  std::to_string(element.count));
                return false;
            }
            if (!read_row(element) || !rows_.end()) return false;
            if (is_vertex && !keep_vertex(number_name(element, i))) return false;
            if (is_face && !keep_face()) return false;
        }
        return true;
    }

    bool find_coordinates(const PlyElement& element) {
        for (std::size_t i = 0; i < 3; ++i) {
            const std::string name(1, "xyz"[i]);
            coordinates_[i] = element.properties.size();
            for (std::size_t p = 0; p < element.properties.size(); ++p)
                if (element.properties[p].name == name && !element.properties[p].count) coordinates_[i] = p;
            if (coordinates_[i] < element.properties.size()) continue;
            rows_.refuse_text("the vertices have no `" + name + "`");
            return false;
        }
        return true;
    }

    bool find_indices(const PlyElement& element) {
        for (std::size_t p = 0; p < element.properties.size(); ++p) {
            const PlyProperty& property = element.properties[p];
            if (!property.count || (property.name != "vertex_indices" && property.name != "vertex_index")) continue;
            indices_ = p;
            return true;
        }
        rows_.refuse_text("the faces have no list `vertex_indices`");
        return false;
    }

    /// The numbers of an element: those that are not in lists, and the list of corners.
    bool read_row(const PlyElement& element) {
        numbers_.assign(element.properties.size(), 0);
        corners_.clear();
        for (std::size_t p = 0; p < element.properties.size(); ++p) {
            const PlyProperty& property = element.properties[p];
            const auto first = rows_.number(property.count.value_or(property.type));
            if (!first) return false;
            numbers_[p] = *first;
            if (property.count && !read_list(property, *first, element.name == "face" && p == indices_)) return false;
        }
        return true;
    }

    bool read_list(const PlyProperty& property, double count, bool is_kept) {
        if (!(count >= 0) || count != std::floor(count)) {
            rows_.refuse_row("a list has no such number of entries");
            return false;
        }
        if (is_kept && count > max_mesh_vertices) {
            rows_.refuse_row(beyond_mesh_limit("corners of faces"));
            return false;
        }
        for (double i = 0; i < count; ++i) {
            const auto entry = rows_.number(property.type);
            if (!entry) return false;
            if (is_kept) corners_.push_back(*entry);
        }
        return true;
    }

    bool keep_vertex(const std::string& name) {
        for (const std::size_t place : coordinates_) {
            if (!std::isfinite(numbers_[place])) {
                rows_.refuse_row(name + " has a coordinate that is not finite");
                return false;
            }
            file_.mesh.points.push_back(numbers_[place]);
        }
        if (rows_.line() > 0) file_.vertex_lines.push_back(static_cast<std::uint32_t>(rows_.line()));
        return true;
    }

    bool keep_face() {
        if (file_.mesh.faces.corners().size() + corners_.size() > max_mesh_vertices) {
            rows_.refuse_row(beyond_mesh_limit("corners of faces"));
            return false;
        }
        std::vector<std::uint32_t> corners;
        for (const double corner : corners_) {
            if (!(corner >= 0) || corner != std::floor(corner)) {
                rows_.refuse_row("the number of a vertex is whole, and not below 0");
                return false;
            }
            corners.push_back(vertex_of(corner < 0x1p32 ? static_cast<std::uint64_t>(corner) : 0xFFFFFFFF));
        }
        file_.mesh.faces.add(corners);
        if (rows_.line() > 0) file_.face_lines.push_back(static_cast<std::uint32_t>(rows_.line()));
        return true;
    }

    const PlyHeader& header_;
    Rows rows_;
    MeshFile file_;
    std::array<std::size_t, 3> coordinates_{}; ///< properties of a vertex
    std::size_t indices_ = 0;                  ///< property of a face
    std::vector<double> numbers_;              ///< of an element; of a list how long it is
    std::vector<double> corners_;
};

} // namespace

ParsedMesh read_ply_mesh(std::string_view bytes, std::string_view source) {
    ParsedPlyHeader parsed = read_ply_header(bytes, source);
    if (!parsed.header) return {std::nullopt, std::move(parsed.errors)};
    const PlyHeader& header = *parsed.header;
    const std::string_view data = bytes.substr(header.bytes);
    if (header.encoding == PlyEncoding::Ascii) return PlyReader(header, TextRows(data, source, header.lines)).read();
    return PlyReader(header, BinaryRows(data, source, header.encoding == PlyEncoding::BigEndian)).read();
}

} // namespace internode
