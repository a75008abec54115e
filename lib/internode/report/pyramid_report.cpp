// SPDX-License-Identifier: MIT

#include "internode/report/pyramid_report.h"

#include <utility>

namespace internode {

PyramidReport pyramid_report(Analysis analysis, Pyramid kept, const Fitting& fitting, const std::string& source,
                             int threads) {
    PyramidErrors errors = pyramid_errors(analysis, kept, threads);
    return {source, fitting, std::move(analysis), std::move(kept), std::move(errors)};
}

} // namespace internode
