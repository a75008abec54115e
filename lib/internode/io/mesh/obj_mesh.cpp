// SPDX-License-Identifier: MIT
//
// One pass over the statements. A face names vertices that stand anywhere in the file, negative ones those before it.
// Tags `t crease` and `t corner` are those of OpenSubdiv's shapes: `t NAME ints/floats/strings` and so many of each.

#include "internode/io/mesh/mesh_readers.h"
#include "internode/io/mesh/number_pieces.h"

#include "internode/io/obj/obj_statement.h"
#include "internode/text/number.h"
#include "internode/text/place.h"
#include "internode/text/utf8.h"

#include <array>
#include <cassert>
#include <charconv>

namespace internode {
namespace {

std::optional<std::int64_t> parse_integer(std::string_view text) {
    std::int64_t value = 0;
    const char* const end = text.data() + text.size();
    const auto [stop, error] = std::from_chars(text.data(), end, value);
    return error == std::errc{} && stop == end ? std::optional(value) : std::nullopt;
}

class ObjMeshReader {
public:
    ObjMeshReader(std::string_view text, std::string_view source)
        : text_(text)
        , source_(source)
        , words_(text) {}

    ParsedMesh read() && {
        while (errors_.size() < max_polygon_errors) {
            const auto keyword = words_.next_statement();
            if (!keyword) break;
            read_statement(*keyword);
        }
        if (errors_.empty() && file_.mesh.faces.size() == 0) refuse_text("the file has no face");
        if (!errors_.empty()) return {std::nullopt, std::move(errors_)};
        return {std::move(file_), {}};
    }

private:
    void read_statement(const ObjWord& keyword) {
        if (keyword.text == "v") return read_vertex(keyword);
        if (keyword.text == "f" || keyword.text == "fo") return read_face(keyword);
        if (keyword.text == "t") return read_tag(keyword);
        const ObjStatement statement = obj_statement(keyword.text);
        if (statement == ObjStatement::Foreign)
            refuse(keyword, obj_quoted(keyword.text) + " reaches out of the file: it is not followed");
        if (statement == ObjStatement::Unknown) {
            refuse(keyword, obj_quoted(keyword.text) + " is no statement of OBJ");
            const std::string meant = obj_did_you_mean(keyword.text);
            if (!meant.empty()) errors_.back().hint = "did you mean `" + meant + "`?";
        }
    }

    void read_vertex(const ObjWord& keyword) {
        if (file_.mesh.vertex_count() >= max_mesh_vertices) return refuse(keyword, beyond_mesh_limit("vertices"));
        std::array<double, 3> point{};
        std::size_t count = 0;
        while (const auto word = words_.next()) {
            const std::optional<double> number = parse_double(word->text);
            if (!number) return refuse(*word, obj_quoted(word->text) + " is not a number within the range of doubles");
            if (count < point.size()) point[count] = *number; // a weight or a colour may follow
            ++count;
        }
        if (count < point.size()) return refuse(keyword, "a vertex needs x, y and z");
        file_.mesh.points.insert(file_.mesh.points.end(), point.begin(), point.end());
        file_.vertex_lines.push_back(line_of(keyword));
    }

    void read_face(const ObjWord& keyword) {
        std::vector<std::uint32_t> corners;
        while (const auto word = words_.next()) {
            if (file_.mesh.faces.corners().size() + corners.size() >= max_mesh_vertices)
                return refuse(*word, beyond_mesh_limit("corners of faces"));
            const auto corner = corner_of(*word);
            if (!corner) return;
            corners.push_back(*corner);
        }
        if (corners.empty()) return refuse(keyword, "a face needs corners");
        file_.mesh.faces.add(corners);
        file_.face_lines.push_back(line_of(keyword));
    }

    /// The vertex of `3`, `3/7`, `3//2`, `3/7/2` or `-1`, from 0. Some write `3//`.
    std::optional<std::uint32_t> corner_of(const ObjWord& word) {
        const std::size_t slash = std::min(word.text.find('/'), word.text.size());
        const auto vertex = parse_integer(word.text.substr(0, slash));
        if (vertex && *vertex != 0 && are_references(word.text.substr(slash))) return placed(word, *vertex);
        refuse(word, obj_quoted(word.text) + " is not a corner");
        errors_.back().hint = "write 3, 3/7, 3//2 or 3/7/2; numbers count from 1, or from -1 backwards";
        return std::nullopt;
    }

    /// Whether the rest of a corner is at most a texture coordinate and a normal, each behind a `/` and perhaps left
    /// out.
    [[nodiscard]] static bool are_references(std::string_view rest) {
        for (int part = 0; part < 2 && !rest.empty(); ++part) {
            rest.remove_prefix(1);
            const std::size_t slash = std::min(rest.find('/'), rest.size());
            const auto value = parse_integer(rest.substr(0, slash));
            if (slash > 0 && (!value || *value == 0)) return false;
            rest.remove_prefix(slash);
        }
        return rest.empty();
    }

    std::optional<std::uint32_t> placed(const ObjWord& word, std::int64_t vertex) {
        const auto count = static_cast<std::int64_t>(file_.mesh.vertex_count());
        if (vertex > 0 && vertex < 0xFFFFFFFF) return static_cast<std::uint32_t>(vertex - 1);
        if (vertex < 0 && vertex >= -count) return static_cast<std::uint32_t>(count + vertex);
        refuse(word, "no vertex " + obj_quoted(word.text) + ": " + std::to_string(count) +
                         (count == 1 ? " stands" : " stand") + " before");
        return std::nullopt;
    }

    void read_tag(const ObjWord& keyword) {
        const auto name = words_.next();
        const auto sizes = words_.next();
        const auto counts = sizes ? tag_counts(sizes->text) : std::nullopt;
        if (!name || !counts) {
            refuse(sizes ? *sizes : keyword, "a tag has a name and counts: `t crease 2/1/0 …`");
            return;
        }
        if (name->text != "crease" && name->text != "corner") return; // it is about other things than sharpness
        std::vector<std::uint32_t> vertices;
        for (std::int64_t i = 0; i < (*counts)[0]; ++i) {
            const auto word = words_.next();
            const auto value = word ? parse_integer(word->text) : std::nullopt;
            if (!value || *value < 0 || *value >= 0xFFFFFFFF)
                return refuse(word.value_or(keyword), "a vertex of a tag is a number from 0");
            vertices.push_back(static_cast<std::uint32_t>(*value));
        }
        std::vector<double> sharpness;
        for (std::int64_t i = 0; i < (*counts)[1]; ++i) {
            const auto word = words_.next();
            const auto value = word ? parse_double(word->text) : std::nullopt;
            if (!value) return refuse(word.value_or(keyword), "the sharpness of a tag is a number");
            sharpness.push_back(*value);
        }
        add_tag(keyword, name->text == "crease", vertices, sharpness);
    }

    /// "2/1/0", each below a million.
    static std::optional<std::array<std::int64_t, 3>> tag_counts(std::string_view text) {
        constexpr std::int64_t most = 1'000'000;
        std::array<std::int64_t, 3> counts{};
        for (std::size_t i = 0; i < counts.size(); ++i) {
            const std::size_t slash = std::min(text.find('/'), text.size());
            const auto value = parse_integer(text.substr(0, slash));
            if (!value || *value < 0 || *value > most || (slash < text.size()) != (i < 2)) return std::nullopt;
            counts[i] = *value;
            text.remove_prefix(std::min(slash + 1, text.size()));
        }
        return counts;
    }

    /// A crease is a chain of edges; one sharpness is that of all.
    void add_tag(const ObjWord& keyword, bool is_crease, const std::vector<std::uint32_t>& vertices,
                 const std::vector<double>& sharpness) {
        const std::size_t count = is_crease && !vertices.empty() ? vertices.size() - 1 : vertices.size();
        if (count == 0 || (sharpness.size() != 1 && sharpness.size() != count))
            return refuse(keyword, "a tag has one sharpness, or one for each of its edges or corners");
        for (std::size_t i = 0; i < count; ++i) {
            const double value = sharpness[sharpness.size() == 1 ? 0 : i];
            if (is_crease)
                file_.mesh.creases.push_back({{vertices[i], vertices[i + 1]}, value});
            else
                file_.mesh.corners.push_back({vertices[i], value});
        }
    }

    /// Words are asked about in the order of the text, or nearly.
    std::uint32_t line_of(const ObjWord& word) {
        assert(word.offset >= known_offset_);
        known_place_ = place_of(text_, word.offset, known_offset_, known_place_);
        known_offset_ = word.offset;
        return static_cast<std::uint32_t>(known_place_.line);
    }

    void refuse(const ObjWord& word, std::string message) {
        Diagnostic diagnostic = diagnostic_at(text_, word.offset, source_, std::move(message));
        diagnostic.width = columns_of(word.text);
        errors_.push_back(std::move(diagnostic));
    }

    void refuse_text(std::string message) {
        Diagnostic diagnostic;
        diagnostic.source = source_;
        diagnostic.message = std::move(message);
        errors_.push_back(std::move(diagnostic));
    }

    std::string_view text_;
    std::string_view source_;
    ObjWords words_;
    MeshFile file_;
    std::size_t known_offset_ = 0;
    TextPlace known_place_;
    std::vector<Diagnostic> errors_;
};

} // namespace

ParsedMesh read_obj_mesh(std::string_view text, std::string_view source) {
    return ObjMeshReader(without_byte_order_mark(text), source).read();
}

} // namespace internode
