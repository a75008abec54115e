// SPDX-License-Identifier: MIT
//
// A function run on a stack of a size that the machine's settings do not change: what recurses too deep ends the test.

#pragma once

#include <cstddef>
#include <functional>
#include <system_error>

#include <pthread.h>

namespace internode::reference {

inline void run_on_stack(std::size_t bytes, std::function<void()> function) {
    const auto check = [](int error) {
        if (error != 0) throw std::system_error(error, std::generic_category());
    };
    pthread_attr_t attributes;
    check(::pthread_attr_init(&attributes));
    check(::pthread_attr_setstacksize(&attributes, bytes));
    const auto start = [](void* argument) -> void* {
        (*static_cast<std::function<void()>*>(argument))();
        return nullptr;
    };
    pthread_t thread{};
    check(::pthread_create(&thread, &attributes, start, &function));
    check(::pthread_join(thread, nullptr));
    (void)::pthread_attr_destroy(&attributes);
}

} // namespace internode::reference
