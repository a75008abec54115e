// SPDX-License-Identifier: MIT

#include "internode/report/automaton_code.h"
#include "internode/report/code_tables.h"

#include <algorithm>

namespace internode {

namespace {

constexpr std::string_view usage = R"( *
 * Compile with -ffp-contract=off: cc -O3 -ffp-contract=off, with any -march. Then every point has the bytes that
 * internode computes; fused multiply-adds would change the last bits. C99 and C++11.
 *
 * A cell is a control point with the leftmost interval of its support; its state says how it splits. From a word:
 *
 *     size_t cells = @_cells(word, letters, closed, states);
 *     size_t count = @_count(states, cells);
 *     @_step(points, states, cells, dimension, new_points, new_states);
 */
)";

constexpr std::string_view functions = R"(
/* The states of the cells of a word of `letters` symbols: a cell a letter when closed, `degree` fewer when open. How
 * many they are; 0 when no polygon has this word, or the tables do not know one of its windows. */
static inline size_t @_cells(const @_symbol *word, size_t letters, int closed, @_state *states)
{
    const size_t d = @_degree;
    const size_t cells = closed ? letters : letters - d;
    if (letters < (closed ? 1 : 2 * d + 1) || (!closed && word[cells - 1] == 0)) return 0;
    for (size_t cell = 0; cell < cells; ++cell) {
        size_t lead = !closed && cell < d ? d - cell : 0;
        size_t state = 0;
        while (lead <= d && word[(cell + lead) % letters] == 0) ++lead;
        for (; state < @_states; ++state) {
            size_t i = @_lead[state] == lead ? 0 : 2 * d;
            while (i < 2 * d - 1 && @_windows[state][i] == word[(cell + lead + i + 1 + d * (letters - 1)) % letters]) ++i;
            if (i == 2 * d - 1) break;
        }
        if (state == @_states) return 0;
        states[cell] = (@_state)state;
    }
    return cells;
}

/* How many points and states a step makes. */
static inline size_t @_count(const @_state *states, size_t cells)
{
    size_t count = 0;
    for (size_t cell = 0; cell < cells; ++cell) count += @_first[states[cell] + 1u] - @_first[states[cell]];
    return count;
}

/* One step from `cells` >= 1 points of `dimension` doubles, closed and open alike: the new points and states, in order.
 * They must not overlap the old ones. How many they are. */
static inline size_t @_step(const double *points, const @_state *states, size_t cells, size_t dimension,
                            double *new_points, @_state *new_states)
{
    size_t count = 0;
    for (size_t cell = 0; cell < cells; ++cell) {
        const uint32_t state = states[cell];
        /* The first of degree + 1 parents: cell + lead - degree, round a closed polygon. */
        const size_t first = (cell + @_lead[state] + @_degree * (cells - 1)) % cells;
        for (uint32_t child = @_first[state]; child < @_first[state + 1]; ++child, ++count) {
            const double *weights = @_weights[@_row[child]];
            for (size_t c = 0; c < dimension; ++c) {
                size_t parent = first;
                double sum = weights[0] * points[parent * dimension + c];
                for (size_t k = 1; k <= @_degree; ++k) {
                    parent = parent + 1 == cells ? 0 : parent + 1;
                    sum += weights[k] * points[parent * dimension + c];
                }
                new_points[count * dimension + c] = sum;
            }
            new_states[count] = @_child[child];
        }
    }
    return count;
}
)";

std::string unsigned_type(std::size_t largest) {
    return largest < 256 ? "uint8_t" : largest < 65536 ? "uint16_t" : "uint32_t";
}

std::string table(const std::string& type, const std::string& name, const std::vector<std::uint32_t>& values) {
    constexpr std::size_t per_line = 20;
    return "static const " + type + " " + name + "[" + std::to_string(values.size()) +
           "] = " + initializer(values, per_line, "") + ";\n";
}

/// A row of the windows a line.
std::string windows_table(const CodeTables& tables, std::size_t letters) {
    std::string text = "static const " + tables.name + "_symbol " + tables.name + "_windows[" +
                       std::to_string(tables.lead.size()) + "][" + std::to_string(letters) + "] = {";
    for (std::size_t i = 0; i < tables.windows.size(); ++i) {
        const std::size_t column = i % letters;
        if (column == 0) text += i == 0 ? "\n    {" : "},\n    {";
        if (column > 0) text += ", ";
        text += std::to_string(tables.windows[i]);
    }
    return text + "}\n};\n";
}

std::string c_tables(const CodeTables& tables, const AutomatonExport& exported) {
    const StencilAutomaton& automaton = exported.automaton;
    const std::string& name = tables.name;
    const std::size_t letters = 2 * static_cast<std::size_t>(automaton.degree()) - 1;
    return "typedef " + unsigned_type(automaton.state_count()) + " " + name + "_state;\ntypedef " +
           unsigned_type(exported.system.alphabet().size()) + " " + name + "_symbol;\n\nenum { " + name +
           "_degree = " + std::to_string(automaton.degree()) + ", " + name +
           "_states = " + std::to_string(automaton.state_count()) +
           " };\n\n/* Of each state: the intervals around its own, and how many cells it lies left of that one. */\n" +
           windows_table(tables, letters) + table("uint8_t", name + "_lead", tables.lead) +
           "\n/* The first child of each state; the state and the row of weights of each child. */\n" +
           table("uint32_t", name + "_first", tables.first) + table(name + "_state", name + "_child", tables.child) +
           table(unsigned_type(automaton.row_count()), name + "_row", tables.row) + "\nstatic const double " + name +
           "_weights[" + std::to_string(automaton.row_count()) + "][" + std::to_string(automaton.width()) +
           "] = " + weight_initializer(automaton, true, "") + ";\n";
}

} // namespace

std::string automaton_c(const AutomatonExport& automaton, const Generator& generator) {
    const CodeTables tables = code_tables(automaton);
    const std::string guard = "INTERNODE_" + tables.name + "_H";
    return opening_comment(automaton, generator) + with_name(usage, tables.name) + "#ifndef " + guard + "\n#define " +
           guard +
           "\n\n#include <stddef.h>\n#include <stdint.h>\n\n#ifdef __FAST_MATH__\n"
           "#error \"-ffast-math reorders sums; compile without it\"\n#endif\n\n" +
           c_tables(tables, automaton) + with_name(functions, tables.name) + "\n#endif\n";
}

} // namespace internode
