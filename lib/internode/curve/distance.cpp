// SPDX-License-Identifier: MIT
//
// The β_i of an interval depend on its window alone: tables of them are kept by window, and each knows the one that a
// letter more leads to. A sum with their largest coefficients passes most intervals over. In the others both
// polynomials are halved until the hull of their control points is hardly above what some end of a piece attains. Slope
// jumps are made by the stretch, once for their scale and once for the search, and never kept.

#include "internode/curve/distance.h"

#include "internode/curve/deviation.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <unordered_map>

namespace internode {

namespace {

/// Relative gap at which a piece is no longer halved: 2^-30.
constexpr double search_gap = 0x1p-30;
/// Halvings of one piece at most; its ends then coincide in double.
constexpr int search_depth = 52;
/// Rounding in a Bernstein coefficient: at most 11 products of non-negative factors, 11 sums, a norm of relative error
/// below (dimension + 3) / 2 units, and 52 halvings of half a unit each. For the dimensions in use that is far below
/// 2^-44.
constexpr double rounding_margin = 0x1p-44;
/// Tables kept at once; a word with more different windows than that only recomputes some.
constexpr std::size_t table_limit = 1024;

/// The largest power of two that is at most value > 0.
double power_of_two_below(double value) {
    assert(value > 0);
    int exponent = 0;
    (void)std::frexp(value, &exponent);
    return std::ldexp(1.0, exponent - 1);
}

double largest_of(std::span<const double> values) {
    double largest = 0;
    for (const double value : values) largest = std::max(largest, std::abs(value));
    return largest;
}

/// The power of two that brings all values below 2 and the largest to 1 or above; 0 for zeros.
double scale_of(double largest) {
    return largest == 0 ? 0 : power_of_two_below(largest);
}

double norm(const double* vector, std::size_t dimension) {
    double largest = 0;
    for (std::size_t c = 0; c < dimension; ++c) largest = std::max(largest, std::abs(vector[c]));
    if (largest == 0) return 0;
    double sum = 0;
    for (std::size_t c = 0; c < dimension; ++c) sum += (vector[c] / largest) * (vector[c] / largest);
    return largest * std::sqrt(sum);
}

/// The supremum of ‖p(x)‖ over many Bézier pieces p, by halving and the convex hull of the control points.
class Supremum {
public:
    Supremum(std::size_t degree, std::size_t dimension)
        : degree_(degree)
        , dimension_(dimension) {}

    /// A value attained at some point.
    [[nodiscard]] double attained() const { return attained_; }
    /// A value that is never exceeded.
    [[nodiscard]] double bound() const { return std::max(attained_, bound_); }

    /// Takes degree + 1 Bernstein coefficients of `dimension` numbers into account.
    void add(const std::vector<double>& coefficients) {
        assert(coefficients.size() == (degree_ + 1) * dimension_);
        if (settle(look_at(coefficients))) return;
        pending_.clear();
        halve({coefficients, 0});
        while (!pending_.empty()) {
            Piece piece = std::move(pending_.back());
            pending_.pop_back();
            const double hull = look_at(piece.coefficients);
            if (piece.halvings == search_depth)
                bound_ = std::max(bound_, hull);
            else if (!settle(hull))
                halve(std::move(piece));
        }
    }

private:
    struct Piece {
        std::vector<double> coefficients;
        int halvings;
    };

    /// Whether a piece below this hull cannot matter beyond the gap; it then counts in the bound.
    bool settle(double hull) {
        if (hull > attained_ * (1 + search_gap)) return false;
        bound_ = std::max(bound_, hull);
        return true;
    }

    /// The largest norm of a control point; the ends are attained.
    double look_at(const std::vector<double>& coefficients) {
        double hull = 0;
        for (std::size_t b = 0; b <= degree_; ++b) {
            const double size = norm(coefficients.data() + b * dimension_, dimension_);
            hull = std::max(hull, size);
            if (b == 0 || b == degree_) attained_ = std::max(attained_, size);
        }
        return hull;
    }

    /// De Casteljau at 1/2: `right` ends as the right half, its first entries of each level as the left one.
    void halve(Piece piece) {
        std::vector<double>& right = piece.coefficients;
        std::vector<double> left(right.size());
        for (std::size_t b = 0; b <= degree_; ++b) {
            std::copy_n(right.data(), dimension_, left.data() + b * dimension_);
            for (std::size_t i = 0; i < (degree_ - b) * dimension_; ++i)
                right[i] = 0.5 * right[i] + 0.5 * right[i + dimension_];
        }
        pending_.push_back({std::move(left), piece.halvings + 1});
        pending_.push_back({std::move(piece.coefficients), piece.halvings + 1});
    }

    std::size_t degree_;
    std::size_t dimension_;
    double attained_ = 0;
    double bound_ = 0;
    std::vector<Piece> pending_;
};

/// a_i of every symbol of the word, and 0 for the letter `0`.
class LetterLengths {
public:
    explicit LetterLengths(const Curve& curve)
        : lengths_(curve.system().alphabet().size()) {
        for (const Symbol symbol : curve.word())
            if (symbol != zero_interval && lengths_[to_index(symbol)] == 0)
                lengths_[to_index(symbol)] = curve.system().length(symbol).to_double();
    }
    double operator[](Symbol symbol) const { return symbol == zero_interval ? 0 : lengths_[to_index(symbol)]; }

private:
    std::vector<double> lengths_;
};

/// Indices of control points and letters of a curve, taken modulo N where it is closed.
struct Wrap {
    std::size_t size;
    bool closed;
    std::size_t operator()(std::size_t index) const { return closed ? index % size : index; }
};

/// The slope jumps D_i of the polygon of a curve whose points are divided by `point_scale`. Rows that no piece uses
/// (the ends of an open curve, the two sides of a break) are 0.
class SlopeJumps {
public:
    SlopeJumps(const Curve& curve, const LetterLengths& lengths, double point_scale)
        : curve_(curve)
        , lengths_(lengths)
        , point_scale_(point_scale)
        , first_(curve.ends() == Ends::Circular ? 0 : 1)
        , end_(curve.size() - first_) {}

    /// Rows first … first + count - 1, modulo N, divided by `scale`; `rows` has as many times the dimension numbers.
    void put(std::size_t first, double scale, std::span<double> rows) const {
        const std::size_t dimension = curve_.dimension();
        assert(rows.size() % dimension == 0);
        std::size_t i = first % curve_.size();
        double left = gap(i == 0 ? curve_.size() - 1 : i - 1);
        for (double* row = rows.data(); row != rows.data() + rows.size(); row += dimension) {
            const double right = gap(i);
            put_row(i, left, right, row);
            for (std::size_t c = 0; c < dimension; ++c) row[c] /= scale;
            left = right;
            if (++i == curve_.size()) i = 0;
        }
    }

private:
    /// ξ_{k+1} - ξ_k = (t_{k+d+1} - t_{k+1}) / d, a sum of d lengths.
    [[nodiscard]] double gap(std::size_t k) const {
        const Word& word = curve_.word();
        const auto degree = static_cast<std::size_t>(curve_.degree());
        double sum = 0;
        std::size_t letter = k;
        for (std::size_t i = 1; i <= degree; ++i) {
            if (++letter >= word.size()) letter -= word.size();
            sum += lengths_[word[letter]];
        }
        return sum / curve_.degree();
    }

    void put_row(std::size_t i, double left, double right, double* row) const {
        const std::size_t dimension = curve_.dimension();
        if (i < first_ || i >= end_ || left == 0 || right == 0) {
            std::fill_n(row, dimension, 0);
            return;
        }
        const double* const at = curve_.points().data() + i * dimension;
        const double* const before = i == 0 ? curve_.points().data() + (curve_.size() - 1) * dimension : at - dimension;
        const double* const after = i + 1 == curve_.size() ? curve_.points().data() : at + dimension;
        for (std::size_t c = 0; c < dimension; ++c) {
            const double v = at[c] / point_scale_;
            row[c] = (after[c] / point_scale_ - v) / right - (v - before[c] / point_scale_) / left;
        }
    }

    const Curve& curve_;
    const LetterLengths& lengths_;
    double point_scale_;
    std::size_t first_; ///< rows first_ … end_ - 1 are jumps
    std::size_t end_;
};

/// Intervals looked at together: their jumps stay in a first cache.
constexpr std::size_t stretch_size = 256;

double largest_jump(const Curve& curve, const SlopeJumps& jumps) {
    std::vector<double> rows;
    double largest = 0;
    for (std::size_t first = 0; first < curve.size(); first += stretch_size) {
        rows.resize(std::min(stretch_size, curve.size() - first) * curve.dimension());
        jumps.put(first, 1, rows);
        largest = std::max(largest, largest_of(rows));
    }
    return largest;
}

/// Both searches over every piece of the curve: Σ D_i β_i and Σ ‖D_i‖ β_i.
class Search {
public:
    Search(const Curve& curve, const LetterLengths& lengths)
        : curve_(curve)
        , degree_(static_cast<std::size_t>(curve.degree()))
        , wrap_{curve.size(), curve.ends() == Ends::Circular}
        , lengths_(lengths)
        , error_(degree_, curve.dimension())
        , envelope_(degree_, 1) {}

    /// Of slope jumps divided by `scale`.
    void run(const SlopeJumps& jumps, double scale) {
        for (std::size_t first = wrap_.closed ? 0 : degree_; first < curve_.size(); first += stretch_size)
            run_stretch(first, std::min(first + stretch_size, curve_.size()), jumps, scale);
    }
    [[nodiscard]] const Supremum& error() const { return error_; }
    [[nodiscard]] const Supremum& envelope() const { return envelope_; }

private:
    struct Table {
        std::vector<DeviationPiece> pieces;
        std::vector<double> largest; ///< the largest Bernstein coefficient of each β_i over the pieces
        std::vector<Table*> next; ///< the table of the window one letter on, by that letter, `0` last; null: not asked
    };

    void run_stretch(std::size_t begin, std::size_t end, const SlopeJumps& jumps, double scale) {
        const std::size_t dimension = curve_.dimension();
        jumps_.resize((end - begin + degree_ - 2) * dimension);
        jumps.put(first_place(begin), scale, jumps_);
        sizes_.resize(jumps_.size() / dimension);
        for (std::size_t i = 0; i < sizes_.size(); ++i) sizes_[i] = norm(jumps_.data() + i * dimension, dimension);
        for (std::size_t j = begin; j < end; ++j) {
            const Table& near = table(j);
            if (reach(near, j - begin) <= std::min(error_.attained(), envelope_.attained())) continue;
            for (const DeviationPiece& piece : near.pieces) {
                error_.add(combination(piece, jumps_.data() + (j - begin) * dimension, dimension));
                envelope_.add(combination(piece, sizes_.data() + (j - begin), 1));
            }
        }
    }

    /// Place j - d + 1: of the window's first letter, and of the first slope jump. Kept non-negative by whole turns of
    /// a closed word.
    [[nodiscard]] std::size_t first_place(std::size_t j) const {
        assert(wrap_.closed || j + 1 >= degree_);
        return wrap_.closed ? j + 1 + (degree_ * wrap_.size - degree_) : j + 1 - degree_;
    }

    /// A bound on envelope and error over an interval of the stretch, at the cost of one sum.
    [[nodiscard]] double reach(const Table& near, std::size_t place) const {
        double sum = 0;
        for (std::size_t i = 0; i + 1 < degree_; ++i) sum += near.largest[i] * sizes_[place + i];
        return sum * (1 + rounding_margin);
    }

    /// The table of interval j, which follows the one asked for before it.
    const Table& table(std::size_t j) {
        if (last_ == nullptr) return *(last_ = &found_table(j));
        const Symbol letter = curve_.word()[wrap_(first_place(j) + 2 * degree_ - 2)];
        const std::size_t choice = letter == zero_interval ? last_->next.size() - 1 : to_index(letter);
        Table*& next = last_->next[choice];
        if (next == nullptr) {
            if (tables_.size() > table_limit) {
                tables_.clear();
                return *(last_ = &found_table(j));
            }
            next = &found_table(j);
        }
        return *(last_ = next);
    }

    Table& found_table(std::size_t j) {
        const Word& word = curve_.word();
        window_.resize(2 * degree_ - 1);
        const std::size_t first = first_place(j);
        for (std::size_t i = 0; i < window_.size(); ++i) window_[i] = word[wrap_(first + i)];
        const auto [place, is_new] = tables_.try_emplace(window_);
        if (is_new) {
            std::vector<double> local;
            for (const Symbol symbol : window_) local.push_back(lengths_[symbol]);
            place->second = make_table(local);
        }
        return place->second;
    }

    [[nodiscard]] Table make_table(const std::vector<double>& lengths) const {
        assert(lengths.size() == 2 * degree_ - 1);
        Table result;
        result.largest.resize(degree_ - 1);
        result.next.resize(curve_.system().alphabet().size() + 1);
        if (lengths[degree_ - 1] > 0) result.pieces = deviation_pieces(lengths); // an empty interval has none
        for (const DeviationPiece& piece : result.pieces)
            for (std::size_t k = 0; k < piece.coefficients.size(); ++k) {
                double& largest = result.largest[k % (degree_ - 1)];
                largest = std::max(largest, std::abs(piece.coefficients[k]));
            }
        return result;
    }

    /// Bernstein coefficients Σ_i β_i D_i over one piece of an interval; D_i are rows of `dimension` numbers, from the
    /// first that counts there.
    const std::vector<double>& combination(const DeviationPiece& piece, const double* rows, std::size_t dimension) {
        coefficients_.assign((degree_ + 1) * dimension, 0);
        for (std::size_t b = 0; b <= degree_; ++b)
            for (std::size_t i = 0; i + 1 < degree_; ++i) {
                const double weight = piece.coefficients[b * (degree_ - 1) + i];
                const double* row = rows + i * dimension;
                for (std::size_t c = 0; c < dimension; ++c) coefficients_[b * dimension + c] += weight * row[c];
            }
        return coefficients_;
    }

    const Curve& curve_;
    std::size_t degree_;
    Wrap wrap_;
    const LetterLengths& lengths_;
    Supremum error_;
    Supremum envelope_;
    Word window_;
    std::vector<double> jumps_; ///< of the stretch, from place j - d + 1 of its first interval on
    std::vector<double> sizes_; ///< their norms
    std::vector<double> coefficients_;
    std::unordered_map<Word, Table, WordHash> tables_;
    Table* last_ = nullptr;
};

} // namespace

PolygonDistance polygon_distance(const Curve& curve) {
    PolygonDistance distance;
    if (curve.degree() == 1) return distance;
    // The distance does not depend on the scale of the parameter: the lengths of step 0 serve every step. Powers of two
    // keep differences and squares of extreme coordinates finite and cost no digit.
    const LetterLengths lengths(curve);
    const double point_scale = scale_of(largest_of(curve.points()));
    if (point_scale == 0) return distance;
    const SlopeJumps jumps(curve, lengths, point_scale);
    const double jump_scale = scale_of(largest_jump(curve, jumps));
    if (jump_scale == 0) return distance;

    Search search(curve, lengths);
    search.run(jumps, jump_scale);
    const auto scaled = [&](double value) { return value * jump_scale * point_scale; };
    distance.error = scaled(search.error().attained());
    distance.error_bound = scaled(search.error().bound() * (1 + rounding_margin));
    distance.envelope = scaled(std::max(search.envelope().bound(), search.error().bound()) * (1 + rounding_margin));
    return distance;
}

} // namespace internode
