// SPDX-License-Identifier: MIT
//
// The machine by its own figures; the amount is bytes.

#include "bench/buffers.h"

namespace internode::bench {
namespace {

Contestant filled(const std::string& name, std::size_t bytes, const std::function<double*(std::size_t)>& allocate,
                  const std::function<void()>& release) {
    const std::size_t size = bytes / sizeof(double);
    const auto seconds = [=] {
        const double time = seconds_of([&] { std::fill_n(allocate(size), size, 1.0); });
        release();
        return time;
    };
    return {name, static_cast<double>(bytes), bytes / (dimension * sizeof(double)), seconds};
}

std::vector<Contestant> machine(Scale scale) {
    const std::size_t bytes = (scale == Scale::Full ? std::size_t{512} : 8) << 20;
    const auto large = std::make_shared<CoordinateBuffer<double>>();
    const auto small = std::make_shared<std::unique_ptr<double[]>>();
    const auto touched = touched_buffer<double>(bytes / sizeof(double));
    Contestant copy = memcpy_of(bytes / (dimension * sizeof(double)));
    copy.amount = static_cast<double>(bytes);
    return {std::move(copy),
            filled(
                "fill", bytes, [touched](std::size_t) { return touched->data(); }, [] {}),
            filled(
                "first-touch-large-pages", bytes,
                [large](std::size_t size) {
                    *large = CoordinateBuffer<double>(size);
                    return large->data();
                },
                [large] { *large = {}; }),
            filled(
                "first-touch-plain", bytes,
                [small](std::size_t size) {
                    *small = std::make_unique_for_overwrite<double[]>(size);
                    return small->get();
                },
                [small] { small->reset(); })};
}

} // namespace

std::vector<Row> memory_rows() {
    return {{"machine", machine}};
}

} // namespace internode::bench
