/* SPDX-License-Identifier: MIT
 *
 * Runs jobs through exported headers, as C and as C++: argv[1] has the jobs, argv[2] gets, for step 0 and every further
 * one, the number of points, their states and their coordinates. exported.h includes the headers and defines
 * EXPORTS(RUN) as RUN(name) for each, in order.
 */
#include <stdio.h>
#include <stdlib.h>

#include "exported.h"

typedef struct Job {
    uint32_t which, closed, letters, cells, dimension, steps;
} Job;

static void *read_array(FILE *in, size_t count, size_t size)
{
    void *array = calloc(count + 1, size);
    if (array == NULL || fread(array, size, count, in) != count) exit(2);
    return array;
}

static void write_array(FILE *out, const void *array, size_t count, size_t size)
{
    if (fwrite(array, size, count, out) != count) exit(3);
}

#define RUN(NAME)                                                                                                      \
    static void run_##NAME(FILE *in, FILE *out, Job job)                                                               \
    {                                                                                                                  \
        uint32_t *letters = (uint32_t *)read_array(in, job.letters, sizeof *letters);                                  \
        uint32_t *expected = (uint32_t *)read_array(in, job.cells, sizeof *expected);                                  \
        double *points = (double *)read_array(in, (size_t)job.cells * job.dimension, sizeof *points);                  \
        NAME##_symbol *word = (NAME##_symbol *)calloc(job.letters + 1, sizeof *word);                                  \
        NAME##_state *states = (NAME##_state *)calloc(job.letters + 1, sizeof *states);                                \
        for (uint32_t i = 0; i < job.letters; ++i) word[i] = (NAME##_symbol)letters[i];                                \
        size_t cells = NAME##_cells(word, job.letters, (int)job.closed, states);                                       \
        if (cells != job.cells) exit(4);                                                                               \
        for (uint32_t step = 0;; ++step) {                                                                             \
            const uint32_t count = (uint32_t)cells;                                                                    \
            write_array(out, &count, 1, sizeof count);                                                                 \
            for (size_t i = 0; i < cells; ++i) {                                                                       \
                const uint32_t state = states[i];                                                                      \
                write_array(out, &state, 1, sizeof state);                                                             \
            }                                                                                                          \
            write_array(out, points, cells * job.dimension, sizeof *points);                                           \
            if (step == job.steps) break;                                                                              \
            const size_t more = NAME##_count(states, cells);                                                           \
            double *new_points = (double *)malloc((more + 1) * job.dimension * sizeof *points);                        \
            NAME##_state *new_states = (NAME##_state *)malloc((more + 1) * sizeof *states);                            \
            if (NAME##_step(points, states, cells, job.dimension, new_points, new_states) != more) exit(5);            \
            free(points);                                                                                              \
            free(states);                                                                                              \
            points = new_points;                                                                                       \
            states = new_states;                                                                                       \
            cells = more;                                                                                              \
        }                                                                                                              \
        free(points);                                                                                                  \
        free(states);                                                                                                  \
        free(word);                                                                                                    \
        free(expected);                                                                                                \
        free(letters);                                                                                                 \
    }
EXPORTS(RUN)

#define ENTRY(NAME) run_##NAME,
static void (*const runs[])(FILE *, FILE *, Job) = {EXPORTS(ENTRY)};

int main(int argc, char **argv)
{
    if (argc != 3) return 1;
    FILE *in = fopen(argv[1], "rb");
    FILE *out = fopen(argv[2], "wb");
    if (in == NULL || out == NULL) return 1;
    Job job;
    while (fread(&job, sizeof job, 1, in) == 1) runs[job.which](in, out, job);
    fclose(in);
    return fclose(out) == 0 ? 0 : 1;
}
