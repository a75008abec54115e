// SPDX-License-Identifier: MIT

#include "internode/report/code/automaton_code.h"
#include "internode/report/code/cells_code.h"
#include "internode/report/code/code_tables.h"

#include <algorithm>
#include <cassert>

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

constexpr std::string_view point_usage = R"( *
 * Compile with -ffp-contract=off: cc -O3 -ffp-contract=off, with any -march; fused multiply-adds would change the last
 * bits. C99 and C++11.
 *
 * A cell is a point; its state says how it is replaced. @_start has the states of the polygon to begin with:
 *
 *     size_t count = @_count(states, cells);
 *     @_step(points, states, cells, dimension, new_points, new_states);
 */
)";

constexpr std::string_view cells_function = R"(
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
)";

constexpr std::string_view step_functions = R"(
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
    assert(letters > 0 && tables.windows.size() == tables.lead.size() * letters);
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

std::string automaton_tables(const CodeTables& tables, const CellAutomaton& automaton) {
    assert(!tables.lead.empty() && tables.first.size() == tables.lead.size() + 1);
    const std::string& name = tables.name;
    const std::size_t width = tables.degree + 1;
    const std::uint32_t largest = *std::ranges::max_element(tables.lead);
    return table(unsigned_type(largest), name + "_lead", tables.lead) +
           "\n/* The first child of each state; the state and the row of weights of each child. */\n" +
           table("uint32_t", name + "_first", tables.first) + table(name + "_state", name + "_child", tables.child) +
           table(unsigned_type(automaton.row_count()), name + "_row", tables.row) + "\nstatic const double " + name +
           "_weights[" + std::to_string(automaton.row_count()) + "][" + std::to_string(width) +
           "] = " + weight_initializer(automaton, width, true, "") + ";\n";
}

std::string enumeration(const CodeTables& tables, const CellAutomaton& automaton) {
    return "enum { " + tables.name + "_degree = " + std::to_string(tables.degree) + ", " + tables.name +
           "_states = " + std::to_string(automaton.state_count()) + " };\n";
}

std::string c_tables(const CodeTables& tables, const AutomatonExport& exported) {
    const StencilAutomaton& automaton = exported.automaton;
    const std::string& name = tables.name;
    return "typedef " + unsigned_type(automaton.state_count()) + " " + name + "_state;\ntypedef " +
           unsigned_type(exported.system.alphabet().size()) + " " + name + "_symbol;\n\n" +
           enumeration(tables, automaton) +
           "\n/* Of each state: the intervals around its own, and how many cells it lies left of that one. */\n" +
           windows_table(tables, 2 * tables.degree - 1) + automaton_tables(tables, automaton);
}

std::string c_tables(const CodeTables& tables, const CellExport& exported) {
    const CellAutomaton& automaton = exported.compiled.automaton();
    return "typedef " + unsigned_type(automaton.state_count()) + " " + tables.name + "_state;\n\n" +
           enumeration(tables, automaton) + "\n/* The states of the cells of the polygon that the command names. */\n" +
           table(tables.name + "_state", tables.name + "_start", exported.compiled.cells()) +
           "\n/* Of each state: its first parent is cell + lead - degree. */\n" + automaton_tables(tables, automaton);
}

std::string guarded(const std::string& name, const std::string& body) {
    const std::string guard = "INTERNODE_" + name + "_H";
    return "#ifndef " + guard + "\n#define " + guard +
           "\n\n#include <stddef.h>\n#include <stdint.h>\n\n#ifdef __FAST_MATH__\n"
           "#error \"-ffast-math reorders sums; compile without it\"\n#endif\n\n" +
           body + "\n#endif\n";
}

} // namespace

std::string automaton_c(const AutomatonExport& automaton, const Generator& generator) {
    const CodeTables tables = code_tables(automaton);
    return opening_comment(automaton, generator) + with_name(usage, tables.name) +
           guarded(tables.name, c_tables(tables, automaton) + with_name(cells_function, tables.name) +
                                    with_name(step_functions, tables.name));
}

std::string cells_c(const CellExport& cells) {
    const CodeTables tables = code_tables(cells);
    return opening_comment(cells) + with_name(point_usage, tables.name) +
           guarded(tables.name, c_tables(tables, cells) + with_name(step_functions, tables.name));
}

} // namespace internode
