// SPDX-License-Identifier: MIT

#include "internode/report/code/automaton_code.h"
#include "internode/report/code/cells_code.h"
#include "internode/report/code/code_tables.h"

namespace internode {

namespace {

constexpr std::string_view glsl_usage = R"( *
 * Paste it below `#version 430`: one step of subdivision as a compute shader, one invocation a cell. Define
 * INTERNODE_DOUBLE for double, INTERNODE_FUNCTION_ONLY to declare buffers and main() yourself.
 *
 * A cell is a control point; its first parent is cell + lead - degree. Before a step, @_places[cell] is
 * the number of children of all cells before it: the sum of @_first[state + 1] - @_first[state].
 */
#ifdef INTERNODE_DOUBLE
#define @_real double
#else
#define @_real float
#endif

)";

constexpr std::string_view code = R"(
#ifndef INTERNODE_FUNCTION_ONLY
layout(std430, binding = 0) readonly buffer @_Points { @_real @_points[]; };
layout(std430, binding = 1) readonly buffer @_States { uint @_states[]; };
layout(std430, binding = 2) readonly buffer @_Places { uint @_places[]; };
layout(std430, binding = 3) writeonly buffer @_NewPoints { @_real @_new_points[]; };
layout(std430, binding = 4) writeonly buffer @_NewStates { uint @_new_states[]; };
layout(std430, binding = 5) readonly buffer @_Sizes { uint @_cells; uint @_dimension; };
#endif

/* The children of one cell: closed and open polygons alike. */
void @_step(uint cell)
{
    uint state = @_states[cell];
    /* The first of degree + 1 parents: cell + lead - degree, round a closed polygon. */
    uint first = (cell + @_lead[state] + @_degree * (@_cells - 1u)) % @_cells;
    uint place = @_places[cell];
    for (uint child = @_first[state]; child < @_first[state + 1u]; ++child, ++place) {
        uint row = @_row[child] * (@_degree + 1u);
        for (uint c = 0u; c < @_dimension; ++c) {
            uint parent = first;
            precise @_real sum = @_weights[row] * @_points[parent * @_dimension + c];
            for (uint k = 1u; k <= @_degree; ++k) {
                parent = parent + 1u == @_cells ? 0u : parent + 1u;
                sum += @_weights[row + k] * @_points[parent * @_dimension + c];
            }
            @_new_points[place * @_dimension + c] = sum;
        }
        @_new_states[place] = @_child[child];
    }
}

#ifndef INTERNODE_FUNCTION_ONLY
layout(local_size_x = 64) in;

void main()
{
    if (gl_GlobalInvocationID.x < @_cells) @_step(gl_GlobalInvocationID.x);
}
#endif
)";

std::string table(const std::string& name, const std::vector<std::uint32_t>& values) {
    constexpr std::size_t per_line = 20;
    return "const uint " + name + "[" + std::to_string(values.size()) + "] = " + initializer(values, per_line, "u") +
           ";\n";
}

std::string weights(const CodeTables& tables, const CellAutomaton& automaton) {
    const std::size_t width = tables.degree + 1;
    const std::string declaration =
        " " + tables.name + "_weights[" + std::to_string(automaton.row_count() * width) + "] = ";
    return "#ifdef INTERNODE_DOUBLE\nconst double" + declaration + weight_initializer(automaton, width, false, "lf") +
           ";\n#else\nconst float" + declaration + weight_initializer(automaton, width, false, "") + ";\n#endif\n";
}

std::string shader(const CodeTables& tables, const CellAutomaton& automaton, std::string_view lead_comment) {
    const std::string& name = tables.name;
    return with_name(glsl_usage, name) + "const uint " + name + "_degree = " + std::to_string(tables.degree) +
           "u;\n\n/* Of each state: " + std::string(lead_comment) +
           ", and its first child; of each child: its state and row. */\n" + table(name + "_lead", tables.lead) +
           table(name + "_first", tables.first) + table(name + "_child", tables.child) +
           table(name + "_row", tables.row) + "\n" + weights(tables, automaton) + with_name(code, name);
}

} // namespace

std::string automaton_glsl(const AutomatonExport& automaton, const Generator& generator) {
    return opening_comment(automaton, generator) +
           shader(code_tables(automaton), automaton.automaton, "how many cells it lies left of its interval");
}

std::string cells_glsl(const CellExport& cells) {
    return opening_comment(cells) + shader(code_tables(cells), cells.compiled.automaton(), "its lead");
}

} // namespace internode
