// SPDX-License-Identifier: MIT
//
// Text of points, written and read on one thread and on two, against a plain loop; by the clock on the wall.

#include "bench/ours.h"

#include "internode/io/csv.h"
#include "internode/io/json/curve_json.h"
#include "internode/io/obj/obj.h"
#include "internode/io/polygon.h"

#include <fmt/format.h>

#include <stdexcept>

namespace internode::bench {
namespace {

/// Takes bytes as fast as a sink can.
class CountingSink final : public Sink {
public:
    bool write(std::string_view bytes) override {
        count_ += bytes.size();
        return true;
    }
    [[nodiscard]] std::size_t count() const { return count_; }

private:
    std::size_t count_ = 0;
};

using Points = std::shared_ptr<const CoordinateBuffer<double>>;
using Write = std::function<void(Sink& sink, const PointsView& points, int threads)>;

/// A million refined points.
Points refined(Scale scale) {
    const CurveCase curve = fibonacci_case(1190, scaled(14, scale));
    auto points = touched_buffer<double>(refined_points(curve) * dimension);
    refine_into<double>(curve, curve.points, points->values(), {});
    return points;
}

Contestant writer(const std::string& name, const Points& points, int threads, const Write& write) {
    const std::size_t count = points->size() / dimension;
    const auto work = [=] {
        CountingSink sink;
        write(sink, {dimension, points->values()}, threads);
        if (sink.count() < count) throw std::logic_error("a writer of text wrote too little");
    };
    return {name, static_cast<double>(count), count, [work] { return wall_seconds_of(work); }};
}

std::vector<Contestant> on_one_and_two(Scale scale, const Write& write) {
    const Points points = refined(scale);
    return {writer("one-thread", points, 1, write), writer("two-threads", points, 2, write)};
}

/// What one writes without thinking: fmt's shortest round-trip numbers, a buffer that is emptied now and then.
void plain_loop(Sink& sink, const PointsView& points, int /*threads*/) {
    std::string text;
    for (std::size_t i = 0; i < points.size(); ++i) {
        const std::span<const double> point = points[i];
        fmt::format_to(std::back_inserter(text), "{},{},{}\n", point[0], point[1], point[2]);
        if (text.size() < (std::size_t{1} << 16)) continue;
        sink.write(text);
        text.clear();
    }
    sink.write(text);
}

void as_csv(Sink& sink, const PointsView& points, int threads) {
    CsvOptions options;
    options.threads = threads;
    write_csv(sink, points, options);
}

std::vector<Contestant> csv(Scale scale) {
    std::vector<Contestant> contestants = on_one_and_two(scale, as_csv);
    contestants.push_back(writer("plain-loop", refined(scale), 1, plain_loop));
    return contestants;
}

std::vector<Contestant> json(Scale scale) {
    return on_one_and_two(scale, [](Sink& sink, const PointsView& points, int threads) {
        CurveDocument document;
        document.points = points;
        document.threads = threads;
        write_curve_json(sink, document);
    });
}

std::vector<Contestant> obj(Scale scale) {
    return on_one_and_two(scale, [](Sink& sink, const PointsView& points, int threads) {
        write_obj(sink, points, Ends::Open, {}, 0, threads);
    });
}

std::vector<Contestant> read_csv(Scale scale) {
    const Points points = refined(scale);
    StringSink sink;
    as_csv(sink, {dimension, points->values()}, 1);
    const auto text = std::make_shared<const std::string>(sink.text());
    const auto reader = [&](const std::string& name, int threads) {
        const std::size_t count = points->size() / dimension;
        const auto read = std::make_shared<ParsedPolygons>();
        const auto seconds = [=] {
            *read = {};
            return wall_seconds_of([&] { *read = read_polygons_csv(*text, "points.csv", threads); });
        };
        return Contestant{name, static_cast<double>(count), count, seconds,
                          [read] { return std::span<const double>(read->polygons.at(0).points); }};
    };
    return {reader("one-thread", 1), reader("two-threads", 2)};
}

} // namespace

std::vector<Row> text_rows() {
    return {{"text-csv", csv}, {"text-json", json}, {"text-obj", obj}, {"text-read-csv", read_csv}};
}

} // namespace internode::bench
