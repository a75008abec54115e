// SPDX-License-Identifier: MIT
//
// Every test executable adopts the locale of its environment, as a host program may (docs/promises.md, P7), before the
// first test. INTERNODE_EXPECTED_POINT names the decimal point that this locale must have, so that a locale that could
// not be adopted fails the run instead of passing it by.

#include <clocale>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <locale>

#ifdef INTERNODE_SANITIZED
#include <sanitizer/lsan_interface.h>
#endif

namespace {

bool adopt_locale() {
#ifdef INTERNODE_SANITIZED
    // glibc's newlocale never frees the list of folders that it makes from LOCPATH.
    const __lsan::ScopedDisabler forgiven;
#endif
    if (std::setlocale(LC_ALL, "") != nullptr) std::locale::global(std::locale(""));
    const char* expected = std::getenv("INTERNODE_EXPECTED_POINT");
    if (expected != nullptr && std::strcmp(std::localeconv()->decimal_point, expected) != 0) {
        std::fprintf(stderr, "the decimal point of this locale is not %s\n", expected);
        std::_Exit(1);
    }
    return true;
}

[[maybe_unused]] const bool adopted = adopt_locale();

} // namespace
