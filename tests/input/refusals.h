// SPDX-License-Identifier: MIT
//
// What a settlement says, as one text; and the polygon of a text, for short tests.

#pragma once

#include "internode/input/polygon_file.h"
#include "internode/input/refusal.h"

#include <string>
#include <string_view>

#include <gtest/gtest.h>

namespace internode::tests {

template<typename Value>
std::string refusal_of(const Settled<Value>& settled) {
    EXPECT_EQ(settled.value.has_value(), settled.refusal.errors.empty());
    return settled.value ? "none" : to_string(settled.refusal.errors);
}

inline InputPolygon polygon(std::string_view text, std::string_view source = "p.json") {
    Settled<InputPolygon> settled = polygon_of_file(text, source);
    EXPECT_TRUE(settled.value) << text << refusal_of(settled);
    return settled.value ? *std::move(settled.value) : InputPolygon();
}

} // namespace internode::tests
