// SPDX-License-Identifier: MIT

#include "internode/report/json/convergence_json.h"

#include "internode/report/json/json_parts.h"

namespace internode {

namespace {

void write_steps(JsonWriter& json, const Convergence& convergence) {
    json.key("steps").begin_array();
    for (const ConvergenceStep& step : convergence.steps) {
        json.begin_object(one_line);
        json.key("step").integer(static_cast<std::size_t>(step.step));
        json.key("points").integer(step.points);
        json.key("largest_interval").number(step.largest_interval);
        json.key("error").number(step.error);
        json.key("ratio");
        if (step.ratio)
            json.number(*step.ratio);
        else
            json.null();
        json.key("envelope").number(step.envelope).end_object();
    }
    json.end_array();
}

void write_depth(JsonWriter& json, const std::optional<ToleranceDepth>& depth) {
    json.key("depth_for_tolerance");
    if (!depth) {
        json.null();
        return;
    }
    json.begin_object(one_line).key("tolerance").number(depth->tolerance).key("steps");
    if (depth->steps)
        json.integer(static_cast<std::size_t>(*depth->steps));
    else
        json.null();
    json.key("measured").boolean(depth->measured).end_object();
}

} // namespace

std::string convergence_json(const Convergence& convergence, const IntervalSystem& system, const Generator& generator) {
    StringSink sink;
    JsonWriter json(sink);
    json.begin_object();
    write_heading(json, "internode-convergence", generator);
    json.key("degree").integer(static_cast<std::size_t>(convergence.degree));
    write_system(json, system);
    json.key("period").integer(system.period());
    write_steps(json, convergence);
    json.key("expected_ratio");
    write_number(json, convergence.expected_ratio, system.field());
    json.key("constant");
    write_number(json, convergence.constant.value, system.field());
    json.key("constant_word");
    write_word(json, convergence.constant.word, system.alphabet());
    write_depth(json, convergence.depth);
    json.key("bisection").begin_array();
    for (const BisectionStep& step : convergence.bisection)
        json.begin_object(one_line).key("points").integer(step.points).key("error").number(step.error).end_object();
    json.end_array();
    json.end_object().finish();
    return sink.text();
}

} // namespace internode
