// SPDX-License-Identifier: MIT
//
// Reads version macros of the libraries, and is for that the one file outside their rooms that includes them.

#include "internode/version.h"

#include <Eigen/Core>
#include <e-antic/e-antic.h>
#include <flint/flint.h>
#include <fmt/core.h>
#include <gmp.h>
#include <nlohmann/detail/macro_scope.hpp>
#include <oneapi/tbb/version.h>

namespace internode {

std::string_view version() {
    return INTERNODE_VERSION;
}

std::string_view instruction_set() {
#if defined(__AVX2__)
    return "x86-64 with AVX2";
#elif defined(__x86_64__)
    return "x86-64";
#else
    return "other";
#endif
}

std::vector<LibraryVersion> library_versions() {
    return {
        {"e-antic", E_ANTIC_VERSION},
        {"Eigen", fmt::format("{}.{}.{}", EIGEN_WORLD_VERSION, EIGEN_MAJOR_VERSION, EIGEN_MINOR_VERSION)},
        {"FLINT", FLINT_VERSION},
        {"fmt", fmt::format("{}.{}.{}", FMT_VERSION / 10000, FMT_VERSION / 100 % 100, FMT_VERSION % 100)},
        {"GMP", gmp_version},
        {"nlohmann-json", fmt::format("{}.{}.{}", NLOHMANN_JSON_VERSION_MAJOR, NLOHMANN_JSON_VERSION_MINOR,
                                      NLOHMANN_JSON_VERSION_PATCH)},
        {"oneTBB", fmt::format("{}.{}.{}", TBB_VERSION_MAJOR, TBB_VERSION_MINOR, TBB_VERSION_PATCH)},
    };
}

} // namespace internode
