// SPDX-License-Identifier: MIT

#include "internode/point/point_validation.h"

#include <algorithm>

namespace internode {

MaskFacts mask_facts(const UniformMask& mask) {
    MaskFacts facts;
    facts.mask = mask;
    facts.properties = mask_properties(mask);
    facts.known = known_schemes(mask);
    facts.smoothness = smoothness(mask);
    return facts;
}

PointValidation make_point_validation(const PointSystem& system, std::optional<CompilationFacts> compilation) {
    PointValidation validation;
    validation.affine = affine_findings(system);
    validation.coverage = coverage(system);
    validation.compilation = std::move(compilation);
    if (validation.compilation && validation.compilation->mask) {
        const UniformMask& mask = *validation.compilation->mask;
        const bool short_enough = mask.coefficients.size() <= max_validated_coefficients;
        if (mask.arity >= 2 && !mask.coefficients.empty() && short_enough) validation.mask = mask_facts(mask);
    }
    validation.valid = validation.coverage->ends_complete &&
                       std::ranges::all_of(validation.affine, is_sound, &AffineFinding::verdict);
    return validation;
}

PointValidation make_point_validation(std::vector<PointProblem> problems) {
    PointValidation validation;
    validation.problems = std::move(problems);
    return validation;
}

} // namespace internode
