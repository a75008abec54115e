// SPDX-License-Identifier: MIT

#include "bench/rows.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace internode::bench {
namespace {

double difference(std::span<const double> a, std::span<const double> b) {
    if (a.size() != b.size()) return std::numeric_limits<double>::infinity();
    double largest = 0;
    double most = 0;
    for (std::size_t i = 0; i < a.size(); ++i) {
        largest = std::max(largest, std::fabs(a[i]));
        const double apart = std::fabs(a[i] - b[i]);
        if (!(apart <= most)) most = apart; // and not-a-number stays
    }
    return most / largest;
}

} // namespace

double disagreement(const std::vector<Contestant>& contestants) {
    std::span<const double> first;
    double most = 0;
    for (const Contestant& contestant : contestants) {
        if (!contestant.points) continue;
        const std::span<const double> points = contestant.points();
        if (first.empty()) first = points;
        const double apart = difference(first, points);
        if (!(apart <= most)) most = apart;
    }
    return most;
}

} // namespace internode::bench
