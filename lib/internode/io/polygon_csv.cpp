// SPDX-License-Identifier: MIT
//
// Long runs of points are cut into windows, which are read side by side and taken in their order; a window is taken as
// far as its lines are numbers and nothing else (PlainLines). What is left is read a line at a time. A line that parts
// polygons is kept until the next point comes: that point begins a polygon and takes the parting lines along, so that
// blank lines at both ends of a file say nothing.

#include "internode/io/polygon.h"

#include "internode/io/file/limits.h"
#include "internode/stencil/parallel.h"
#include "internode/text/number.h"
#include "internode/text/utf8.h"

#include <algorithm>
#include <array>
#include <cassert>

namespace internode {

namespace {

/// A field of a line: blanks and quotes taken off.
struct Field {
    std::string_view text;
    std::size_t offset = 0; ///< where the text stands in its line
};

std::string_view trimmed(std::string_view text, std::string_view blanks) {
    const std::size_t first = text.find_first_not_of(blanks);
    if (first == std::string_view::npos) return text.substr(text.size());
    return text.substr(first, text.find_last_not_of(blanks) - first + 1);
}

/// "nan", "-Inf", "infinity": what other programs write for numbers that are not finite.
bool is_named_number(std::string_view text) {
    if (text.starts_with('+') || text.starts_with('-')) text.remove_prefix(1);
    constexpr std::array<std::string_view, 3> names{"nan", "inf", "infinity"};
    const auto same_letter = [](char a, char b) { return a == b || (a >= 'A' && a <= 'Z' && a - 'A' == b - 'a'); };
    return std::ranges::any_of(names,
                               [&](std::string_view name) { return std::ranges::equal(text, name, same_letter); });
}

/// Whether a field of the first line is the name of a coordinate; a damaged number is not.
bool is_name(const Field& field) {
    constexpr std::string_view begins_a_number = "0123456789+-.";
    return !field.text.empty() && begins_a_number.find(field.text.front()) == std::string_view::npos &&
           !is_named_number(field.text);
}

std::string quoted(std::string_view text) {
    constexpr std::size_t shown = 40;
    return '`' + std::string(text.substr(0, shown)) + (text.size() > shown ? "...`" : "`");
}

std::string unescaped(std::string_view text) {
    std::string name;
    for (std::size_t i = 0; i < text.size(); ++i) {
        name += text[i];
        if (text.substr(i).starts_with("\"\"")) ++i;
    }
    return name;
}

char separator_of(std::string_view line) {
    if (line.find(';') != std::string_view::npos) return ';';
    return line.find('\t') != std::string_view::npos ? '\t' : ',';
}

/// The lines at the front of a text that are points like those before, and no line that must be asked what it is.
struct PlainLines {
    std::vector<double> numbers;
    std::size_t lines = 0;
    std::size_t bytes = 0;
};

/// Whether a line is `dimension` numbers and nothing else; appends what it has read in any case.
bool append_numbers(std::string_view line, char separator, std::size_t dimension, std::vector<double>& numbers) {
    const std::string_view blanks = separator == '\t' ? " " : " \t";
    std::size_t begin = 0;
    for (std::size_t field = 0; field < dimension; ++field) {
        if (begin > line.size()) return false;
        const std::size_t end = std::min(line.find(separator, begin), line.size());
        const std::optional<double> value = parse_double(trimmed(line.substr(begin, end - begin), blanks));
        if (!value) return false;
        numbers.push_back(*value);
        begin = end + 1;
    }
    return begin > line.size();
}

/// Reads lines of `dimension` numbers up to the first line that is anything else.
PlainLines plain_lines(std::string_view text, char separator, std::size_t dimension) {
    PlainLines plain;
    while (plain.bytes < text.size()) {
        std::string_view line = text.substr(plain.bytes, text.find('\n', plain.bytes) - plain.bytes);
        const std::size_t bytes = std::min(line.size() + 1, text.size() - plain.bytes);
        if (line.ends_with('\r')) line.remove_suffix(1);
        if (!append_numbers(line, separator, dimension, plain.numbers)) break;
        ++plain.lines;
        plain.bytes += bytes;
    }
    plain.numbers.resize(plain.lines * dimension);
    return plain;
}

/// A text in windows of whole lines.
std::vector<std::string_view> windows_of(std::string_view text, std::size_t most) {
    constexpr std::size_t size = std::size_t{1} << 18;
    std::vector<std::string_view> windows;
    while (!text.empty() && windows.size() < most) {
        const std::size_t end = text.find('\n', std::min(size, text.size()));
        windows.push_back(text.substr(0, end == std::string_view::npos ? end : end + 1));
        text.remove_prefix(windows.back().size());
    }
    return windows;
}

class CsvReader {
public:
    CsvReader(std::string_view text, std::string_view source, int threads)
        : text_(without_byte_order_mark(text))
        , source_(source)
        , threads_(threads) {}

    ParsedPolygons read() && {
        while (!text_.empty() && errors_.size() < max_polygon_errors) {
            if (begun_ && errors_.empty()) read_plain_lines();
            if (text_.empty()) break;
            line_ = text_.substr(0, text_.find('\n'));
            text_.remove_prefix(std::min(line_.size() + 1, text_.size()));
            if (line_.ends_with('\r')) line_.remove_suffix(1);
            ++line_number_;
            read_line();
        }
        if (head_line_ > 0 && errors_.size() < max_polygon_errors) refuse_empty_part();
        if (polygons_.empty() && errors_.empty()) add_empty_error();
        if (!errors_.empty()) return {.polygons = {}, .errors = std::move(errors_)};
        if (polygons_.size() == 1) polygons_.front().line = 0;
        return {.polygons = std::move(polygons_), .errors = {}};
    }

private:
    /// Takes what lies before the next line that is no point, or before the end of the text. A run that ends early has
    /// been read in vain beyond: the fewer windows are tried at once.
    void read_plain_lines() {
        std::size_t most = 1;
        bool goes_on = true;
        while (goes_on && !text_.empty()) {
            const std::vector<std::string_view> windows = windows_of(text_, most);
            std::vector<PlainLines> read(windows.size());
            for_each_task(windows.size(), threads_,
                          [&](std::size_t i) { read[i] = plain_lines(windows[i], separator_, dimension_); });
            for (std::size_t i = 0; i < windows.size() && goes_on; ++i) {
                take(read[i]);
                goes_on = read[i].bytes == windows[i].size();
            }
            most = std::min<std::size_t>(2 * most, 64);
        }
    }

    void take(const PlainLines& plain) {
        assert(begun_ && plain.numbers.size() == plain.lines * dimension_);
        std::vector<double>& points = polygons_.back().points;
        points.insert(points.end(), plain.numbers.begin(), plain.numbers.end());
        line_number_ += plain.lines;
        text_.remove_prefix(plain.bytes);
    }

    void read_line() {
        const std::string_view content = trimmed(line_, " \t");
        if (content.empty()) return read_blank();
        if (content.front() == '#') return;
        if (content.front() == '>') return read_head(content);
        const bool is_first = separator_ == '\0';
        if (is_first) separator_ = separator_of(content);
        if (!split()) return;
        if (is_first) dimension_ = fields_.size();
        if (is_first && std::ranges::all_of(fields_, is_name)) {
            for (const Field& field : fields_) columns_.push_back(unescaped(field.text));
            return;
        }
        if (fields_.size() != dimension_) return refuse_length();
        if (!begun_ && is_header_again()) return;
        if (!begun_) begin_polygon();
        read_point();
    }

    /// A blank line ends the polygon; more than two say no more than two (gnuplot has a meaning for either).
    void read_blank() {
        if (begun_) break_text_.clear();
        if (!polygons_.empty() && head_line_ == 0 && break_text_.size() < 2) break_text_ += '\n';
        begun_ = false;
    }

    void read_head(std::string_view content) {
        if (head_line_ > 0) refuse_empty_part();
        if (begun_) break_text_.clear();
        break_text_ += std::string(content) + '\n';
        begun_ = false;
        head_line_ = line_number_;
        head_ = content;
    }

    [[nodiscard]] bool is_header_again() const {
        const auto same = [](const Field& field, const std::string& name) { return unescaped(field.text) == name; };
        return std::ranges::equal(fields_, columns_, same);
    }

    void begin_polygon() {
        assert(!begun_ && dimension_ > 0);
        InputPolygon& polygon = polygons_.emplace_back();
        polygon.source = source_;
        polygon.dimension = dimension_;
        polygon.columns = columns_;
        polygon.line = line_number_;
        polygon.break_text = std::move(break_text_);
        break_text_.clear();
        head_line_ = 0;
        begun_ = true;
    }

    void read_point() {
        assert(begun_ && !polygons_.empty());
        for (const Field& field : fields_) {
            const std::optional<double> value = parse_double(field.text);
            if (!value) return refuse_number(field);
            polygons_.back().points.push_back(*value);
        }
    }

    /// Cuts line_ into fields_; false after an error.
    bool split() {
        fields_.clear();
        const std::string_view blanks = separator_ == '\t' ? " " : " \t";
        assert(separator_ != '\0');
        for (std::size_t begin = 0; begin <= line_.size();) {
            if (fields_.size() == max_dimension) {
                refuse(begin, 1, "more than " + std::to_string(max_dimension) + " coordinates, the limit");
                return false;
            }
            const std::size_t text = std::min(line_.find_first_not_of(blanks, begin), line_.size());
            const bool is_quoted = text < line_.size() && line_[text] == '"';
            const std::size_t end = is_quoted ? split_quoted(text) : split_plain(begin, blanks);
            if (end == std::string_view::npos) return false;
            begin = end + 1;
        }
        return true;
    }

    /// Takes the field from `begin` to the next separator, and returns where that is.
    std::size_t split_plain(std::size_t begin, std::string_view blanks) {
        const std::size_t end = std::min(line_.find(separator_, begin), line_.size());
        const std::string_view text = trimmed(line_.substr(begin, end - begin), blanks);
        fields_.push_back({text, static_cast<std::size_t>(text.data() - line_.data())});
        return end;
    }

    /// The same for a field that opens with a quote at `quote`; inside, "" is a quote. npos after an error.
    std::size_t split_quoted(std::size_t quote) {
        assert(quote < line_.size() && line_[quote] == '"');
        std::size_t end = quote + 1;
        while (end < line_.size() && (line_[end] != '"' || line_.substr(end).starts_with("\"\"")))
            end += line_[end] == '"' ? 2 : 1;
        if (end >= line_.size()) {
            refuse(quote, 1, "a quote that is not closed");
            return std::string_view::npos;
        }
        fields_.push_back({line_.substr(quote + 1, end - quote - 1), quote + 1});
        const std::size_t next = std::min(line_.find_first_not_of(' ', end + 1), line_.size());
        if (next < line_.size() && line_[next] != separator_) {
            refuse(next, 1, "text after a closed quote");
            return std::string_view::npos;
        }
        return next;
    }

    void refuse_length() {
        assert(!fields_.empty());
        const std::string counts = std::to_string(fields_.size()) +
                                   (fields_.size() == 1 ? " coordinate" : " coordinates") +
                                   ", but the first line has " + std::to_string(dimension_);
        refuse(fields_.back().offset, 1, counts);
        if (fields_.size() == 1) errors_.back().hint = separator_hint();
    }

    void refuse_number(const Field& field) {
        const std::string_view text = field.text;
        const std::size_t width = columns_of(text);
        if (text.empty()) return refuse(field.offset, 1, "an empty field where a number is meant");
        if (is_named_number(text)) return refuse(field.offset, width, quoted(text) + " is not a finite number");
        refuse(field.offset, width, quoted(text) + " is not a number within the range of doubles");
        if (separator_ != ',' && text.find(',') != std::string_view::npos)
            errors_.back().hint = "the decimal sign is a point: write 1.5 for 1,5";
        else if (text.find_first_of(" ;\t") != std::string_view::npos)
            errors_.back().hint = separator_hint();
    }

    std::string separator_hint() const {
        const std::string name = separator_ == '\t' ? "a tab" : std::string{'`', separator_, '`'};
        return "coordinates are separated by " + name + " here, as in the first line; `,`, `;` and tabs are understood";
    }

    /// Of a line `> …` that no point follows.
    void refuse_empty_part() {
        Diagnostic diagnostic = diagnostic_at(head_, 0, source_, "no point follows in this part");
        diagnostic.line = head_line_;
        errors_.push_back(std::move(diagnostic));
    }

    void add_empty_error() {
        Diagnostic diagnostic;
        diagnostic.source = source_;
        diagnostic.code = "csv.empty";
        diagnostic.message = "no point";
        diagnostic.hint = "write a point a line: 0.5, 1.25";
        errors_.push_back(std::move(diagnostic));
    }

    void refuse(std::size_t offset, std::size_t width, std::string message) {
        Diagnostic diagnostic = diagnostic_at(line_, offset, source_, std::move(message));
        diagnostic.line = line_number_;
        diagnostic.width = width;
        diagnostic.code = "csv.unexpected";
        errors_.push_back(std::move(diagnostic));
    }

    std::string_view text_; ///< what is not read yet
    std::string_view source_;
    int threads_;
    std::string_view line_;
    std::size_t line_number_ = 0;
    char separator_ = '\0'; ///< none before the first line with content
    std::vector<Field> fields_;
    std::size_t dimension_ = 0;
    std::vector<std::string> columns_;
    bool begun_ = false;        ///< a polygon is open: the next point belongs to it
    std::string break_text_;    ///< the break text of the polygon to come
    std::string_view head_;     ///< the last line `> …`
    std::size_t head_line_ = 0; ///< the line of head_, while no point has followed; else 0
    std::vector<InputPolygon> polygons_;
    std::vector<Diagnostic> errors_;
};

} // namespace

ParsedPolygons read_polygons_csv(std::string_view text, std::string_view source, int threads) {
    return CsvReader(text, source, threads).read();
}

} // namespace internode
