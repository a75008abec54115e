// SPDX-License-Identifier: MIT
//
// Stops of u ascend, and so do the rows of points that they need: d_u + 1 of them are held, already evaluated along v,
// and the oldest leave when the next letter of u begins. The noise below which a tangent has vanished is that of the
// given points: of their differences, or, where weights have been multiplied into them, of the points themselves.

#include "internode/surface/normal_rows.h"

#include "internode/algebra/powers_of_two.h"
#include "internode/curve/derivatives.h"
#include "internode/surface/normal.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

namespace internode {

namespace {

constexpr double epsilon = std::numeric_limits<double>::epsilon();
/// Roundings of a difference of two points that were computed themselves, in units in the last place.
constexpr double difference_noise = 8 * epsilon;
/// Roundings of w S, and of A_u - w_u S where both are made of such products.
constexpr double product_noise = 16 * epsilon;

std::size_t modulo(std::ptrdiff_t index, std::size_t size) {
    assert(size > 0);
    const auto signed_size = static_cast<std::ptrdiff_t>(size);
    return static_cast<std::size_t>((index % signed_size + signed_size) % signed_size);
}

} // namespace

StopBasis::StopBasis(const Knots& given, const Knots& fine)
    : spans_(given)
    , walk_(given, spans_, fine) {}

void StopBasis::go_to(const Stop& stop) {
    const std::size_t before = place_.letter;
    place_ = stop.from_left ? walk_.end() : walk_.next();
    if (!value_basis_ || place_.letter != before) enter();
    const auto values = value_basis_->at(place_.offset);
    values_.assign(values.begin(), values.end());
    const auto slopes = slope_basis_->at(place_.offset);
    slopes_.assign(slopes.begin(), slopes.end());
}

void StopBasis::enter() {
    const int degree = spans_.degree();
    value_basis_.emplace(spans_, place_.letter, degree);
    slope_basis_.emplace(spans_, place_.letter, degree - 1);
    pace_ = 0;
    for (int back = degree - 1; back >= 0; --back) {
        const double span = spans_.between(static_cast<std::ptrdiff_t>(place_.letter) - back, degree).hi;
        assert(span > 0);
        pace_ = std::max(pace_, degree / span);
    }
}

NormalRows::NormalRows(const Grid& given, const Grid& fine, const Stops& v)
    : grid_(given)
    , u_(given.u(), fine.u())
    , spans_v_(given.v())
    , exponent_(safe_exponent(given.points())) {
    assert(given.dimension() == fine.dimension());
    StopBasis basis(given.v(), fine.v());
    for (const Stop& stop : v.stops) {
        basis.go_to(stop);
        columns_.push_back({basis.letter(), basis.values(), basis.slopes(), basis.pace(), stop.from_left});
    }
    const std::size_t width = columns_.size() * grid_.dimension();
    for (LongRows* rows : {&values_, &slopes_, &values_u_, &slopes_u_}) rows->dimension = width;
    for (std::vector<DoubleDouble>* row : {&position_, &along_u_, &along_v_, &mixed_}) row->resize(width);
    measure_noise();
}

void NormalRows::append(const Stop& stop, std::vector<double>& normals) {
    u_.go_to(stop);
    if (last_row_ != static_cast<std::ptrdiff_t>(u_.letter())) enter(u_.letter());
    combine(u_.values(), values_, position_.data());
    combine(u_.slopes(), values_u_, along_u_.data());
    combine(u_.values(), slopes_, along_v_.data());
    combine(u_.slopes(), slopes_u_, mixed_.data());
    const std::size_t dimension = grid_.dimension();
    for (std::size_t j = 0; j < columns_.size(); ++j) {
        const Column& column = columns_[j];
        const auto at = [&](const std::vector<DoubleDouble>& row) {
            return std::span<const DoubleDouble>(row.data() + j * dimension, dimension);
        };
        const LocalSurface surface{at(position_),
                                   at(along_u_),
                                   at(along_v_),
                                   at(mixed_),
                                   noise_u_ * u_.pace(),
                                   noise_v_ * column.pace,
                                   std::min(noise_u_, noise_v_) * u_.pace() * column.pace,
                                   stop.from_left,
                                   column.from_left};
        const Vector3 normal = unit_normal(surface);
        normals.insert(normals.end(), normal.begin(), normal.end());
    }
}

void NormalRows::measure_noise() {
    const std::size_t dimension = grid_.dimension();
    const std::size_t rows = grid_.u().size();
    const std::size_t columns = grid_.v().size();
    const auto coordinate = [&](std::size_t i, std::size_t j, std::size_t c) {
        return times_power_of_two(grid_.points()[(i * columns + j) * dimension + c], -exponent_);
    };
    double size = 0;
    double along_u = 0;
    double along_v = 0;
    for (std::size_t i = 0; i < rows; ++i)
        for (std::size_t j = 0; j < columns; ++j)
            for (std::size_t c = 0; c < dimension; ++c) {
                const double here = coordinate(i, j, c);
                size = std::max(size, std::abs(here));
                along_u = std::max(along_u, std::abs(coordinate((i + 1) % rows, j, c) - here));
                along_v = std::max(along_v, std::abs(coordinate(i, (j + 1) % columns, c) - here));
            }
    noise_u_ = grid_.rational() ? product_noise * size : difference_noise * along_u;
    noise_v_ = grid_.rational() ? product_noise * size : difference_noise * along_v;
}

/// Makes the rows over a letter of u, of which some may be there already.
void NormalRows::enter(std::size_t letter) {
    const auto last = static_cast<std::ptrdiff_t>(letter);
    const std::ptrdiff_t first = last - grid_.u().degree();
    assert(last > last_row_);
    const bool keeps = last_row_ >= first && values_.size() > 0;
    for (LongRows* rows : {&values_, &slopes_}) {
        const std::size_t gone = keeps ? static_cast<std::size_t>(last - last_row_) : rows->size();
        const auto begin = rows->coordinates.begin();
        rows->coordinates.erase(begin, begin + static_cast<std::ptrdiff_t>(gone * rows->dimension));
    }
    for (std::ptrdiff_t row = keeps ? last_row_ + 1 : first; row <= last; ++row) add_row(row);
    assert(values_.size() == static_cast<std::size_t>(last - first) + 1 && slopes_.size() == values_.size());
    last_row_ = last;
    values_u_ = differences(u_.spans(), letter, values_);
    slopes_u_ = differences(u_.spans(), letter, slopes_);
}

/// Evaluates a row of points at all columns.
void NormalRows::add_row(std::ptrdiff_t row) {
    const std::size_t dimension = grid_.dimension();
    const std::size_t place = modulo(row, grid_.u().size());
    LongRows points;
    LongRows slopes;
    for (std::size_t j = 0; j < columns_.size(); ++j) {
        const Column& column = columns_[j];
        if (j == 0 || column.letter != columns_[j - 1].letter) {
            points = points_over(place, column.letter);
            slopes = differences(spans_v_, column.letter, points);
        }
        for (auto* rows : {&values_, &slopes_}) rows->coordinates.resize(rows->coordinates.size() + dimension);
        combine(column.values, points, &*(values_.coordinates.end() - static_cast<std::ptrdiff_t>(dimension)));
        combine(column.slopes, slopes, &*(slopes_.coordinates.end() - static_cast<std::ptrdiff_t>(dimension)));
    }
}

/// The d_v + 1 points of a row that reach over a letter of v.
LongRows NormalRows::points_over(std::size_t row, std::size_t letter) const {
    const std::size_t dimension = grid_.dimension();
    LongRows points{dimension, {}};
    for (int back = grid_.v().degree(); back >= 0; --back) {
        const std::size_t column = modulo(static_cast<std::ptrdiff_t>(letter) - back, grid_.v().size());
        const double* const point = grid_.points().data() + (row * grid_.v().size() + column) * dimension;
        for (std::size_t c = 0; c < dimension; ++c)
            points.coordinates.push_back({times_power_of_two(point[c], -exponent_), 0});
    }
    return points;
}

} // namespace internode
