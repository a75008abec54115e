// SPDX-License-Identifier: MIT
//
// One pass over the statements. An element is open from its `curv` or `surf` to its `end`, where its counts must fit
// and its ranges be the domains. After an error in an element nothing more is said about it.

#include "internode/io/obj/obj_freeform.h"

#include "internode/curve/homogeneous.h"
#include "internode/io/obj/obj_statement.h"
#include "internode/text/number.h"

#include <cassert>
#include <charconv>
#include <stdexcept>

namespace internode {

namespace {

std::string shown_number(const Rational& number) {
    constexpr std::size_t longest = 40;
    std::string text = to_string(number);
    return text.size() > longest ? to_string(to_double(number)) : text;
}

/// The range of one direction, as `curv` and `surf` ask for it.
struct Range {
    Rational first;
    Rational last;
};

/// An element between its `curv` or `surf` and its `end`.
struct OpenElement {
    FreeForm element;
    ObjWord keyword;
    Range ranges[2];
    bool has_knots[2] = {false, false};
    bool refused = false; ///< an error has been said: no more about what follows from it
};

class ObjReader {
public:
    ObjReader(std::string_view text, std::string_view source, const ObjLimits& limits)
        : text_(text)
        , words_(text)
        , limits_(limits) {
        file_.source = source;
    }

    ParsedFreeForms read() && {
        while (errors_.size() < max_polygon_errors) {
            const auto keyword = words_.next_statement();
            if (!keyword) break;
            read_statement(*keyword);
        }
        if (open_ && errors_.size() < max_polygon_errors)
            refuse(open_->keyword, obj_quoted(open_->keyword.text) + " without `end`");
        if (file_.elements.empty() && errors_.empty()) add_empty_error();
        if (!errors_.empty()) return {.file = {}, .errors = std::move(errors_)};
        return {.file = std::move(file_), .errors = {}};
    }

private:
    void read_statement(const ObjWord& keyword) {
        const ObjStatement statement = obj_statement(keyword.text);
        if (in_plane_curve_) { // lies in parameter space: serves trimming only
            in_plane_curve_ = statement != ObjStatement::End;
            return;
        }
        switch (statement) {
        case ObjStatement::Vertex:
            return read_vertex(keyword);
        case ObjStatement::TextureVertex:
            ++texture_vertices_;
            return;
        case ObjStatement::Normal:
            ++normals_;
            return;
        case ObjStatement::Type:
            return read_type(keyword);
        case ObjStatement::Degree:
            return read_degree(keyword);
        case ObjStatement::Curve:
        case ObjStatement::Surface:
            return read_element(keyword, statement == ObjStatement::Surface ? 2 : 1);
        case ObjStatement::PlaneCurve:
            in_plane_curve_ = true;
            return;
        case ObjStatement::Parameters:
            return read_parameters(keyword);
        case ObjStatement::Trim:
            return refuse(keyword, "trimmed surfaces are not read");
        case ObjStatement::End:
            return end_element(keyword);
        case ObjStatement::Foreign:
            return refuse(keyword, obj_quoted(keyword.text) + " reaches out of the file: it is not followed");
        case ObjStatement::Other:
            return;
        case ObjStatement::Unknown:
            break;
        }
        refuse(keyword, obj_quoted(keyword.text) + " is no statement of OBJ");
        const std::string meant = obj_did_you_mean(keyword.text);
        if (!meant.empty()) errors_.back().hint = "did you mean `" + meant + "`?";
    }

    void read_vertex(const ObjWord& keyword) {
        if (file_.vertices.size() / free_form_row >= limits_.vertices)
            return refuse_limit(keyword, limits_.vertices, "vertices");
        double numbers[6] = {0, 0, 0, 1, 0, 0};
        std::size_t count = 0;
        while (const auto word = words_.next()) {
            const std::optional<double> number = parse_double(word->text);
            if (!number) return refuse(*word, obj_quoted(word->text) + " is not a number within the range of doubles");
            if (count == 6) return refuse(*word, "a vertex has x y z, a weight w or a colour r g b, and no more");
            numbers[count++] = *number;
        }
        if (count < 3 || count == 5)
            return refuse(keyword, "a vertex has 3, 4 or 6 numbers, not " + std::to_string(count));
        if (count == 6) numbers[3] = 1; // x y z r g b
        file_.vertices.insert(file_.vertices.end(), numbers, numbers + free_form_row);
    }

    void read_type(const ObjWord& keyword) {
        require_closed(keyword);
        auto word = words_.next();
        rational_ = word && word->text == "rat";
        if (rational_) word = words_.next();
        if (!word) return refuse(keyword, "`cstype` needs a type: bspline");
        type_ = word->text;
        refuse_more();
    }

    void read_degree(const ObjWord& keyword) {
        require_closed(keyword);
        degrees_[0] = degrees_[1] = 0;
        for (std::size_t& degree : degrees_) {
            const auto word = words_.next();
            if (!word) break;
            const char* const end = word->text.data() + word->text.size();
            const auto [stop, error] = std::from_chars(word->text.data(), end, degree);
            if (error != std::errc{} || stop != end || degree < 1 || degree > max_input_degree) {
                degree = 0;
                return refuse(*word, "a degree must be a whole number from 1 to " + std::to_string(max_input_degree));
            }
        }
        if (degrees_[0] == 0) return refuse(keyword, "`deg` needs a degree");
        refuse_more();
    }

    /// `curv u0 u1 v1 v2 …` or `surf s0 s1 t0 t1 v1/vt1/vn1 …`.
    void read_element(const ObjWord& keyword, std::size_t directions) {
        require_closed(keyword);
        open_.emplace();
        open_->keyword = keyword;
        open_->element.place = place(keyword.offset);
        open_->element.rational = rational_;
        if (directions == 2) open_->element.v.emplace();
        if (!read_head(keyword, directions)) {
            open_->refused = true;
            return;
        }
        while (const auto word = words_.next())
            if (!read_control(*word, directions == 2)) {
                open_->refused = true;
                return;
            }
    }

    /// Type, degrees and ranges; false after an error.
    bool read_head(const ObjWord& keyword, std::size_t directions) {
        assert(directions == 1 || directions == 2);
        if (type_ != "bspline") {
            refuse(keyword, type_.empty() ? obj_quoted(keyword.text) + " before `cstype`"
                                          : "only `bspline` is read, not `cstype` " + obj_quoted(type_));
            return false;
        }
        for (std::size_t i = 0; i < directions; ++i) {
            if (degrees_[i] == 0) {
                refuse(keyword, obj_quoted(keyword.text) + " needs " + (directions == 2 ? "two degrees" : "a degree") +
                                    " from `deg`");
                return false;
            }
            direction(i).degree = degrees_[i];
            if (!read_range_end(keyword, open_->ranges[i].first) || !read_range_end(keyword, open_->ranges[i].last))
                return false;
        }
        return true;
    }

    bool read_range_end(const ObjWord& keyword, Rational& number) {
        const auto word = words_.next();
        const std::optional<Rational> read = word ? parse_obj_decimal(word->text) : std::nullopt;
        if (read) number = *read;
        if (!read)
            refuse(word.value_or(keyword), obj_quoted(keyword.text) + " begins with the range of its parameters");
        return read.has_value();
    }

    bool read_control(const ObjWord& word, bool may_have_more) {
        if (indices_ >= limits_.vertices) {
            refuse_limit(word, limits_.vertices, "control points");
            return false;
        }
        const std::size_t slash = word.text.find('/');
        const auto vertex = index(word, word.text.substr(0, slash), file_.vertices.size() / free_form_row, "vertex");
        if (!vertex) return false;
        if (slash != std::string_view::npos) {
            if (!may_have_more) {
                refuse(word, "a control point of a curve is one index");
                return false;
            }
            if (!check_more(word, word.text.substr(slash + 1))) return false;
        }
        const double weight = file_.vertices[*vertex * free_form_row + free_form_row - 1];
        if (rational_ && first_bad_weight({&weight, 1})) {
            refuse(word, "the weight of vertex " + std::string(word.text.substr(0, slash)) + " is " +
                             to_string(weight) + ": weights go from " + to_string(smallest_weight) + " to " +
                             to_string(largest_weight));
            return false;
        }
        ++indices_;
        open_->element.vertices.push_back(static_cast<std::uint32_t>(*vertex));
        return true;
    }

    /// What follows the first slash of v/vt/vn: indices too, which nobody uses.
    bool check_more(const ObjWord& word, std::string_view rest) {
        const std::size_t slash = rest.find('/');
        const std::string_view texture = rest.substr(0, slash);
        if (!texture.empty() && !index(word, texture, texture_vertices_, "texture vertex")) return false;
        return slash == std::string_view::npos || index(word, rest.substr(slash + 1), normals_, "normal").has_value();
    }

    /// An index from 1, or from -1 backwards, among `count`; from 0.
    std::optional<std::uint64_t> index(const ObjWord& word, std::string_view text, std::uint64_t count,
                                       const std::string& what) {
        const bool negative = text.starts_with('-');
        const std::string_view digits = negative ? text.substr(1) : text;
        std::uint64_t value = 0;
        const char* const end = digits.data() + digits.size();
        const auto [stop, error] = std::from_chars(digits.data(), end, value);
        if (digits.empty() || stop != end || error == std::errc::invalid_argument) {
            refuse(word, obj_quoted(text) + " is not the index of a " + what);
            return std::nullopt;
        }
        if (error == std::errc{} && value >= 1 && value <= count) return negative ? count - value : value - 1;
        refuse(word, "no " + what + " " + std::string(text.substr(0, 40)) + ": " + std::to_string(count) +
                         (count == 1 ? " stands" : " stand") + " before");
        errors_.back().hint = "indices count from 1, or from -1 backwards";
        return std::nullopt;
    }

    /// `parm u …` or `parm v …`.
    void read_parameters(const ObjWord& keyword) {
        if (!open_) return refuse(keyword, "`parm` outside of a curve or surface");
        if (open_->refused) return;
        open_->refused = true;
        const auto name = words_.next();
        const bool is_v = name && name->text == "v";
        if (!name || (!is_v && name->text != "u")) return refuse(name.value_or(keyword), "`parm` needs u or v");
        const std::size_t which = is_v ? 1 : 0;
        if (is_v && !open_->element.v) return refuse(*name, "a curve has no parameter v");
        if (open_->has_knots[which]) return refuse(*name, "`parm " + std::string(name->text) + "` twice");
        open_->has_knots[which] = true;
        std::vector<Rational>& knots = direction(which).knots;
        while (const auto word = words_.next()) {
            if (knots_ >= limits_.knots) return refuse_limit(*word, limits_.knots, "knots");
            std::optional<Rational> knot = parse_obj_decimal(word->text);
            if (!knot) return refuse(*word, obj_quoted(word->text) + " is not a decimal number");
            knots.push_back(std::move(*knot));
            ++knots_;
        }
        open_->refused = false;
    }

    void end_element(const ObjWord& keyword) {
        if (!open_) return refuse(keyword, "`end` outside of a curve or surface");
        if (!open_->refused && is_whole()) file_.elements.push_back(std::move(open_->element));
        open_.reset();
    }

    /// Whether the counts fit and the ranges are the domains; else says what does not.
    bool is_whole() {
        assert(open_);
        const std::size_t directions = open_->element.v ? 2 : 1;
        std::uint64_t product = 1;
        for (std::size_t i = 0; i < directions; ++i) {
            FreeFormDirection& one = direction(i);
            const std::string name = i == 0 ? "u" : "v";
            if (!open_->has_knots[i]) return refuse_whole("no `parm " + name + "`");
            if (one.knots.size() < 2 * (one.degree + 1))
                return refuse_whole(std::to_string(one.knots.size()) + " knots in `parm " + name + "`, but degree " +
                                    std::to_string(one.degree) + " needs at least " +
                                    std::to_string(2 * (one.degree + 1)));
            one.points = one.knots.size() - one.degree - 1;
            product *= one.points; // both below 2^23, by the limit of knots
        }
        if (product != open_->element.vertices.size())
            return refuse_whole(std::to_string(open_->element.vertices.size()) + " control points, but the knots of " +
                                (directions == 2 ? "both directions are for "
                                                 : "degree " + std::to_string(direction(0).degree) + " are for ") +
                                std::to_string(product));
        return is_domain(0) && (directions == 1 || is_domain(1));
    }

    bool is_domain(std::size_t i) {
        assert(direction(i).points < direction(i).knots.size());
        const FreeFormDirection& one = direction(i);
        const Range& range = open_->ranges[i];
        const Rational& first = one.knots[one.degree];
        const Rational& last = one.knots[one.points];
        if (range.first == first && range.last == last) return true;
        return refuse_whole("the part from " + shown_number(range.first) + " to " + shown_number(range.last) +
                            " is meant, but the domain of the knots is " + shown_number(first) + " to " +
                            shown_number(last) + ": parts are not read");
    }

    FreeFormDirection& direction(std::size_t i) {
        assert(open_ && (i == 0 || open_->element.v));
        return i == 0 ? open_->element.u : *open_->element.v;
    }

    /// An element that is open when another begins has lost its `end`.
    void require_closed(const ObjWord& keyword) {
        if (!open_) return;
        refuse(keyword, obj_quoted(keyword.text) + " before the `end` of " + obj_quoted(open_->keyword.text));
        open_.reset();
    }

    void refuse_more() {
        if (const auto word = words_.next()) refuse(*word, obj_quoted(word->text) + " is one word too many");
    }

    bool refuse_whole(const std::string& message) {
        refuse(open_->keyword, obj_quoted(open_->keyword.text) + ": " + message);
        return false;
    }

    void refuse_limit(const ObjWord& word, std::uint64_t limit, const std::string& what) {
        refuse(word, "more than " + std::to_string(limit) + " " + what + ", the limit");
    }

    void refuse(const ObjWord& word, std::string message) {
        Diagnostic diagnostic = diagnostic_at(text_, word.offset, file_.source, std::move(message));
        diagnostic.width = columns_of(word.text);
        diagnostic.code = "obj.unexpected";
        errors_.push_back(std::move(diagnostic));
    }

    TextPlace place(std::size_t offset) {
        known_place_ = place_of(text_, offset, known_offset_, known_place_);
        known_offset_ = offset;
        return known_place_;
    }

    void add_empty_error() {
        Diagnostic diagnostic;
        diagnostic.source = file_.source;
        diagnostic.code = "obj.empty";
        diagnostic.message = "no curve or surface of free form";
        diagnostic.hint = "they are written: cstype bspline, deg, curv or surf, parm, end";
        errors_.push_back(std::move(diagnostic));
    }

    std::string_view text_;
    ObjWords words_;
    ObjLimits limits_;
    FreeFormFile file_;
    std::vector<Diagnostic> errors_;
    std::string_view type_;
    bool rational_ = false;
    std::size_t degrees_[2] = {0, 0}; ///< 0 = not said
    std::optional<OpenElement> open_;
    bool in_plane_curve_ = false;
    std::uint64_t texture_vertices_ = 0;
    std::uint64_t normals_ = 0;
    std::uint64_t indices_ = 0; ///< indices of all elements
    std::uint64_t knots_ = 0;   ///< knots of all elements
    std::size_t known_offset_ = 0;
    TextPlace known_place_;
};

} // namespace

ParsedFreeForms read_obj_freeform(std::string_view text, std::string_view source, const ObjLimits& limits) {
    return ObjReader(text, source, limits).read();
}

bool looks_like_obj(std::string_view text) {
    ObjWords words(text);
    const auto keyword = words.next_statement();
    return keyword && obj_statement(keyword->text) != ObjStatement::Unknown && words.next();
}

} // namespace internode
