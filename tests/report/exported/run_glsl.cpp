// SPDX-License-Identifier: MIT
//
// Runs jobs through exported GLSL on this machine: the few words of GLSL that the snippet uses, as C++. exported.h
// includes the snippets after DECLARE(name) each and defines EXPORTS(RUN) as RUN(name) for each, in order.

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <vector>

#define INTERNODE_FUNCTION_ONLY
#define precise
using uint = unsigned int;
#ifdef INTERNODE_DOUBLE
using real = double;
#else
using real = float;
#endif

#define DECLARE(NAME)                                                                                                  \
    static const real* NAME##_points;                                                                                  \
    static const uint* NAME##_states;                                                                                  \
    static const uint* NAME##_places;                                                                                  \
    static real* NAME##_new_points;                                                                                    \
    static uint* NAME##_new_states;                                                                                    \
    static uint NAME##_cells;                                                                                          \
    static uint NAME##_dimension;

#include "exported.h"

struct Job {
    std::uint32_t which, closed, letters, cells, dimension, steps;
};

template<typename T>
std::vector<T> read_array(std::FILE* in, std::size_t count) {
    std::vector<T> array(count);
    if (std::fread(array.data(), sizeof(T), count, in) != count) std::exit(2);
    return array;
}

template<typename T>
void write_array(std::FILE* out, const std::vector<T>& array) {
    if (std::fwrite(array.data(), sizeof(T), array.size(), out) != array.size()) std::exit(3);
}

void write_step(std::FILE* out, const std::vector<uint>& states, const std::vector<real>& points) {
    write_array(out, std::vector<std::uint32_t>{static_cast<std::uint32_t>(states.size())});
    write_array(out, states);
    write_array(out, std::vector<double>(points.begin(), points.end()));
}

#define RUN(NAME)                                                                                                      \
    static void run_##NAME(std::FILE* in, std::FILE* out, const Job& job) {                                            \
        (void)read_array<uint>(in, job.letters);                                                                       \
        std::vector<uint> states = read_array<uint>(in, job.cells);                                                    \
        const std::vector<double> given = read_array<double>(in, std::size_t{job.cells} * job.dimension);              \
        std::vector<real> points(given.begin(), given.end());                                                          \
        write_step(out, states, points);                                                                               \
        for (uint step = 0; step < job.steps; ++step) {                                                                \
            std::vector<uint> places;                                                                                  \
            uint count = 0;                                                                                            \
            for (const uint state : states) {                                                                          \
                places.push_back(count);                                                                               \
                count += NAME##_first[state + 1] - NAME##_first[state];                                                \
            }                                                                                                          \
            std::vector<real> new_points(std::size_t{count} * job.dimension);                                          \
            std::vector<uint> new_states(count);                                                                       \
            NAME##_points = points.data();                                                                             \
            NAME##_states = states.data();                                                                             \
            NAME##_places = places.data();                                                                             \
            NAME##_new_points = new_points.data();                                                                     \
            NAME##_new_states = new_states.data();                                                                     \
            NAME##_cells = static_cast<uint>(states.size());                                                           \
            NAME##_dimension = job.dimension;                                                                          \
            for (uint cell = 0; cell < NAME##_cells; ++cell) NAME##_step(NAME##_cells - 1 - cell);                     \
            points = new_points;                                                                                       \
            states = new_states;                                                                                       \
            write_step(out, states, points);                                                                           \
        }                                                                                                              \
    }
EXPORTS(RUN)

#define ENTRY(NAME) run_##NAME,
static void (*const runs[])(std::FILE*, std::FILE*, const Job&) = {EXPORTS(ENTRY)};

int main(int argc, char** argv) {
    if (argc != 3) return 1;
    std::FILE* in = std::fopen(argv[1], "rb");
    std::FILE* out = std::fopen(argv[2], "wb");
    if (in == nullptr || out == nullptr) return 1;
    Job job;
    while (std::fread(&job, sizeof job, 1, in) == 1) runs[job.which](in, out, job);
    std::fclose(in);
    return std::fclose(out) == 0 ? 0 : 1;
}
