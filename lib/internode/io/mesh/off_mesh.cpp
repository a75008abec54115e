// SPDX-License-Identifier: MIT
//
// OFF: a keyword, the numbers of vertices, faces and edges, a vertex a line, a face a line (Geomview's OOGL, "OFF
// Files"). Prefixes say what follows the coordinates of a vertex: it is passed over, and so are colours of faces.

#include "internode/io/mesh/mesh_readers.h"
#include "internode/io/mesh/number_pieces.h"

#include <algorithm>
#include <array>
#include <span>

namespace internode {
namespace {

using Pieces = std::vector<LinePiece>;

/// The keyword without the prefixes for texture coordinates, colours and normals; "4nOFF" of other dimensions stays.
std::string_view without_prefixes(std::string_view keyword) {
    for (const std::string_view prefix : {"ST", "C", "N"})
        if (keyword.starts_with(prefix)) keyword.remove_prefix(prefix.size());
    return keyword;
}

class OffReader {
public:
    OffReader(std::string_view text, std::string_view source)
        : lines_(text, source, {}) {}

    ParsedMesh read() && {
        if (read_keyword() && read_counts() && read_vertices()) read_faces();
        if (!lines_.errors().empty()) return {std::nullopt, std::move(lines_.errors())};
        return {std::move(file_), {}};
    }

private:
    /// The next line that says something; false at the end.
    bool next_pieces() {
        while (lines_.errors().empty() && lines_.next()) {
            pieces_ = pieces_of(lines_);
            const auto comment = std::ranges::find_if(
                pieces_, [](const LinePiece& piece) { return piece.text.find('#') != std::string_view::npos; });
            if (comment != pieces_.end()) {
                comment->text = comment->text.substr(0, comment->text.find('#'));
                pieces_.erase(comment->text.empty() ? comment : comment + 1, pieces_.end());
            }
            if (!pieces_.empty()) return true;
        }
        return false;
    }

    bool read_keyword() {
        if (!next_pieces()) return ends_before("its keyword");
        const std::string_view keyword = without_prefixes(pieces_.front().text);
        if (keyword != "OFF") {
            lines_.refuse(pieces_.front(), "vertices of other than three coordinates are not read");
            return false;
        }
        if (pieces_.size() > 1 && pieces_[1].text == "BINARY") {
            lines_.refuse(pieces_[1], "binary OFF is not read", "write it as text, or as PLY");
            return false;
        }
        pieces_.erase(pieces_.begin());
        return true;
    }

    bool read_counts() {
        if (pieces_.empty() && !next_pieces()) return ends_before("its counts");
        if (pieces_.size() < 2) {
            lines_.refuse(pieces_.front(), "the numbers of vertices and of faces stand on one line");
            return false;
        }
        const auto vertices = count_of(pieces_[0], lines_);
        const auto faces = count_of(pieces_[1], lines_);
        if (!vertices || !faces) return false;
        for (const auto& [count, piece] : {std::pair{*vertices, pieces_[0]}, std::pair{*faces, pieces_[1]}})
            if (count > max_mesh_vertices) lines_.refuse(piece, beyond_mesh_limit("vertices or faces"));
        vertex_count_ = *vertices;
        face_count_ = *faces;
        return lines_.errors().empty();
    }

    bool read_vertices() {
        for (std::uint64_t vertex = 0; vertex < vertex_count_; ++vertex) {
            if (!next_pieces())
                return ends_before("vertex " + std::to_string(vertex) + " of " + std::to_string(vertex_count_));
            if (!read_vertex()) return false;
            file_.vertex_lines.push_back(static_cast<std::uint32_t>(lines_.number()));
        }
        return true;
    }

    bool read_vertex() {
        if (pieces_.size() < 3) {
            lines_.refuse(pieces_.front(), "a vertex needs x, y and z");
            return false;
        }
        std::array<double, 3> point{};
        for (std::size_t i = 0; i < 3; ++i) {
            const auto coordinate = coordinate_of(pieces_[i], lines_);
            if (!coordinate) return false;
            point[i] = *coordinate;
        }
        file_.mesh.points.insert(file_.mesh.points.end(), point.begin(), point.end());
        return true;
    }

    void read_faces() {
        for (std::uint64_t face = 0; face < face_count_; ++face) {
            if (!next_pieces()) {
                (void)ends_before("face " + std::to_string(face) + " of " + std::to_string(face_count_));
                return;
            }
            if (!read_face()) return;
            file_.face_lines.push_back(static_cast<std::uint32_t>(lines_.number()));
        }
    }

    bool read_face() {
        const auto count = count_of(pieces_.front(), lines_);
        if (!count) return false;
        if (*count > pieces_.size() - 1) {
            lines_.refuse(pieces_.front(), "a face of " + std::to_string(*count) + " corners with " +
                                               std::to_string(pieces_.size() - 1) + " numbers behind");
            return false;
        }
        if (file_.mesh.faces.corners().size() + *count > max_mesh_vertices) {
            lines_.refuse(pieces_.front(), beyond_mesh_limit("corners of faces"));
            return false;
        }
        std::vector<std::uint32_t> corners;
        for (const LinePiece& piece : std::span(pieces_).subspan(1, *count)) {
            const auto vertex = count_of(piece, lines_);
            if (!vertex) return false;
            corners.push_back(vertex_of(*vertex));
        }
        file_.mesh.faces.add(corners);
        return true;
    }

    bool ends_before(const std::string& what) {
        if (lines_.errors().empty()) lines_.refuse_text("the file ends before " + what);
        return false;
    }

    TextLines lines_;
    MeshFile file_;
    Pieces pieces_; ///< of the line at hand
    std::uint64_t vertex_count_ = 0;
    std::uint64_t face_count_ = 0;
};

} // namespace

bool is_off(std::string_view text) {
    std::size_t at = 0;
    for (;;) {
        at = text.find_first_not_of(" \t\r\n", at);
        if (at == std::string_view::npos) return false;
        if (text[at] != '#') break;
        at = text.find('\n', at);
        if (at == std::string_view::npos) return false;
    }
    const std::size_t end = text.find_first_of(" \t\r\n#", at);
    std::string_view keyword = without_prefixes(text.substr(at, end - at));
    if (keyword.starts_with('4')) keyword.remove_prefix(1);
    if (keyword.starts_with('n')) keyword.remove_prefix(1);
    return keyword == "OFF";
}

ParsedMesh read_off_mesh(std::string_view text, std::string_view source) {
    return OffReader(text, source).read();
}

} // namespace internode
