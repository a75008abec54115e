// SPDX-License-Identifier: MIT

#include "internode/algebra/fraction.h"

#include <cassert>

namespace internode {

Rational fraction(const Integer& numerator, const Integer& denominator) {
    assert(denominator != 0);
    Rational value(numerator, denominator);
    value.canonicalize();
    return value;
}

bool is_canonical(const Rational& value) {
    return value.get_den() > 0 && gcd(value.get_num(), value.get_den()) == 1;
}

} // namespace internode
