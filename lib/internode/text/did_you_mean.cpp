// SPDX-License-Identifier: MIT
//
// The distance of two words is that of optimal string alignment. A row of the table of all prefixes is made at a time,
// given up as soon as every entry of the row is above the limit. The limit falls with each nearer candidate.

#include "internode/text/did_you_mean.h"

#include <algorithm>
#include <numeric>

namespace internode {

namespace {

char lower(char letter) {
    return letter >= 'A' && letter <= 'Z' ? static_cast<char>(letter - 'A' + 'a') : letter;
}

bool same_but_for_case(std::string_view a, std::string_view b) {
    return std::ranges::equal(a, b, [](char x, char y) { return lower(x) == lower(y); });
}

/// The optimal string alignment distance, or limit + 1 as soon as it must exceed the limit.
std::size_t edit_distance(std::string_view a, std::string_view b, std::size_t limit) {
    const std::size_t difference = a.size() > b.size() ? a.size() - b.size() : b.size() - a.size();
    if (difference > limit) return limit + 1;
    std::vector<std::size_t> before(b.size() + 1);
    std::vector<std::size_t> last(b.size() + 1);
    std::vector<std::size_t> row(b.size() + 1);
    std::iota(last.begin(), last.end(), std::size_t{0});
    for (std::size_t i = 1; i <= a.size(); ++i) {
        row[0] = i;
        for (std::size_t j = 1; j <= b.size(); ++j) {
            row[j] = std::min({last[j] + 1, row[j - 1] + 1, last[j - 1] + (a[i - 1] == b[j - 1] ? 0u : 1u)});
            const bool swapped = i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1];
            if (swapped) row[j] = std::min(row[j], before[j - 2] + 1);
        }
        if (std::ranges::min(row) > limit) return limit + 1;
        before.swap(last);
        last.swap(row);
    }
    return last.back();
}

} // namespace

std::string did_you_mean(std::string_view word, const std::vector<std::string>& candidates) {
    const auto alike = [word](const std::string& candidate) { return same_but_for_case(word, candidate); };
    if (const auto found = std::ranges::find_if(candidates, alike); found != candidates.end()) return *found;
    std::size_t limit = std::max<std::size_t>(1, word.size() / 3);
    std::string nearest;
    for (const std::string& candidate : candidates) {
        const std::size_t distance = edit_distance(word, candidate, limit);
        if (distance > limit || distance >= std::max(word.size(), candidate.size())) continue;
        nearest = candidate;
        if (distance == 0) break;
        limit = distance - 1;
        if (limit == 0) break;
    }
    return nearest;
}

} // namespace internode
