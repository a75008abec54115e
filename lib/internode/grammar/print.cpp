// SPDX-License-Identifier: MIT

#include "internode/grammar/print.h"

#include "internode/grammar/intervals/print.h"
#include "internode/grammar/points/print_points.h"

namespace internode {

std::string print(const Grammar& grammar) {
    return std::visit([](const auto& one) { return print(one); }, grammar);
}

} // namespace internode
