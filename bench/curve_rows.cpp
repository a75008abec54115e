// SPDX-License-Identifier: MIT
//
// Cubic Fibonacci curves against the peers.

#include "bench/ours.h"
#include "bench/peers/a54.h"
#include "bench/peers/sparse.h"

#if defined(INTERNODE_HAS_SISL)
#include "bench/peers/sisl.h"
#endif

namespace internode::bench {
namespace {

/// What the peers are given beforehand.
struct PeerCase {
    CurveCase curve;
    DoubleKnots knots;
    std::size_t count; ///< of refined points
};

std::shared_ptr<const PeerCase> peer_case(const CurveCase& curve) {
    return std::make_shared<const PeerCase>(
        PeerCase{curve, double_knots(curve.knots, curve.steps), refined_points(curve)});
}

Contestant contestant(const std::string& name, std::size_t count, std::function<double()> seconds,
                      std::function<std::span<const double>()> points) {
    return {name, static_cast<double>(count), count, std::move(seconds), std::move(points)};
}

Contestant a54_reused(const std::shared_ptr<const PeerCase>& given) {
    const auto points = touched_buffer<double>(given->count * dimension);
    const auto knots = touched_buffer<double>(given->knots.fine.size());
    const auto work = [=] {
        refine_a54(given->knots.coarse, given->curve.points, given->knots.inserted,
                   {knots->values(), points->values()});
    };
    return contestant(
        "a54", given->count, [work] { return seconds_of(work); },
        [points] { return std::span<const double>(points->values()); });
}

/// Fresh memory as `new` gives it, for peers.
struct Fresh {
    std::unique_ptr<double[]> points;
    std::unique_ptr<double[]> knots;
};

Contestant a54_fresh(const std::shared_ptr<const PeerCase>& given) {
    const auto out = std::make_shared<Fresh>();
    const auto work = [=] {
        const std::size_t knots = given->knots.fine.size();
        out->points = std::make_unique_for_overwrite<double[]>(given->count * dimension);
        out->knots = std::make_unique_for_overwrite<double[]>(knots);
        refine_a54(given->knots.coarse, given->curve.points, given->knots.inserted,
                   {{out->knots.get(), knots}, {out->points.get(), given->count * dimension}});
    };
    const auto seconds = [=] {
        *out = {};
        return seconds_of(work);
    };
    return contestant("a54", given->count, seconds,
                      [=] { return std::span<const double>(out->points.get(), given->count * dimension); });
}

std::shared_ptr<const SparseRefinement> sparse_matrix(const PeerCase& given) {
    return std::make_shared<const SparseRefinement>(cubic_rows(given.knots.coarse, given.knots.fine),
                                                    given.curve.knots.size());
}

Contestant sparse_reused(const std::shared_ptr<const PeerCase>& given) {
    const auto matrix = sparse_matrix(*given);
    const auto out = touched_buffer<double>(given->count * dimension);
    const auto work = [=] { matrix->apply(given->curve.points, out->values()); };
    return contestant(
        "eigen-sparse", given->count, [work] { return seconds_of(work); },
        [out] { return std::span<const double>(out->values()); });
}

Contestant sparse_fresh(const std::shared_ptr<const PeerCase>& given) {
    const auto matrix = sparse_matrix(*given);
    const auto out = std::make_shared<Fresh>();
    const std::size_t size = given->count * dimension;
    const auto work = [=] {
        out->points = std::make_unique_for_overwrite<double[]>(size);
        matrix->apply(given->curve.points, {out->points.get(), size});
    };
    const auto seconds = [=] {
        *out = {};
        return seconds_of(work);
    };
    return contestant("eigen-sparse", given->count, seconds,
                      [=] { return std::span<const double>(out->points.get(), size); });
}

void add_sisl([[maybe_unused]] std::vector<Contestant>& contestants,
              [[maybe_unused]] const std::shared_ptr<const PeerCase>& given) {
#if defined(INTERNODE_HAS_SISL)
    const auto sisl = std::make_shared<SislRefinement>(given->knots.coarse, given->curve.points, given->knots.inserted);
    const auto points = std::make_shared<std::span<const double>>();
    const auto seconds = [=] {
        sisl->release();
        return seconds_of([&] { *points = sisl->refine(); });
    };
    contestants.push_back(contestant("sisl-s1018", given->count, seconds, [=] { return *points; }));
#endif
}

/// Every byte of fresh memory in large pages written once, and nothing computed.
Contestant first_touch(std::size_t count) {
    const auto out = std::make_shared<CoordinateBuffer<double>>();
    const auto work = [=] {
        *out = CoordinateBuffer<double>(count * dimension);
        std::ranges::fill(out->values(), 1.0);
    };
    const auto seconds = [=] {
        *out = {};
        return seconds_of(work);
    };
    return contestant("first-touch", count, seconds, nullptr);
}

std::vector<Contestant> against_copy(Scale scale) {
    const CurveCase curve = fibonacci_case(1600, scaled(20, scale));
    const std::size_t count = refined_points(curve);
    std::vector<Contestant> contestants{ours_reused("internode", curve), memcpy_of(count)};
    add_fills(contestants, count);
    return contestants;
}

std::vector<Contestant> against_first_touch(Scale scale) {
    const CurveCase curve = fibonacci_case(1600, scaled(20, scale));
    return {ours_fresh("internode", curve), first_touch(refined_points(curve))};
}

std::vector<Contestant> against_peers(Scale scale) {
    const CurveCase curve = fibonacci_case(1190, scaled(14, scale));
    const auto given = peer_case(curve);
    std::vector<Contestant> contestants{ours_reused("internode", curve), ours_planned("internode-planned", curve),
                                        a54_reused(given), sparse_reused(given)};
    add_sisl(contestants, given);
    contestants.push_back(memcpy_of(given->count));
    return contestants;
}

std::vector<Contestant> against_fresh_peers(Scale scale) {
    const CurveCase curve = fibonacci_case(1070, scaled(19, scale));
    const auto given = peer_case(curve);
    std::vector<Contestant> contestants{ours_fresh("internode", curve), a54_fresh(given), sparse_fresh(given),
                                        first_touch(given->count)};
    add_sisl(contestants, given);
    return contestants;
}

} // namespace

std::vector<Row> curve_rows() {
    return {{"curve-24M-reused", against_copy},
            {"curve-24M-fresh", against_first_touch},
            {"curve-1M-reused", against_peers},
            {"curve-10M-fresh", against_fresh_peers}};
}

} // namespace internode::bench
