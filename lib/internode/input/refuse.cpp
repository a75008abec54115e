// SPDX-License-Identifier: MIT

#include "internode/input/refuse.h"

namespace internode {

namespace {

Refusal refusal_of(std::string message, std::string hint) {
    Diagnostic diagnostic;
    diagnostic.message = std::move(message);
    diagnostic.hint = std::move(hint);
    return {{std::move(diagnostic)}, false};
}

} // namespace

void refuse(std::string message, std::string hint) {
    throw Refused{refusal_of(std::move(message), std::move(hint))};
}

void refuse(std::vector<Diagnostic> errors) {
    assert(!errors.empty());
    throw Refused{{std::move(errors), false}};
}

void refuse_all(const std::string& source, const std::string& before, const std::vector<std::string>& problems,
                std::string hint) {
    assert(!problems.empty());
    std::vector<Diagnostic> errors;
    for (const std::string& problem : problems) {
        Diagnostic& error = errors.emplace_back();
        error.source = source;
        error.message = before + problem;
    }
    errors.back().hint = std::move(hint);
    refuse(std::move(errors));
}

void ask(std::string message, std::string hint) {
    Refusal refusal = refusal_of(std::move(message), std::move(hint));
    refusal.unsaid = true;
    throw Refused{std::move(refusal)};
}

} // namespace internode
