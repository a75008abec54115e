// SPDX-License-Identifier: MIT

#include "internode/report/json/point_validation_json.h"

#include "internode/grammar/points/print_points.h"
#include "internode/report/json/json_parts.h"
#include "internode/report/json/mask_facts_json.h"

#include <algorithm>

namespace internode {

namespace {

/// Lines of a text by offset, in logarithmic time: a grammar may have as many expressions as it has bytes.
class LineIndex {
public:
    explicit LineIndex(std::string_view text) {
        for (std::size_t i = 0; i < text.size(); ++i)
            if (text[i] == '\n') ends_.push_back(i);
    }
    [[nodiscard]] std::size_t line(std::size_t offset) const {
        return static_cast<std::size_t>(std::ranges::lower_bound(ends_, offset) - ends_.begin()) + 1;
    }

private:
    std::vector<std::size_t> ends_;
};

std::string_view part_name(const ArgumentPlace& where) {
    switch (where.part) {
    case GrammarPart::Axiom:
        return "axiom";
    case GrammarPart::Input:
        return "input";
    case GrammarPart::Rule:
        return "rule";
    case GrammarPart::Interpretation:
        break;
    }
    return "interpretation";
}

std::string_view verdict_name(AffineVerdict verdict) {
    switch (verdict) {
    case AffineVerdict::Affine:
        return "affine";
    case AffineVerdict::AffineForTheseConstants:
        return "affine-for-these-constants";
    case AffineVerdict::MixesCoordinates:
        return "mixes-coordinates";
    case AffineVerdict::SumIsNotOne:
        return "sum-is-not-one";
    case AffineVerdict::NotDecided:
        break;
    }
    return "not-decided";
}

class PointValidationWriter {
public:
    PointValidationWriter(JsonWriter& json, const PointGrammar& grammar, const GrammarSourceText& source)
        : json_(json)
        , grammar_(grammar)
        , lines_(source.text) {}

    void grammar() {
        json_.key("grammar").begin_object();
        json_.key("name").string(grammar_.name);
        json_.key("ring").boolean(grammar_.ring);
        json_.key("rules");
        rules(grammar_.rules);
        json_.key("interpretations").begin_array();
        for (const auto& pass : grammar_.interpretations) rules(pass);
        json_.end_array().end_object();
    }

    void problems(const std::vector<PointProblem>& problems) {
        json_.key("problems").begin_array();
        for (const PointProblem& problem : problems) {
            json_.begin_object(one_line);
            place(problem.place);
            json_.key("message").string(problem.message);
            text("hint", problem.hint);
            json_.end_object();
        }
        json_.end_array();
    }

    void positions(const std::vector<AffineFinding>& findings) {
        json_.key("positions").begin_array();
        for (const AffineFinding& finding : findings) position(finding);
        json_.end_array();
    }

    void coverage(const std::optional<Coverage>& coverage) {
        json_.key("coverage");
        if (!coverage) {
            json_.null();
            return;
        }
        json_.begin_object().key("points").integer(coverage->points);
        json_.key("cycles").integer(static_cast<std::size_t>(coverage->cycles));
        json_.key("staying").begin_array();
        for (const StayingContext& context : coverage->staying) staying(context);
        json_.end_array();
        json_.key("unused_rules").begin_array(one_line);
        for (const std::uint32_t rule : coverage->unused) json_.integer(rule);
        json_.end_array();
        counts("complete", coverage->complete);
        counts("incomplete", coverage->incomplete);
        json_.key("ends_complete").boolean(coverage->ends_complete);
        json_.key("problem");
        if (coverage->problem) {
            json_.begin_object(one_line).key("points").integer(coverage->problem_points);
            place(coverage->problem->place);
            json_.key("message").string(coverage->problem->message).end_object();
        } else {
            json_.null();
        }
        json_.end_object();
    }

    void compilation(const std::optional<CompilationFacts>& facts) {
        json_.key("compilation");
        if (!facts) {
            json_.null();
            return;
        }
        json_.begin_object().key("compiles").boolean(facts->compiles);
        json_.key("states").integer(facts->states);
        json_.key("reasons").begin_array();
        for (const ExactStop& stop : facts->reasons) {
            json_.begin_object(one_line);
            place(stop.place);
            json_.key("message").string(stop.reason).end_object();
        }
        json_.end_array();
        json_.key("intervals");
        twin(facts->twin);
        json_.end_object();
    }

private:
    void rules(const std::vector<PointRule>& rules) {
        json_.begin_array();
        for (const PointRule& rule : rules) json_.string(print(rule, grammar_));
        json_.end_array();
    }

    void place(const SourcePlace& place) {
        json_.key("line");
        if (place.bytes > 0)
            json_.integer(lines_.line(place.offset));
        else
            json_.null();
    }

    void text(std::string_view key, const std::string& value) {
        json_.key(key);
        if (value.empty())
            json_.null();
        else
            json_.string(value);
    }

    void position(const AffineFinding& finding) {
        const ArgumentPlace& where = finding.where;
        const bool in_rule = where.part == GrammarPart::Rule || where.part == GrammarPart::Interpretation;
        json_.begin_object(one_line).key("part").string(part_name(where));
        json_.key("pass");
        if (where.part == GrammarPart::Interpretation)
            json_.integer(where.pass);
        else
            json_.null();
        json_.key("rule");
        if (in_rule)
            json_.integer(where.rule);
        else
            json_.null();
        json_.key("module").integer(where.module);
        json_.key("argument").integer(where.argument);
        place(finding.place);
        json_.key("expression").string(print(expression_at(grammar_, where), formals_at(grammar_, where), grammar_));
        json_.key("verdict").string(verdict_name(finding.verdict));
        text("sum", finding.sum);
        text("reason", finding.reason);
        json_.end_object();
    }

    void counts(std::string_view key, const std::vector<std::size_t>& counts) {
        json_.key(key).begin_array(one_line);
        for (const std::size_t count : counts) json_.integer(count);
        json_.end_array();
    }

    void staying(const StayingContext& context) {
        json_.begin_object(one_line).key("table");
        if (context.table)
            json_.string(grammar_.tables[*context.table]);
        else
            json_.null();
        json_.key("letter").string(grammar_.letters.name(context.letter));
        json_.key("left");
        write_word(json_, context.left, grammar_.letters);
        json_.key("right");
        write_word(json_, context.right, grammar_.letters);
        json_.key("outermost").boolean(context.outermost);
        json_.key("smallest").integer(context.smallest);
        json_.key("largest").integer(context.largest);
        json_.key("step").integer(static_cast<std::size_t>(context.step));
        json_.key("module").integer(context.module);
        json_.end_object();
    }

    void twin(const std::optional<IntervalTwin>& twin) {
        if (!twin) {
            json_.null();
            return;
        }
        json_.begin_object(one_line).key("arity").integer(twin->arity);
        json_.key("degree").integer(static_cast<std::size_t>(twin->degree));
        json_.key("moved").integer(twin->moved).end_object();
    }

    JsonWriter& json_;
    const PointGrammar& grammar_;
    LineIndex lines_;
};

} // namespace

std::string point_validation_json(const PointValidation& validation, const PointGrammar& grammar,
                                  const GrammarSourceText& source, const Generator& generator) {
    StringSink sink;
    JsonWriter json(sink);
    PointValidationWriter writer(json, grammar, source);
    json.begin_object();
    write_heading(json, "internode-point-validation", generator);
    writer.grammar();
    json.key("valid").boolean(validation.valid);
    json.key("dimension").integer(validation.dimension);
    writer.problems(validation.problems);
    writer.positions(validation.affine);
    writer.coverage(validation.coverage);
    writer.compilation(validation.compilation);
    json.key("mask");
    if (validation.mask)
        write_mask_facts(json, *validation.mask);
    else
        json.null();
    json.end_object().finish();
    return sink.text();
}

} // namespace internode
