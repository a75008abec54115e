// SPDX-License-Identifier: MIT

#include "internode/report/json/mask_facts_json.h"

#include "internode/report/json/json_parts.h"

#include <cassert>
#include <cmath>
#include <limits>

namespace internode {

namespace {

void write_rational(JsonWriter& json, const Rational& value) {
    write_number(json, Number(value), NumberField());
}

void write_rationals(JsonWriter& json, const std::vector<Rational>& values) {
    json.begin_array(one_line);
    for (const Rational& value : values) write_rational(json, value);
    json.end_array();
}

template<class Count>
void write_count(JsonWriter& json, std::string_view key, const std::optional<Count>& count) {
    json.key(key);
    if (count)
        json.integer(*count);
    else
        json.null();
}

void write_double(JsonWriter& json, std::string_view key, const std::optional<double>& value) {
    json.key(key);
    if (value && std::isfinite(*value))
        json.number(*value);
    else
        json.null();
}

/// Doubles on either side of the bounds.
void write_bounds(JsonWriter& json, const Rational& lower, const Rational& upper) {
    assert(lower <= upper);
    const double infinity = std::numeric_limits<double>::infinity();
    double below = to_double(lower);
    double above = to_double(upper);
    if (std::isfinite(below) && to_rational(below) > lower) below = std::nextafter(below, -infinity);
    if (std::isfinite(above) && to_rational(above) < upper) above = std::nextafter(above, infinity);
    json.begin_object(one_line);
    write_double(json, "lower", below);
    write_double(json, "upper", above);
    json.end_object();
}

std::string_view symmetry_name(MaskSymmetry symmetry) {
    switch (symmetry) {
    case MaskSymmetry::Odd:
        return "odd";
    case MaskSymmetry::Even:
        return "even";
    case MaskSymmetry::None:
        break;
    }
    return "none";
}

std::string_view family_name(SchemeFamily family) {
    switch (family) {
    case SchemeFamily::BSpline:
        return "b-spline";
    case SchemeFamily::LaneRiesenfeld:
        return "lane-riesenfeld";
    case SchemeFamily::Chaikin:
        return "chaikin";
    case SchemeFamily::CornerCutting:
        return "corner-cutting";
    case SchemeFamily::FourPoint:
        return "4-point";
    case SchemeFamily::SixPoint:
        return "6-point";
    case SchemeFamily::DeslauriersDubuc:
        return "deslauriers-dubuc";
    case SchemeFamily::DualInterpolation:
        break;
    }
    return "dual-interpolation";
}

std::string_view convergence_name(SchemeConvergence convergence) {
    switch (convergence) {
    case SchemeConvergence::Proved:
        return "proved";
    case SchemeConvergence::Refuted:
        return "refuted";
    case SchemeConvergence::NotDecided:
        break;
    }
    return "not-decided";
}

void write_difference(JsonWriter& json, const DifferenceScheme& scheme) {
    json.begin_object(one_line).key("order").integer(scheme.order);
    json.key("weights");
    write_rationals(json, scheme.coefficients);
    json.key("radius");
    write_bounds(json, scheme.radius.lower, scheme.radius.upper);
    json.key("positive").boolean(scheme.radius.positive);
    write_count(json, "contracts_after", scheme.radius.contracts_after);
    json.end_object();
}

void write_smoothness(JsonWriter& json, const Smoothness& smoothness) {
    json.begin_object().key("convergence").string(convergence_name(smoothness.convergence));
    json.key("reason").string(smoothness.reason);
    write_count(json, "derivatives", smoothness.derivatives);
    json.key("hoelder").begin_object(one_line);
    write_double(json, "lower", smoothness.holder_lower);
    write_double(json, "upper", smoothness.holder_upper);
    json.key("upper_is_proved").boolean(smoothness.upper_is_proved);
    json.end_object();
    json.key("differences").begin_array();
    for (const DifferenceScheme& scheme : smoothness.differences) write_difference(json, scheme);
    json.end_array().end_object();
}

void write_schemes(JsonWriter& json, const std::vector<KnownScheme>& known) {
    json.key("schemes").begin_array();
    for (const KnownScheme& scheme : known) {
        json.begin_object(one_line).key("family").string(family_name(scheme.family));
        json.key("parameters");
        write_rationals(json, scheme.parameters);
        json.key("name").string(scheme.name).end_object();
    }
    json.end_array();
}

} // namespace

void write_mask_facts(JsonWriter& json, const MaskFacts& facts) {
    const MaskProperties& properties = facts.properties;
    json.begin_object().key("arity").integer(facts.mask.arity);
    json.key("first").number(static_cast<double>(facts.mask.first));
    json.key("weights");
    write_rationals(json, facts.mask.coefficients);
    json.key("symbol").string(properties.symbol);
    json.key("factor_power").integer(properties.factor_power);
    json.key("quotient");
    write_rationals(json, properties.quotient);
    json.key("sums");
    write_rationals(json, properties.sums);
    write_count(json, "generation_degree", properties.generation_degree);
    write_count(json, "reproduction_degree", properties.reproduction_degree);
    json.key("shift");
    write_rational(json, properties.shift);
    json.key("interpolatory").boolean(properties.interpolatory);
    json.key("symmetry").string(symmetry_name(properties.symmetry));
    json.key("support");
    write_rationals(json, {properties.support_first, properties.support_last});
    write_schemes(json, facts.known);
    json.key("smoothness");
    if (facts.smoothness)
        write_smoothness(json, *facts.smoothness);
    else
        json.null();
    json.end_object();
}

} // namespace internode
